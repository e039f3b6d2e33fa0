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
 * Tests: the marker database, its file and its errors.
 */

#include "testRoomTools.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <regex>

#include <visp3/circle_marker/vpCircleMarkerDatabase.h>
#include <visp3/core/vpException.h>
#include <visp3/core/vpPoseVector.h>

#include "support/json_lines.h"
#include "support/same_family.h"

using namespace circle_marker;
using namespace room_test;

namespace {
vpCircleMarkerEntry entryOf(const vpCircleMarkerFamily &family, int id)
{
  vpCircleMarkerEntry entry;
  entry.family = family;
  entry.id = id;
  entry.size = 0.18;
  return entry;
}
} // namespace

TEST(CircleMarkerDatabase, FindsByFamilyAndId)
{
  vpCircleMarkerDatabase database;
  vpCircleMarkerEntry door = entryOf(vpCircleMarkerFamily::GOLAY23, 5);
  door.name = "door";
  database.add(door);
  database.add(entryOf(vpCircleMarkerFamily::BCH31, 5));
  database.add(entryOf(vpCircleMarkerFamily::DISC, -1));
  ASSERT_NE(database.find(vpCircleMarkerFamily::GOLAY23, 5), nullptr);
  EXPECT_EQ(database.find(vpCircleMarkerFamily::GOLAY23, 5)->name, "door");
  EXPECT_EQ(database.find(vpCircleMarkerFamily::BCH31, 5)->name, "");
  EXPECT_NE(database.find(vpCircleMarkerFamily::DISC, -1), nullptr);
  EXPECT_EQ(database.find(vpCircleMarkerFamily::GOLAY23, 6), nullptr);
  EXPECT_EQ(database.find(vpCircleMarkerFamily::RING, -1), nullptr);
}

TEST(CircleMarkerDatabase, RefusesWhatCannotBe)
{
  vpCircleMarkerDatabase database;
  database.add(entryOf(vpCircleMarkerFamily::GOLAY23, 5));
  EXPECT_THROW(database.add(entryOf(vpCircleMarkerFamily::GOLAY23, 5)), vpException);
  EXPECT_THROW(database.add(entryOf(vpCircleMarkerFamily::GOLAY23, 178)), vpException);
  EXPECT_THROW(database.add(entryOf(vpCircleMarkerFamily::RING, 0)), vpException);
  vpCircleMarkerEntry flat = entryOf(vpCircleMarkerFamily::GOLAY23, 6);
  flat.size = 0.;
  EXPECT_THROW(database.add(flat), vpException);
  EXPECT_EQ(database.getEntries().size(), 1u);
}

#ifdef VISP_CIRCLE_MARKER_HAVE_JSON
namespace {
//! A file of the running test that is removed at the end.
class TestFile
{
public:
  TestFile()
      : m_name(std::string("testCircleMarkerDatabase-") +
               ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".json")
  {
  }
  ~TestFile() { std::remove(m_name.c_str()); }

  void write(const std::string &text) const { std::ofstream(m_name) << text; }
  const std::string &name() const { return m_name; }

private:
  std::string m_name;
};

//! The message with which a text is refused, or "".
std::string complaintAbout(const std::string &text)
{
  TestFile file;
  file.write(text);
  vpCircleMarkerDatabase database;
  try {
    database.load(file.name());
  }
  catch (const vpException &error) {
    EXPECT_EQ(error.getCode(), vpException::badValue);
    return error.what();
  }
  return "";
}

//! A file of one good marker, and the text as that of another one on the lines 4 and 5.
std::string withMarker(const std::string &text)
{
  return "{\n  \"markers\": [\n    {\"family\": \"bch31\", \"id\": 1, \"size\": 0.1},\n" + text + "\n  ]\n}\n";
}
} // namespace

// A ring of its own ratio, or a print with other radii, is another marker than that of the name.
TEST(CircleMarkerDatabase, FilesHoldTheRadiiOfTheFamily)
{
  vpCircleMarkerLayout thin = vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23).getLayout();
  thin.ringInner = 0.85;
  vpCircleMarkerDatabase database;
  database.add(entryOf(vpCircleMarkerFamily::ring(0.65), -1));
  database.add(entryOf(vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23).withLayout(thin), 5));
  database.add(entryOf(vpCircleMarkerFamily::BCH31, 7));
  TestFile file;
  database.save(file.name());
  vpCircleMarkerDatabase loaded;
  loaded.load(file.name());
  ASSERT_EQ(loaded.getEntries().size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(isSameFamily(loaded.getEntries()[i].family, database.getEntries()[i].family)) << i;
  }
  // By the family, that is: each of the others is well.
  const auto complaintAboutFamily = [](const std::string &family) {
    return complaintAbout("{\"markers\": [\n{\"family\": " + family + ", \"size\": 0.18}]}");
  };
  EXPECT_EQ(complaintAboutFamily("{\"name\": \"ring\", \"ratio\": 0.65}"), "");
  for (const char *family : {"{\"name\": \"ring\", \"ratio\": \"wide\"}", "{\"name\": \"ring\", \"ratio\": 2}",
                             "{\"ratio\": 0.65}", "{\"name\": \"ringed\"}", "[\"ring\"]"}) {
    EXPECT_NE(complaintAboutFamily(family).find("line 2"), std::string::npos) << family;
  }
}

TEST(CircleMarkerDatabase, WrittenAndReadAgain)
{
  Random random = randomOfTest();
  vpCircleMarkerDatabase database;
  for (int id = 0; id < 20; ++id) {
    vpCircleMarkerEntry entry = entryOf(vpCircleMarkerFamily::GOLAY23, id);
    entry.size = uniform(random, 0.01, 2.);
    entry.name = id % 2 == 0 ? "" : "name \"" + std::to_string(id) + "\"\n\u00e9";
    entry.isPayloadJson = id % 3 == 0;
    entry.payload = id % 3 == 0 ? "{\"to\":[1,2.5],\"task\":\"go\"}" : (id % 3 == 1 ? "" : "left\tright");
    if (id % 4 != 0) {
      vpPoseVector pose;
      for (unsigned int i = 0; i < 6; ++i) {
        pose[i] = uniform(random, -1.5, 1.5);
      }
      entry.wMo = vpHomogeneousMatrix(pose);
    }
    database.add(entry);
  }
  TestFile file;
  database.save(file.name());
  vpCircleMarkerDatabase again;
  again.add(entryOf(vpCircleMarkerFamily::BCH31, 7)); // forgotten by load()
  again.load(file.name());
  ASSERT_EQ(again.getEntries().size(), database.getEntries().size());
  for (std::size_t i = 0; i < again.getEntries().size(); ++i) {
    const vpCircleMarkerEntry &a = again.getEntries()[i], &d = database.getEntries()[i];
    EXPECT_EQ(a.id, d.id);
    EXPECT_EQ(a.size, d.size);
    EXPECT_EQ(a.name, d.name);
    EXPECT_EQ(a.isPayloadJson, d.isPayloadJson);
    EXPECT_EQ(a.isPayloadJson ? nlohmann::json::parse(a.payload) : nlohmann::json(a.payload),
              d.isPayloadJson ? nlohmann::json::parse(d.payload) : nlohmann::json(d.payload));
    ASSERT_EQ(a.wMo.has_value(), d.wMo.has_value());
    for (unsigned int k = 0; a.wMo && k < 16; ++k) {
      EXPECT_NEAR(a.wMo->data[k], d.wMo->data[k], 1e-12);
    }
  }
}

TEST(CircleMarkerDatabase, ErrorsNameTheLineAndWhatToDo)
{
  struct Case
  {
    const char *text;
    unsigned int line;
    const char *words;
  };
  const Case cases[] = {
      {"    {\"family\": \"golay23\", \"id\": 5, \"size\": 0.18", 5, "syntax error"},
      {"    {\"family\": \"golay24\",\n \"id\": 5, \"size\": 0.18}", 4, "golay24"},
      {"    {\"family\": \"golay23\",\n \"id\": 1.5, \"size\": 0.18}", 5, "whole number"},
      {"    {\"family\": \"golay23\",\n \"id\": 5\n,\"size\": -1\n}", 6, "positive"},
      {"    {\"family\": \"golay23\",\n \"id\": 5\n,\"size\":\n0\n}", 7, "positive"},
      {"    {\"family\": \"golay23\",\n \"id\": 5, \"size\": \"0.18\"}", 5, "outer diameter"},
      {"    {\"family\": \"golay23\", \"id\": 178, \"size\": 0.18}", 4, "177"},
      {"    {\"family\": \"golay23\",\n \"size\": 0.18}", 4, "without \"id\""},
      {"    {\"family\": \"golay23\",\n \"id\": 3}", 4, "without \"size\""},
      {"    {\"family\": \"golay23\", \"id\": 3,\n \"pose\": [0, 0, 1], \"size\": 0.1}", 5, "six numbers"},
      {"    {\"family\": \"golay23\", \"id\": 3,\n \"pose\": [0, 0, 1, 0, 0,\n\"a\"], \"size\": 0.1}", 6,
       "six numbers"},
      {"    {\"family\": \"golay23\", \"id\": 3,\n \"nam\": \"door\", \"size\": 0.1}", 5, "unknown key \"nam\""},
      {"    {\"family\": \"golay23\", \"id\": 3,\n \"name\": 4, \"size\": 0.1}", 5, "text"},
      {"    {\"family\": \"golay23\", \"id\": 3,\n \"id\": 4, \"size\": 0.1}", 5, "twice"},
      {"    {\"family\": \"bch31\", \"id\": 1, \"size\": 0.2}", 4, "twice"},
      {"    {\"family\": \"ring\", \"id\": 1, \"size\": 0.2}", 4, "no ids"},
      {"    17", 4, "object"},
  };
  for (const Case &c : cases) {
    const std::string text = withMarker(c.text);
    const std::string complaint = complaintAbout(text);
    EXPECT_NE(complaint.find("line " + std::to_string(c.line) + ":"), std::string::npos) << complaint << "\n" << text;
    EXPECT_NE(complaint.find(c.words), std::string::npos) << complaint << "\n" << text;
    EXPECT_NE(complaint.find(".json"), std::string::npos) << complaint;
  }
}

TEST(CircleMarkerDatabase, ListsInListsHaveAnEnd)
{
  const auto nested = [](std::size_t depth) {
    return withMarker("    {\"family\": \"golay23\", \"id\": 3, \"size\": 0.1, \"payload\": " +
                      std::string(depth, '[') + std::string(depth, ']') + "}");
  };
  EXPECT_EQ(complaintAbout(nested(90)), "");
  EXPECT_NE(complaintAbout(nested(200)).find("nested"), std::string::npos);
  EXPECT_NE(complaintAbout(nested(300000)).find("nested"), std::string::npos);
}

TEST(CircleMarkerDatabase, WhatCannotBeWrittenIsNamed)
{
  vpCircleMarkerEntry latin = entryOf(vpCircleMarkerFamily::GOLAY23, 5);
  latin.name = "caf\xe9"; // not UTF-8
  vpCircleMarkerDatabase database;
  database.add(latin);
  try {
    database.save("testCircleMarkerDatabase-cannot.json");
    ADD_FAILURE() << "it was written";
  }
  catch (const vpException &e) {
    EXPECT_EQ(e.getCode(), vpException::badValue);
    EXPECT_NE(std::string(e.what()).find("golay23 id 5"), std::string::npos) << e.what();
  }
  EXPECT_FALSE(std::ifstream("testCircleMarkerDatabase-cannot.json").good());
}

// Where it is added, not hours later, when what was collected is saved.
TEST(CircleMarkerDatabase, PayloadsThatAreNotTheirJsonAreRefused)
{
  vpCircleMarkerDatabase database;
  vpCircleMarkerEntry entry = entryOf(vpCircleMarkerFamily::GOLAY23, 5);
  entry.isPayloadJson = true;
  entry.payload = "{not json";
  try {
    database.add(entry);
    ADD_FAILURE() << "it was added";
  }
  catch (const vpException &e) {
    EXPECT_EQ(e.getCode(), vpException::badValue);
    EXPECT_NE(std::string(e.what()).find("golay23 id 5"), std::string::npos) << e.what();
  }
  EXPECT_TRUE(database.getEntries().empty());
  entry.payload = "{\"room\": 5}";
  EXPECT_NO_THROW(database.add(entry));
}

TEST(CircleMarkerDatabase, RefusesOtherFiles)
{
  for (const char *text :
       {"", "[]", "{}", "{\"markers\": 5}", "{\"markers\": [], \"more\": 1}", "{\"markers\": []} x"}) {
    EXPECT_NE(complaintAbout(text).find("line 1:"), std::string::npos) << text;
  }
  EXPECT_EQ(complaintAbout("{\"markers\": []}"), "");
  EXPECT_THROW(vpCircleMarkerDatabase().load("there-is-no-such-file.json"), vpException);
  EXPECT_THROW(vpCircleMarkerDatabase().save("there-is-no-such-folder/file.json"), vpException);
  try {
    vpCircleMarkerDatabase().load(".");
    FAIL() << "read a folder";
  }
  catch (const vpException &e) {
    EXPECT_EQ(e.getCode(), vpException::ioError);
  }
}

TEST(CircleMarkerDatabase, LinksAndDevicesStayWhatTheyAre)
{
  namespace fs = std::filesystem;
  TestFile file;
  file.write("{}");
  const std::string link = file.name() + ".link";
  fs::remove(link);
  fs::create_symlink(file.name(), link);
  vpCircleMarkerDatabase database;
  database.add(entryOf(vpCircleMarkerFamily::GOLAY23, 5));
  database.save(link);
  EXPECT_TRUE(fs::is_symlink(link));
  vpCircleMarkerDatabase again;
  again.load(file.name());
  EXPECT_EQ(again.getEntries().size(), 1u);
  fs::remove(link);
  fs::create_symlink("/dev/null", link);
  database.save(link);
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  fs::remove(link);
}

TEST(CircleMarkerDatabase, AFileThatCannotBeUsedChangesNothing)
{
  TestFile file;
  file.write("{\"markers\": [{}]}");
  vpCircleMarkerDatabase database;
  database.add(entryOf(vpCircleMarkerFamily::GOLAY23, 5));
  EXPECT_THROW(database.load(file.name()), vpException);
  EXPECT_NE(database.find(vpCircleMarkerFamily::GOLAY23, 5), nullptr);
}

TEST(CircleMarkerDatabase, DamagedFilesAreRefusedAndNeverMore)
{
  const std::string good =
      "{\n \"markers\": [\n  {\"family\": \"golay23\", \"id\": 5, \"size\": 0.18, \"name\": \"door\", "
      "\"payload\": {\"task\": \"go\"},\n   \"pose\": [1, 0, 2.5, 0, 1.5, 0]}\n ]\n}\n";
  ASSERT_EQ(complaintAbout(good), "");
  Random random = randomOfTest();
  for (int i = 0; i < 3000; ++i) {
    std::string text = good;
    for (int k = 0; k < 3; ++k) {
      const auto place = static_cast<std::size_t>(uniform(random, 0., static_cast<double>(text.size())));
      text[place] = static_cast<char>(uniform(random, -128., 128.));
    }
    const std::string complaint = complaintAbout(text); // nothing but a vpException that names a line
    EXPECT_TRUE(complaint.empty() || std::regex_search(complaint, std::regex("line [1-7]:"))) << complaint;
  }
}
#endif
