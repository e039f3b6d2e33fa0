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
 * Black-box tests of circle-marker-accuracy: its files, its figures, its page, its errors.
 */

#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "../create/csv_rows.h"
#include "../create/run_program.h"

using namespace test;

namespace {
const bool hasGnuplot = std::string(GNUPLOT) != "";

double number(const Row &row, const std::string &column)
{
  const std::string &text = row.at(column);
  return text.empty() ? std::nan("") : std::stod(text);
}

/*! One image of everything, made once. */
class Accuracy : public ::testing::Test
{
protected:
  static void SetUpTestSuite()
  {
    folder = std::filesystem::path(CIRCLE_MARKER_TEST_DIR) / "Accuracy";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    outcome =
        run(CIRCLE_MARKER_ACCURACY, {"--output", "results", "--page", "page", "--frames", "1", "--seed", "3"}, folder);
    rows = rowsOf(contentOf(folder / "results" / "accuracy.csv"));
    json = nlohmann::json::parse(contentOf(folder / "results" / "accuracy.json"), nullptr, false);
  }

  void SetUp() override
  {
    ASSERT_FALSE(rows.empty()) << outcome.err;
    ASSERT_FALSE(json.is_discarded());
  }

  static inline std::filesystem::path folder;
  static inline Outcome outcome;
  static inline std::vector<Row> rows;
  static inline nlohmann::json json;
};
} // namespace

TEST_F(Accuracy, MakesWhatWasAskedFor)
{
  EXPECT_EQ(outcome.status, hasGnuplot ? 0 : 1) << outcome.err;
  EXPECT_EQ(filesIn(folder / "results"), (std::vector<std::string>{"accuracy.csv", "accuracy.json"}));
  std::map<std::string, int> count;
  for (const Row &row : rows) {
    ++count[row.at("part")];
  }
  EXPECT_EQ(count["limits"], 5 * 3 + 5 + 4 * 4); // Octaves and families, whole images, distances.
  EXPECT_EQ(count["model"], 2 * 25);
  EXPECT_EQ(count["cells"], 5 * 2 * 2);
  EXPECT_EQ(count["apriltag"], 4 * 3);
  for (const char *word : {"golay23: root", "bch31: root", "ring: root", "Log-odds", "gamma 2.2", "all at once",
                           "golay23 30 deg 10.4 m", "apriltag-1", "Targets: "}) {
    EXPECT_NE(outcome.out.find(word), std::string::npos) << word;
  }
}

TEST_F(Accuracy, DrawsFromItsRangesAndComparesWithAPositiveBound)
{
  int found = 0;
  double least = 1e9, most = 0.;
  for (const Row &row : rows) {
    found += number(row, "found") == 1.;
    if (row.at("part") == "limits" && row.at("group") == "golay23") {
      EXPECT_GE(number(row, "tilt_deg"), 8. - 1e-6);
      EXPECT_LE(number(row, "tilt_deg"), 75. + 1e-6);
      EXPECT_GE(number(row, "noise"), 1.);
      EXPECT_LE(number(row, "noise"), 5.);
      EXPECT_GE(number(row, "blur_px"), 0.5);
      EXPECT_LE(number(row, "blur_px"), 1.2);
      EXPECT_GE(number(row, "contrast"), 60.);
      EXPECT_LE(number(row, "contrast"), 190.);
      least = std::min(least, number(row, "diameter_px"));
      most = std::max(most, number(row, "diameter_px"));
    }
    for (const char *name : {"bound_x_mm", "bound_y_mm", "bound_z_mm", "bound_normal_deg"}) {
      EXPECT_GT(number(row, name), 0.) << name;
    }
  }
  EXPECT_LT(least, 40.);
  EXPECT_GT(most, 250.);
  EXPECT_GT(found, static_cast<int>(rows.size()) / 2);
}

// No estimator is far below its bound, and this one is not far above it: the middle of x, y, z over images within the
// model. A mistake in units or frames would show.
TEST_F(Accuracy, ErrorsAreOfTheSizeOfTheBound)
{
  std::vector<double> ratios;
  for (const Row &row : rows) {
    if (row.at("part") == "limits" && number(row, "found") == 1. && number(row, "wrong") == 0.) {
      for (const std::string name : {"x", "y", "z"}) {
        ratios.push_back(std::fabs(number(row, name + "_mm")) / number(row, "bound_" + name + "_mm"));
      }
    }
  }
  ASSERT_GT(ratios.size(), 30u);
  std::sort(ratios.begin(), ratios.end());
  const double median = ratios[ratios.size() / 2]; // 0.674 for a normal distribution at the bound.
  EXPECT_GT(median, 0.35);
  EXPECT_LT(median, 2.);
}

TEST_F(Accuracy, OneFactorAtATimeIsSeenAtTheSamePose)
{
  std::map<std::string, std::set<std::string>> groupsOfPose;
  for (const Row &row : rows) {
    if (row.at("part") == "model") {
      groupsOfPose[row.at("distance_m") + " " + row.at("tilt_deg")].insert(row.at("group"));
    }
  }
  std::size_t most = 0;
  for (const auto &[pose, groups] : groupsOfPose) {
    most = std::max(most, groups.size());
  }
  EXPECT_EQ(most, 22u); // All but the three with cameras of their own.
}

TEST_F(Accuracy, JsonHoldsTargetsWithTheirFigures)
{
  ASSERT_TRUE(json.contains("targets"));
  ASSERT_TRUE(json.contains("tables"));
  for (const auto &table : json["tables"]) {
    for (const auto &row : table["rows"]) {
      EXPECT_EQ(row.size(), table["titles"].size());
    }
  }
  for (const auto &target : json["targets"]) {
    const bool isMet = target["value"].is_number() &&
                       (target["least"].is_null() || target["value"] >= target["least"]) &&
                       (target["most"].is_null() || target["value"] <= target["most"]);
    EXPECT_EQ(target["met"].get<bool>(), isMet);
  }
}

TEST_F(Accuracy, PageIsMadeAnewFromTheResults)
{
  const std::vector<std::string> plots = {"honesty.svg", "ratio-blur.svg", "ratio-diameter.svg", "ratio-noise.svg",
                                          "ratio-tilt.svg"};
  const std::string page = contentOf(folder / "page" / "README.md");
  for (const std::string &plot : plots) {
    EXPECT_NE(page.find("(" + plot + ")"), std::string::npos) << plot;
    if (hasGnuplot) {
      EXPECT_NE(contentOf(folder / "page" / plot).find("</svg>"), std::string::npos) << plot;
    }
  }
  const Outcome again = run(CIRCLE_MARKER_ACCURACY, {"--from", "results", "--page", "again"}, folder);
  EXPECT_EQ(again.status, hasGnuplot ? 0 : 1) << again.err;
  EXPECT_EQ(again.out, outcome.out);
  EXPECT_EQ(contentOf(folder / "again" / "README.md"), page);
}

TEST_F(Accuracy, DoesNotDependOnThreadsOrOtherParts)
{
  const Outcome again =
      run(CIRCLE_MARKER_ACCURACY,
          {"--output", "one", "--frames", "1", "--seed", "3", "--part", "apriltag", "--jobs", "1"}, folder);
  ASSERT_EQ(again.status, 0) << again.err;
  std::string whole = withoutTimes(contentOf(folder / "results" / "accuracy.csv"));
  std::istringstream part(withoutTimes(contentOf(folder / "one" / "accuracy.csv")));
  int lines = 0;
  for (std::string line; std::getline(part, line);) {
    if (line.rfind("apriltag,", 0) == 0) {
      ++lines;
      EXPECT_NE(whole.find(line + "\n"), std::string::npos) << line;
    }
  }
  EXPECT_EQ(lines, 12);
}

TEST(AccuracyProgram, RefusesWrongArguments)
{
  const auto folder = emptyFolder();
  const std::vector<std::vector<std::string>> wrong = {{},
                                                       {"--output", "x", "--part", "everything"},
                                                       {"--output", "x", "--frames", "0"},
                                                       {"--output", "x", "--from", "."},
                                                       {"--from", "nowhere"},
                                                       {"--output", "x", "more"}};
  for (const auto &arguments : wrong) {
    const Outcome outcome = run(CIRCLE_MARKER_ACCURACY, arguments, folder);
    EXPECT_EQ(outcome.status, 2) << outcome.err;
    EXPECT_EQ(outcome.err.rfind("circle-marker-accuracy: ", 0), 0u) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
  const Outcome empty = run(CIRCLE_MARKER_ACCURACY, {"--from", "."}, folder);
  EXPECT_EQ(empty.status, 1);
  EXPECT_NE(empty.err.find("accuracy.csv"), std::string::npos) << empty.err;
  EXPECT_EQ(filesIn(folder), std::vector<std::string>());

  const Outcome help = run(CIRCLE_MARKER_ACCURACY, {"--help"}, folder);
  EXPECT_EQ(help.status, 0);
  for (const char *option : {"--output", "--from", "--page", "--part", "--frames", "--seed", "--jobs", "--surround"}) {
    EXPECT_NE(help.out.find(option), std::string::npos) << option;
  }
}
