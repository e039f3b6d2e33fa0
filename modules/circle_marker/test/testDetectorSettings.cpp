/*
 * Circular fiducial markers for ViSP, the Visual Servoing Platform.
 *
 * This software is free software; you can redistribute it and/or modify
 * it under the terms of the GNU General Public License as published by
 * the Free Software Foundation; either version 2 of the License, or
 * (at your option) any later version.
 * See the file LICENSE at the root directory of this source
 * distribution for additional information about the GNU GPL.
 *
 * This file is provided AS IS with NO WARRANTY OF ANY KIND, INCLUDING THE
 * WARRANTY OF DESIGN, MERCHANTABILITY AND FITNESS FOR A PARTICULAR PURPOSE.
 *
 * Description:
 * Settings in JSON files: what is written is read, what is wrong is named.
 */

#include "testRoomTools.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <visp3/core/vpException.h>

#include "detector_settings.h"

using namespace circle_marker;
using namespace room_test;

#ifdef VISP_CIRCLE_MARKER_HAVE_JSON
namespace {
//! A file of the running test that is removed at the end.
class TestFile
{
public:
  TestFile()
      : m_name(std::string("testDetectorSettings-") + ::testing::UnitTest::GetInstance()->current_test_info()->name() +
               ".json")
  {
  }
  ~TestFile() { std::remove(m_name.c_str()); }

  void write(const std::string &text) const { std::ofstream(m_name) << text; }
  std::string text() const
  {
    std::stringstream stream;
    stream << std::ifstream(m_name).rdbuf();
    return stream.str();
  }
  const std::string &name() const { return m_name; }

private:
  std::string m_name;
};

DetectorSettings defaults()
{
  DetectorSettings settings;
  settings.families = {vpCircleMarkerFamily::GOLAY23};
  return settings;
}

//! The message with which reading a text fails, or "".
std::string complaintAbout(const std::string &text)
{
  TestFile file;
  file.write(text);
  try {
    readSettings(file.name(), defaults());
  }
  catch (const vpException &error) {
    EXPECT_EQ(error.getCode(), vpException::badValue);
    return error.what();
  }
  return "";
}
} // namespace

TEST(DetectorSettings, WrittenAndReadAgain)
{
  DetectorSettings settings;
  settings.families = {vpCircleMarkerFamily::BCH31, vpCircleMarkerFamily::DISC};
  settings.sizes = {{3, 0.125}, {2113, 0.04}};
  settings.decode.maximumHamming = 1;
  settings.decode.minimumMargin = 0.72;
  settings.refinePose = false;
  settings.zAlignedWithCameraAxis = true;
  settings.polarity = vpCircleMarkerPolarity::WHITE_ON_BLACK;
  settings.threads = 3;
  settings.cameraCovariance.diagonal() << 4., 4., 0.25, 0.36;
  settings.cameraCovariance(0, 1) = settings.cameraCovariance(1, 0) = 3.9;
  TestFile file;
  writeSettings(file.name(), settings);
  const DetectorSettings read = readSettings(file.name(), defaults());
  ASSERT_EQ(read.families.size(), 2u);
  EXPECT_EQ(read.families[0].getType(), vpCircleMarkerFamily::BCH31);
  EXPECT_EQ(read.families[1].getType(), vpCircleMarkerFamily::DISC);
  EXPECT_EQ(read.sizes, settings.sizes);
  EXPECT_EQ(read.decode.maximumHamming, 1u);
  EXPECT_EQ(read.decode.minimumMargin, 0.72);
  EXPECT_FALSE(read.refinePose);
  EXPECT_TRUE(read.zAlignedWithCameraAxis);
  EXPECT_EQ(read.polarity, vpCircleMarkerPolarity::WHITE_ON_BLACK);
  EXPECT_EQ(read.threads, 3u);
  EXPECT_EQ(read.cameraCovariance, settings.cameraCovariance);
}

TEST(DetectorSettings, WhatIsNoCovarianceOfTheCameraIsRefused)
{
  const char *start = "{\"cameraCovariance\": ";
  for (const char *matrix : {"3", "[]", "[[1, 0, 0, 0]]", "[[1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, 0]]",
                             "[[1, 0, 0, 0], [0, -1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]",
                             "[[1, 0.5, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]",
                             "[[1, 2, 0, 0], [2, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]",
                             "[[\"a\", 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]"}) {
    EXPECT_NE(complaintAbout(std::string(start) + matrix + "}"), "") << matrix;
  }
  // As four calibrations of one focal length give it: singular.
  EXPECT_EQ(complaintAbout(std::string(start) + "[[4, 4, 0, 0], [4, 4, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]}"), "");
}

TEST(DetectorSettings, TheRatioOfARingIsKept)
{
  DetectorSettings settings = defaults();
  settings.families = {vpCircleMarkerFamily::ring(0.65)};
  TestFile file;
  writeSettings(file.name(), settings);
  const DetectorSettings read = readSettings(file.name(), defaults());
  ASSERT_EQ(read.families.size(), 1u);
  EXPECT_EQ(read.families[0].getType(), vpCircleMarkerFamily::RING);
  EXPECT_DOUBLE_EQ(read.families[0].getLayout().ringInner, 0.65);
}

TEST(DetectorSettings, ALayoutOfOnesOwnIsKept)
{
  DetectorSettings settings = defaults();
  vpCircleMarkerLayout layout;
  layout.ringInner = 0.75;
  layout.codeOuter = 0.65;
  layout.codeInner = 0.35;
  layout.quietZone = 0.2;
  vpCircleMarkerLayout wideRing = vpCircleMarkerFamily::ring(0.65).getLayout();
  wideRing.quietZone = 0.3;
  settings.families = {vpCircleMarkerFamily(vpCircleMarkerFamily::BCH31).withLayout(layout),
                       vpCircleMarkerFamily(vpCircleMarkerFamily::RING).withLayout(wideRing)};
  TestFile file;
  writeSettings(file.name(), settings);
  const DetectorSettings read = readSettings(file.name(), defaults());
  ASSERT_EQ(read.families.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const vpCircleMarkerLayout &expected = settings.families[i].getLayout();
    EXPECT_EQ(read.families[i].getType(), settings.families[i].getType());
    EXPECT_EQ(read.families[i].getLayout().ringInner, expected.ringInner);
    EXPECT_EQ(read.families[i].getLayout().codeOuter, expected.codeOuter);
    EXPECT_EQ(read.families[i].getLayout().codeInner, expected.codeInner);
    EXPECT_EQ(read.families[i].getLayout().quietZone, expected.quietZone);
  }
}

TEST(DetectorSettings, WhatIsNotNamedStays)
{
  TestFile file;
  file.write("{\"minimumMargin\": 0.5}");
  DetectorSettings before = defaults();
  before.sizes = {{4, 0.3}};
  before.threads = 2;
  before.refinePose = false;
  const DetectorSettings read = readSettings(file.name(), before);
  EXPECT_EQ(read.decode.minimumMargin, 0.5);
  EXPECT_EQ(read.sizes, before.sizes);
  EXPECT_EQ(read.threads, 2u);
  EXPECT_FALSE(read.refinePose);
  EXPECT_EQ(read.families[0].getType(), vpCircleMarkerFamily::GOLAY23);
}

TEST(DetectorSettings, UnknownKeysAreNamed)
{
  const std::string complaint = complaintAbout("{\"minimumMargin\": 0.5, \"minimunMargin\": 0.5}");
  EXPECT_NE(complaint.find("minimunMargin"), std::string::npos) << complaint;
  EXPECT_NE(complaint.find("maximumHammingDistance"), std::string::npos)
      << "does not list the known keys: " << complaint;
  EXPECT_NE(complaint.find(".json"), std::string::npos) << "does not name the file: " << complaint;
}

TEST(DetectorSettings, WrongContentsAreRefused)
{
  for (const char *text : {"",
                           "{",
                           "not json",
                           "[1, 2]",
                           "3",
                           "\"families\"",
                           "null",
                           "{\"families\": 3}",
                           "{\"families\": [\"golay24\"]}",
                           "{\"sizes\": {\"three\": 0.1}}",
                           "{\"sizes\": {\"3\": \"large\"}}",
                           "{\"sizes\": [0.1, 0.2]}",
                           "{\"sizes\": {\"3x\": 0.1}}",
                           "{\"sizes\": {\"3\": 0.1, \"03\": 0.2}}",
                           "{\"sizes\": {\"3\": 0.1, \"3\": 0.2}}",
                           "{\"sizes\": {\"-7\": 0.1}}",
                           "{\"sizes\": {\"3\": -0.1}}",
                           "{\"threads\": 1, \"threads\": 4}",
                           "{\"families\": []}",
                           "{\"threads\": 0}",
                           "{\"minimumMargin\": 1.01}",
                           "{\"minimumMargin\": -0.01}",
                           "{\"families\": [{\"name\": \"disc\", \"ratio\": 0.5}]}",
                           "{\"families\": [{\"name\": \"ring\"}]}",
                           "{\"families\": [{\"name\": \"ring\", \"ratio\": 1.5}]}",
                           "{\"threads\": -1}",
                           "{\"threads\": 1.5}",
                           "{\"maximumHammingDistance\": -1}",
                           "{\"maximumHammingDistance\": \"2\"}",
                           "{\"minimumMargin\": \"high\"}",
                           "{\"families\": [{\"name\": \"golay23\", \"layout\": {\"ringInner\": 0.8}}]}",
                           "{\"families\": [{\"name\": \"golay23\", \"ratio\": 0.7}]}",
                           "{\"refinePose\": 1}",
                           "{\"polarity\": \"white\"}",
                           "{\"zAlignedWithCameraAxis\": \"yes\"}"}) {
    EXPECT_NE(complaintAbout(text), "") << text;
  }
  EXPECT_EQ(complaintAbout("{}"), "");
}

// The JSON library tells of types alone.
TEST(DetectorSettings, ValuesOfAnotherTypeAreNamedWithTheirKey)
{
  const std::string complaint = complaintAbout("{\"threads\": 2, \"refinePose\": 17}");
  EXPECT_NE(complaint.find("refinePose"), std::string::npos) << complaint;
  EXPECT_NE(complaint.find("17"), std::string::npos) << complaint;
}

TEST(DetectorSettings, UnknownFamiliesAreNamed)
{
  const std::string complaint = complaintAbout("{\"families\": [\"ring\", \"golay24\"]}");
  EXPECT_NE(complaint.find("golay24"), std::string::npos) << complaint;
  EXPECT_NE(complaint.find("golay23"), std::string::npos) << "does not say what exists: " << complaint;
}

TEST(DetectorSettings, FilesThatCannotBeUsed)
{
  try {
    readSettings("no-such-folder/settings.json", defaults());
    FAIL() << "read a file that is not there";
  }
  catch (const vpException &error) {
    EXPECT_EQ(error.getCode(), vpException::ioError);
    EXPECT_NE(std::string(error.what()).find("no-such-folder/settings.json"), std::string::npos);
  }
  try {
    readSettings(".", defaults());
    FAIL() << "read a folder";
  }
  catch (const vpException &error) {
    EXPECT_EQ(error.getCode(), vpException::ioError);
  }
  try {
    writeSettings("no-such-folder/settings.json", defaults());
    FAIL() << "wrote into a folder that is not there";
  }
  catch (const vpException &error) {
    EXPECT_EQ(error.getCode(), vpException::ioError);
  }
}

TEST(DetectorSettings, NothingIsLeftBesideTheFile)
{
  TestFile file;
  file.write("old");
  writeSettings(file.name(), defaults());
  EXPECT_NE(file.text().find("golay23"), std::string::npos);
  EXPECT_EQ(file.text().find("old"), std::string::npos);
  const std::filesystem::path path = std::filesystem::absolute(file.name());
  for (const auto &entry : std::filesystem::directory_iterator(path.parent_path())) {
    EXPECT_NE(entry.path().filename().string().rfind(path.filename().string() + ".part", 0), 0u) << entry.path();
  }
}

TEST(DetectorSettings, LinksAndDevicesStayWhatTheyAre)
{
  namespace fs = std::filesystem;
  TestFile file;
  file.write("old");
  const std::string link = file.name() + ".link";
  fs::remove(link);
  fs::create_symlink(file.name(), link);
  writeSettings(link, defaults());
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_NE(file.text().find("golay23"), std::string::npos) << "what the link names was not written";
  fs::remove(link);
  writeSettings("/dev/null", defaults());
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}
#else
TEST(DetectorSettings, WithoutTheLibraryTheUserIsTold)
{
  try {
    writeSettings("settings.json", DetectorSettings());
    FAIL();
  }
  catch (const vpException &error) {
    EXPECT_EQ(error.getCode(), vpException::functionNotImplementedError);
    EXPECT_NE(std::string(error.what()).find("nlohmann"), std::string::npos);
  }
}
#endif
