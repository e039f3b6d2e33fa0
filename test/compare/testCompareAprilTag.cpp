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
 * circle-marker-compare-apriltag from outside: its files, its arguments, and who is the more accurate.
 */

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "../create/csv_rows.h"
#include "../create/run_program.h"

using namespace test;

namespace {
const std::vector<std::string> methods = {"circle", "apriltag-1", "apriltag-1-half-pixel", "apriltag-2",
                                          "apriltag-2-half-pixel"};
constexpr std::size_t cellCount = 5;
constexpr unsigned int frames = 5;

double number(const Row &row, const std::string &column)
{
  return std::stod(row.at(column));
}

double median(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

/*! One comparison, made once and looked at by several tests. */
class Comparison : public ::testing::Test
{
protected:
  static void SetUpTestSuite()
  {
    folder = std::filesystem::path(CIRCLE_MARKER_TEST_DIR) / "Comparison";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    outcome = run(CIRCLE_MARKER_COMPARE, {"--output", "results", "--frames", std::to_string(frames)}, folder);
    csv = contentOf(folder / "results" / "compare.csv");
    rows = rowsOf(csv);
    json = nlohmann::json::parse(contentOf(folder / "results" / "compare.json"), nullptr, false);
  }

  void SetUp() override
  {
    ASSERT_EQ(rows.size(), cellCount * frames * methods.size()) << outcome.err;
    ASSERT_FALSE(json.is_discarded());
  }

  static inline std::filesystem::path folder;
  static inline Outcome outcome;
  static inline std::string csv;
  static inline std::vector<Row> rows;
  static inline nlohmann::json json;
};
} // namespace

TEST_F(Comparison, WritesItsFilesAndNothingElse)
{
  std::vector<std::string> expected = {"compare.csv", "compare.gp", "compare.json"};
  const bool hasGnuplot = std::string(GNUPLOT) != "";
  if (hasGnuplot) {
    expected.insert(expected.end(), {"detection-rate.svg", "normal-error.svg", "position-error.svg"});
  }
  EXPECT_EQ(outcome.status, hasGnuplot ? 0 : 1) << outcome.err;
  EXPECT_EQ(filesIn(folder / "results"), expected);
  for (const std::string &name : expected) {
    if (name.find(".svg") != std::string::npos) {
      EXPECT_NE(contentOf(folder / "results" / name).find("</svg>"), std::string::npos) << name;
    }
  }
  for (const std::string &method : methods) {
    EXPECT_NE(outcome.out.find(method), std::string::npos) << method;
  }
}

TEST_F(Comparison, DrawsPosesFromTheCells)
{
  for (const Row &row : rows) {
    EXPECT_GE(number(row, "z_m"), 0.36);
    EXPECT_LE(number(row, "z_m"), number(row, "max_depth_m"));
    EXPECT_LE(number(row, "tilt_deg"), number(row, "max_tilt_deg") + 1e-6);
    const double distance =
        std::sqrt(std::pow(number(row, "x_m"), 2) + std::pow(number(row, "y_m"), 2) + std::pow(number(row, "z_m"), 2));
    EXPECT_NEAR(number(row, "distance_m"), distance, 1e-7);
  }
}

TEST_F(Comparison, AllMethodsSeeTheSamePose)
{
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row &first = rows[i - i % methods.size()];
    EXPECT_EQ(rows[i].at("method"), methods[i % methods.size()]);
    for (const std::string column : {"cell", "frame", "x_m", "y_m", "z_m", "tux_rad", "tuy_rad", "tuz_rad"}) {
      EXPECT_EQ(rows[i].at(column), first.at(column));
    }
  }
}

TEST_F(Comparison, SummaryAgreesWithTheRows)
{
  ASSERT_EQ(json["cells"].size(), cellCount);
  for (std::size_t cell = 0; cell < cellCount; ++cell) {
    for (const std::string &method : methods) {
      std::vector<double> errors;
      for (const Row &row : rows) {
        if (row.at("cell") == std::to_string(cell + 1) && row.at("method") == method && row.at("found") == "1") {
          errors.push_back(number(row, "position_error_mm"));
          EXPECT_NEAR(errors.back(),
                      std::sqrt(std::pow(number(row, "dx_mm"), 2) + std::pow(number(row, "dy_mm"), 2) +
                                std::pow(number(row, "dz_mm"), 2)),
                      1e-6 * errors.back());
        }
      }
      const nlohmann::json &summary = json["cells"][cell]["methods"][method];
      EXPECT_EQ(summary["found"], errors.size());
      if (errors.empty()) {
        EXPECT_TRUE(summary["frames_it_found"]["position_mm"]["median"].is_null());
      }
      else {
        EXPECT_NEAR(summary["frames_it_found"]["position_mm"]["median"].get<double>(), median(errors),
                    1e-6 * median(errors));
      }
    }
  }
}

TEST_F(Comparison, CircleIsMoreAccurate)
{
  std::size_t compared = 0;
  for (const nlohmann::json &cell : json["cells"]) {
    if (cell["frames_all_found"] < 3) {
      continue;
    }
    const auto error = [&cell](const std::string &method, const std::string &quantity) {
      return cell["methods"][method]["frames_all_found"][quantity]["median"].get<double>();
    };
    for (const std::string &method : methods) {
      if (method != "circle") {
        EXPECT_LT(error("circle", "position_mm"), error(method, "position_mm")) << method << " " << cell;
        EXPECT_LT(error("circle", "normal_deg"), error(method, "normal_deg")) << method << " " << cell;
        ++compared;
      }
    }
  }
  EXPECT_GE(compared, 3 * (methods.size() - 1)) << "too few frames were found by all methods";
}

// A wrong convention of frames or pixels on either side would show as a systematic rotation or offset.
TEST_F(Comparison, BothMarkersAreMeasuredInTheSameFrame)
{
  for (const Row &row : rows) {
    if (row.at("found") != "1" || row.at("mirrored") == "1") {
      continue;
    }
    // The rest of the rotation, about the normal, is measured better than the normal itself.
    EXPECT_LT(number(row, "rotation_error_deg"), number(row, "normal_error_deg") + 2.) << row.at("method");
    if (row.at("method") == "circle") {
      EXPECT_LT(std::hypot(number(row, "dx_mm"), number(row, "dy_mm")), 0.002 * 1000. * number(row, "z_m"));
    }
  }
}

TEST_F(Comparison, IsTheSameWithMoreThreads)
{
  ASSERT_LE(run(CIRCLE_MARKER_COMPARE,
                {"--output", "again", "--frames", std::to_string(frames), "--seed", "1", "--threads", "2"}, folder)
                .status,
            1);
  EXPECT_EQ(withoutTimes(csv), withoutTimes(contentOf(folder / "again" / "compare.csv")));
}

TEST_F(Comparison, AnotherSeedGivesOtherPoses)
{
  ASSERT_LE(run(CIRCLE_MARKER_COMPARE, {"--output", "other", "--frames", "1", "--seed", "2"}, folder).status, 1);
  const std::vector<Row> other = rowsOf(contentOf(folder / "other" / "compare.csv"));
  ASSERT_EQ(other.size(), cellCount * methods.size());
  EXPECT_NE(other.front().at("x_m"), rows.front().at("x_m"));
}

TEST(CompareAprilTag, WithoutGnuplotTheTablesAreWrittenAllTheSame)
{
  const std::filesystem::path folder = emptyFolder();
  const Outcome outcome =
      run("/usr/bin/env", {"PATH=/nonexistent", CIRCLE_MARKER_COMPARE, "--output", ".", "--frames", "1"}, folder);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err.rfind("circle-marker-compare-apriltag: ", 0), 0u) << outcome.err;
  EXPECT_NE(outcome.err.find("gnuplot"), std::string::npos) << outcome.err;
  EXPECT_EQ(filesIn(folder), (std::vector<std::string>{"compare.csv", "compare.gp", "compare.json"}));
  EXPECT_EQ(rowsOf(contentOf(folder / "compare.csv")).size(), cellCount * methods.size());
}

TEST(CompareAprilTag, SaysWhichFolderCannotBeMade)
{
  const std::filesystem::path folder = emptyFolder();
  std::ofstream(folder / "file") << "a file";
  const Outcome outcome = run(CIRCLE_MARKER_COMPARE, {"--output", "file/results"}, folder);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("file/results"), std::string::npos) << outcome.err;
}

TEST(CompareAprilTag, RefusesWrongArguments)
{
  const std::filesystem::path folder = emptyFolder();
  const std::vector<std::vector<std::string>> wrong = {{},
                                                       {"--output", ""},
                                                       {"--output", "a", "--frames", "0"},
                                                       {"--output", "a", "--frames", "-1"},
                                                       {"--output", "a", "--seed", "one"},
                                                       {"--output", "a", "--threads", "0"},
                                                       {"--output", "a", "--size", "nan"},
                                                       {"--output", "a", "--noise", "-1"},
                                                       {"--output", "a", "--apriltag-pose", "magic"},
                                                       {"--output", "a", "--unknown"}};
  for (const auto &arguments : wrong) {
    const Outcome outcome = run(CIRCLE_MARKER_COMPARE, arguments, folder);
    EXPECT_EQ(outcome.status, 2) << ::testing::PrintToString(arguments);
    EXPECT_EQ(outcome.err.rfind("circle-marker-compare-apriltag: ", 0), 0u) << outcome.err;
  }
  EXPECT_TRUE(filesIn(folder).empty());
}

TEST(CompareAprilTag, Helps)
{
  const Outcome outcome = run(CIRCLE_MARKER_COMPARE, {"--help"}, emptyFolder());
  EXPECT_EQ(outcome.status, 0);
  for (const std::string option : {"--output", "--frames", "--seed", "minutes"}) {
    EXPECT_NE(outcome.out.find(option), std::string::npos) << option;
  }
}
