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
 * What vpDetectorCircleMarker refuses, and its files of settings.
 */

#include "detector_scenes.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <map>

#include <visp3/core/vpException.h>

using namespace detector_test;

namespace {
//! A file that is removed at the end.
class TestFile
{
public:
  TestFile()
      : m_name(std::string("testDetectorErrors-") + ::testing::UnitTest::GetInstance()->current_test_info()->name() +
               ".json")
  {
  }
  ~TestFile() { std::remove(m_name.c_str()); }
  void write(const std::string &text) const { std::ofstream(m_name) << text; }
  const std::string &name() const { return m_name; }

private:
  std::string m_name;
};

//! Code of the exception that a call throws; -1 without one.
template <class Call> int codeOf(const Call &call)
{
  try {
    call();
  }
  catch (const vpException &error) {
    EXPECT_FALSE(std::string(error.what()).empty());
    return error.getCode();
  }
  return -1;
}
} // namespace

TEST(DetectorErrors, ImagesTooSmallOrTooLarge)
{
  vpDetectorCircleMarker detector;
  std::vector<vpHomogeneousMatrix> cMo;
  for (const auto &[rows, columns] : {std::pair(0u, 0u), std::pair(1u, 1u), std::pair(15u, 16u), std::pair(16u, 15u),
                                      std::pair(1000u, 3u), std::pair(20u, 32768u), std::pair(32768u, 20u)}) {
    const vpImage<unsigned char> I(rows, columns);
    EXPECT_EQ(codeOf([&] { detector.detect(I); }), vpException::dimensionError) << rows << " x " << columns;
    EXPECT_EQ(codeOf([&] { detector.detect(I, size, straightCamera(), cMo); }), vpException::dimensionError);
  }
}

TEST(DetectorErrors, LongImages)
{
  // Edge pixels are kept as numbers of 16 bits.
  Random random = randomOfTest();
  const vpImage<unsigned char> marker =
      imageOf(printed(vpCircleMarkerFamily::GOLAY23, 5).setPose(randomPose(random, 100., 0.4, 320., 240.)), random);
  vpImage<unsigned char> I(height, 32767, 100);
  for (unsigned int v = 0; v < height; ++v) {
    std::copy(marker[v], marker[v] + width, I[v] + I.getWidth() - width);
  }
  vpDetectorCircleMarker detector;
  ASSERT_TRUE(detector.detect(I));
  EXPECT_EQ(detector.getMessage(0), "golay23 id: 5");
  EXPECT_NEAR(detector.getCenter(0).get_u(), I.getWidth() - width + 320., 1.);
}

TEST(DetectorErrors, SizesMustBePositive)
{
  TwoMarkers scene;
  vpDetectorCircleMarker detector;
  std::vector<vpHomogeneousMatrix> cMo;
  vpHomogeneousMatrix pose;
  ASSERT_TRUE(detector.detect(scene.I));
  for (const double wrong : {0., -0.1, std::nan(""), HUGE_VAL}) {
    EXPECT_EQ(codeOf([&] { detector.detect(scene.I, wrong, straightCamera(), cMo); }), vpException::badValue);
    EXPECT_EQ(codeOf([&] { detector.getPose(0, wrong, straightCamera(), pose); }), vpException::badValue);
    EXPECT_EQ(codeOf([&] { detector.setMarkerSizes({{1, 0.1}, {2, wrong}}); }), vpException::badValue);
  }
}

TEST(DetectorErrors, IndicesOutOfRange)
{
  TwoMarkers scene;
  vpDetectorCircleMarker detector;
  vpHomogeneousMatrix pose;
  for (const std::size_t index : {std::size_t(0), std::size_t(2), std::size_t(1000000), ~std::size_t(0)}) {
    EXPECT_EQ(codeOf([&] { detector.getPose(index, size, straightCamera(), pose); }), vpException::badValue);
    EXPECT_EQ(codeOf([&] { detector.getCenter(index); }), vpException::badValue);
    EXPECT_EQ(codeOf([&] { detector.getCovariance(index); }), vpException::badValue);
    EXPECT_EQ(codeOf([&] { detector.getLogOdds(index); }), vpException::badValue);
    EXPECT_EQ(codeOf([&] { detector.getMargin(index); }), vpException::badValue);
    EXPECT_EQ(codeOf([&] { detector.getHammingDistance(index); }), vpException::badValue);
    if (index == 0) {
      ASSERT_TRUE(detector.detect(scene.I)); // from now on 0 and 1 are there
      EXPECT_EQ(codeOf([&] { detector.getMargin(1); }), -1);
    }
  }
}

TEST(DetectorErrors, SettingsOutOfRange)
{
  vpDetectorCircleMarker detector;
  EXPECT_EQ(codeOf([&] { detector.setFamilies({}); }), vpException::badValue);
  for (const unsigned int wrong : {0u, 1025u, ~0u}) {
    EXPECT_EQ(codeOf([&] { detector.setNbThreads(wrong); }), vpException::badValue) << wrong;
  }
  for (const double wrong : {-0.01, 1.01, std::nan("")}) {
    EXPECT_EQ(codeOf([&] { detector.setMinimumMargin(wrong); }), vpException::badValue);
  }
  EXPECT_EQ(detector.getFamilies().size(), 1u);
}

// What is set, is read from a file or is refused is what the detector tells, and so does its copy.
TEST(DetectorErrors, SettingsAreTold)
{
  vpDetectorCircleMarker detector;
  EXPECT_TRUE(detector.getMarkerSizes().empty());
  EXPECT_EQ(detector.getMaximumHammingDistance(), 2u);
  EXPECT_EQ(detector.getMinimumMargin(), 0.6);
  EXPECT_EQ(detector.getNbThreads(), 1u);
  EXPECT_FALSE(detector.getTracking());
  EXPECT_EQ(detector.getFullSearchPeriod(), 10u);
  EXPECT_TRUE(detector.getRefinePose());
  const std::map<int, double> sizes{{-1, 0.1}, {4, 0.3}};
  detector.setMarkerSizes(sizes);
  detector.setMaximumHammingDistance(1);
  detector.setMinimumMargin(0.75);
  detector.setNbThreads(3);
  detector.setTracking(true, 5);
  detector.setRefinePose(false);
  EXPECT_THROW(detector.setMinimumMargin(2.), vpException);
  EXPECT_THROW(detector.setNbThreads(0), vpException);
  EXPECT_THROW(detector.setTracking(false, 0), vpException);
  const vpDetectorCircleMarker copy(detector);
  EXPECT_EQ(copy.getMarkerSizes(), sizes);
  EXPECT_EQ(copy.getMaximumHammingDistance(), 1u);
  EXPECT_EQ(copy.getMinimumMargin(), 0.75);
  EXPECT_EQ(copy.getNbThreads(), 3u);
  EXPECT_TRUE(copy.getTracking());
  EXPECT_EQ(copy.getFullSearchPeriod(), 5u);
  EXPECT_FALSE(copy.getRefinePose());
}

TEST(DetectorErrors, ConfigurationFiles)
{
  TestFile file;
  vpDetectorCircleMarker detector(vpCircleMarkerFamily::BCH31);
  detector.setFamilies({vpCircleMarkerFamily::BCH31, vpCircleMarkerFamily::GOLAY23});
  detector.setMarkerSizes({{9, 0.09}});
  detector.setZAlignedWithCameraAxis(true);
  detector.saveConfigFile(file.name());
  vpDetectorCircleMarker loaded;
  loaded.loadConfigFile(file.name());
  ASSERT_EQ(loaded.getFamilies().size(), 2u);
  EXPECT_EQ(loaded.getFamilies()[0].getType(), vpCircleMarkerFamily::BCH31);
  EXPECT_EQ(loaded.getFamilies()[1].getType(), vpCircleMarkerFamily::GOLAY23);
  // The settings act: both detectors see the same.
  TwoMarkers scene;
  std::vector<vpHomogeneousMatrix> expected, found;
  ASSERT_TRUE(detector.detect(scene.I, size, straightCamera(), expected));
  ASSERT_TRUE(loaded.detect(scene.I, size, straightCamera(), found));
  ASSERT_EQ(found.size(), 2u);
  EXPECT_DOUBLE_EQ(loaded.getDetections()[1].size, 0.09);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(differenceOf(expected[i], found[i]), 0.);
    EXPECT_GT(found[i][2][2], 0.);
  }
}

// What setters take, a file must hold as well.
TEST(DetectorErrors, ConfigurationFilesHoldWhatSettersTake)
{
  TestFile file;
  vpDetectorCircleMarker detector;
  detector.setTracking(true, 100000);
  detector.setNbThreads(1024);
  detector.setMaximumHammingDistance(5000);
  detector.setMarkerSizes({{-1, 0.1}, {0, 0.2}, {999999999, 0.3}});
  detector.saveConfigFile(file.name());
  vpDetectorCircleMarker loaded;
  EXPECT_EQ(codeOf([&] { loaded.loadConfigFile(file.name()); }), -1);
  for (const int id : {-2, 1000000000}) {
    EXPECT_EQ(codeOf([&] { detector.setMarkerSizes({{id, 0.1}}); }), vpException::badValue) << id;
  }
}

TEST(DetectorErrors, WrongConfigurationChangesNothing)
{
  TestFile file;
  for (const char *text :
       {"{\"families\": [\"ring\"], \"colour\": 3}", "{\"families\": []}",
        "{\"families\": [\"ring\"], \"sizes\": {\"3\": -0.1}}", "{\"families\": [\"ring\"], \"minimumMargin\": 2}",
        "{\"families\": [\"ring\"], \"threads\": 0}", "{\"families\": [\"ring\"], \"threads\": -1}",
        "{\"families\": [\"ring\"], \"threads\": 1025}", "{\"families\": [\"ring\"], \"fullSearchPeriod\": 4294967296}",
        "{"}) {
    file.write(text);
    vpDetectorCircleMarker detector;
    EXPECT_EQ(codeOf([&] { detector.loadConfigFile(file.name()); }), vpException::badValue) << text;
    ASSERT_EQ(detector.getFamilies().size(), 1u) << text;
    EXPECT_EQ(detector.getFamilies()[0].getType(), vpCircleMarkerFamily::GOLAY23) << text;
  }
  file.write("{\"colour\": 3}");
  try {
    vpDetectorCircleMarker().loadConfigFile(file.name());
    FAIL();
  }
  catch (const vpException &error) {
    EXPECT_NE(std::string(error.what()).find("colour"), std::string::npos) << error.what();
  }
  EXPECT_EQ(codeOf([] { vpDetectorCircleMarker().loadConfigFile("no-such-file.json"); }), vpException::ioError);
  EXPECT_EQ(codeOf([] { vpDetectorCircleMarker().saveConfigFile("no-such-folder/x.json"); }), vpException::ioError);
}
