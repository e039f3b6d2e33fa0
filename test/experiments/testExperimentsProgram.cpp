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
 * Tests of circle-marker-experiments as a user runs it.
 */

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "../create/run_program.h"

using namespace test;

namespace {
namespace fs = std::filesystem;

const std::string program = CIRCLE_MARKER_EXPERIMENTS;
const bool hasGnuplot = std::string(GNUPLOT) != "";
const int done = hasGnuplot ? 0 : 1; // Without gnuplot all but the figures is there.

/*! One cell of few frames: what most tests need. */
std::vector<std::string> oneCell(const std::string &output, const std::string &frames)
{
  return {"--output", output, "--experiment", "3",  "--frames",       frames,
          "--seed",   "7",    "--max-angle",  "50", "--max-distance", "6"};
}

std::vector<std::string> with(std::vector<std::string> arguments, const std::vector<std::string> &more)
{
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

/*! The rows of a table, without the head. */
std::vector<std::string> rowsOf(const std::string &csv)
{
  std::vector<std::string> rows;
  std::istringstream stream(csv);
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind("#", 0) != 0 && line.rfind("series,", 0) != 0) {
      rows.push_back(line);
    }
  }
  return rows;
}

/*! Rows without their last column, the time. */
std::vector<std::string> withoutTimes(std::vector<std::string> rows)
{
  for (std::string &row : rows) {
    row = row.substr(0, row.rfind(','));
  }
  return rows;
}

void write(const fs::path &path, const std::string &content)
{
  std::ofstream(path, std::ios::binary) << content;
}
} // namespace

TEST(ExperimentsProgram, WritesDataStatisticsFiguresAndReport)
{
  const fs::path folder = emptyFolder();
  const Outcome outcome = run(program, {"--output", "results", "--experiment", "3", "--frames", "2"}, folder);
  EXPECT_EQ(outcome.status, done) << outcome.err;
  std::vector<std::string> expected = {"experiment-3.csv", "experiment-3.json", "report.gp", "report.html",
                                       "report.md"};
  const std::vector<std::string> figures = {"clouds",         "depth",       "depth-error",    "error-angle",
                                            "error-distance", "found-angle", "found-distance", "normal-angle"};
  const std::string html = contentOf(folder / "results" / "report.html");
  for (const std::string &figure : figures) {
    const std::string file = "experiment-3-" + figure + ".svg";
    EXPECT_NE(html.find("<img src=\"" + file + "\""), std::string::npos) << file;
    if (hasGnuplot) {
      expected.push_back(file);
      EXPECT_NE(contentOf(folder / "results" / file).find("</svg>"), std::string::npos) << file;
    }
  }
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(filesIn(folder / "results"), expected);
  EXPECT_NE(html.find("thesis, table 5.6"), std::string::npos);
  EXPECT_EQ(outcome.out, contentOf(folder / "results" / "report.md"));

  const std::string csv = contentOf(folder / "results" / "experiment-3.csv");
  EXPECT_NE(csv.find("# seed: 1\n"), std::string::npos);
  EXPECT_NE(csv.find("# version: "), std::string::npos);
  EXPECT_EQ(rowsOf(csv).size(), 5u * (2 * 2 + 1)); // Cells; frames of two methods; the bound of the first frame.

  const auto json = nlohmann::json::parse(contentOf(folder / "results" / "experiment-3.json"));
  EXPECT_EQ(json["settings"]["seed"], 1);
  EXPECT_TRUE(json["settings"]["size_m"].is_number());
  ASSERT_EQ(json["series"].size(), 5u);
  EXPECT_EQ(json["series"][0]["views"][0]["frames"], 2);
}

TEST(ExperimentsProgram, ThreadsDoNotChangeTheResults)
{
  const fs::path folder = emptyFolder();
  run(program, with(oneCell("one", "6"), {"--threads", "1"}), folder);
  run(program, with(oneCell("three", "6"), {"--threads", "3"}), folder);
  const auto one = withoutTimes(rowsOf(contentOf(folder / "one" / "experiment-3.csv")));
  EXPECT_EQ(one.size(), 6u * 2 + 2);
  EXPECT_EQ(one, withoutTimes(rowsOf(contentOf(folder / "three" / "experiment-3.csv"))));
}

TEST(ExperimentsProgram, GoesOnWhereItStopped)
{
  const fs::path folder = emptyFolder();
  run(program, oneCell("whole", "8"), folder);
  run(program, oneCell("resumed", "5"), folder);
  const fs::path file = folder / "resumed" / "experiment-3.csv";
  const auto before = rowsOf(contentOf(file));
  run(program, oneCell("resumed", "8"), folder);
  const auto after = rowsOf(contentOf(file));
  // The frames that were there are the same to the CPU time, so they were not made again.
  ASSERT_LT(before.size(), after.size());
  EXPECT_TRUE(std::equal(before.begin(), before.end(), after.begin()));
  EXPECT_EQ(withoutTimes(after), withoutTimes(rowsOf(contentOf(folder / "whole" / "experiment-3.csv"))));
}

TEST(ExperimentsProgram, GoesOnAfterItWasKilled)
{
  const fs::path folder = emptyFolder();
  // Far more frames than the time allows; what is kept every two seconds is there.
  const Outcome killed = run("timeout", with({"-s", "KILL", "6", program}, oneCell("results", "100000")), folder);
  EXPECT_NE(killed.status, 0);
  const fs::path file = folder / "results" / "experiment-3.csv";
  const auto before = rowsOf(contentOf(file));
  ASSERT_FALSE(before.empty());
  const Outcome outcome = run(program, oneCell("results", "1"), folder); // All of its frames are there.
  EXPECT_EQ(outcome.status, done) << outcome.err;
  EXPECT_EQ(rowsOf(contentOf(file)), before);
}

TEST(ExperimentsProgram, DrawsTheReportAgain)
{
  const fs::path folder = emptyFolder();
  run(program, oneCell("results", "3"), folder);
  const std::string report = contentOf(folder / "results" / "report.md");
  ASSERT_FALSE(report.empty());
  fs::remove(folder / "results" / "report.md");
  fs::remove(folder / "results" / "report.html");
  // Seed and cell are in the data.
  const Outcome outcome = run(program, {"--output", "results", "--experiment", "3", "--report-only"}, folder);
  EXPECT_EQ(outcome.status, done) << outcome.err;
  EXPECT_EQ(contentOf(folder / "results" / "report.md"), report);
  EXPECT_TRUE(fs::exists(folder / "results" / "report.html"));
}

TEST(ExperimentsProgram, RefusesDataOfOtherFrames)
{
  const fs::path folder = emptyFolder();
  run(program, oneCell("results", "2"), folder);
  const fs::path file = folder / "results" / "experiment-3.csv";
  const std::string csv = contentOf(file);

  const Outcome seed = run(program, with(oneCell("results", "2"), {"--noise", "3"}), folder);
  EXPECT_EQ(seed.status, 1);
  EXPECT_NE(seed.err.find("circle-marker-experiments: \"experiment-3.csv\" has frames of noise_grey_levels 2, not 3"),
            std::string::npos)
      << seed.err;

  // Another detector's frame: its error is not what comes out now.
  const std::string row = rowsOf(csv).front();
  std::vector<std::string> fields;
  std::istringstream stream(row);
  for (std::string field; std::getline(stream, field, ',');) {
    fields.push_back(field);
  }
  ASSERT_GT(fields.size(), 11u);
  fields[11] = std::to_string(std::stod(fields[11]) + 1.); // dz_mm
  std::string changed;
  for (const std::string &field : fields) {
    changed += (changed.empty() ? "" : ",") + field;
  }
  std::string other = csv;
  write(file, other.replace(other.find(row), row.size(), changed));
  const Outcome detector = run(program, oneCell("results", "3"), folder);
  EXPECT_EQ(detector.status, 1);
  EXPECT_NE(detector.err.find("comes out differently now"), std::string::npos) << detector.err;

  write(file, csv + "nonsense\n");
  const Outcome nonsense = run(program, oneCell("results", "3"), folder);
  EXPECT_EQ(nonsense.status, 1);
  EXPECT_NE(nonsense.err.find("is not of this experiment"), std::string::npos) << nonsense.err;
}

TEST(ExperimentsProgram, OtherExperimentsRunToo)
{
  const fs::path folder = emptyFolder();
  const Outcome outcome = run(
      program, {"--output", "results", "--experiment", "2", "requirements", "--frames", "1", "--size", "0.05"}, folder);
  EXPECT_EQ(outcome.status, done) << outcome.err;
  for (const std::string name : {"experiment-2", "requirements"}) {
    EXPECT_FALSE(rowsOf(contentOf(folder / "results" / (name + ".csv"))).empty()) << name;
  }
  const std::string report = contentOf(folder / "results" / "report.md");
  for (const std::string heading : {"## Experiment 2", "## Requirements"}) {
    EXPECT_NE(report.find(heading), std::string::npos) << heading;
  }
  EXPECT_NE(report.find("thesis, table 5.5"), std::string::npos);
}

TEST(ExperimentsProgram, EvaluatesARecording)
{
  const fs::path folder = emptyFolder();
  nlohmann::json marker = {{"family", "golay23"}, {"id", 5}, {"size_m", 0.18}};
  std::string lines;
  for (const double z : {2.001, 2.002, 2.003}) {
    marker["cMo"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, z, 0, 0, 0, 1};
    marker["covariance"] = std::vector<double>(36, 0.);
    lines += nlohmann::json({{"cpu_ms", 3.}, {"markers", nlohmann::json::array({marker})}}).dump() + "\n";
  }
  for (const std::string place : {"2m", "slide"}) {
    fs::create_directories(folder / "recording" / place);
    write(folder / "recording" / place / "poses.jsonl", lines);
  }
  const Outcome outcome =
      run(program, {"--output", "results", "--experiment", "1", "--recording", "recording"}, folder);
  EXPECT_EQ(outcome.status, done) << outcome.err;
  EXPECT_NE(contentOf(folder / "results" / "report.md").find("(0.000, 0.000, 2002.000)"), std::string::npos);
  EXPECT_EQ(rowsOf(contentOf(folder / "results" / "experiment-1.csv")).size(), 7u); // With the line of titles.
  if (hasGnuplot) {
    EXPECT_TRUE(fs::exists(folder / "results" / "experiment-1-clouds.svg"));
  }
  const Outcome nothing = run(program, {"--output", "other", "--experiment", "1", "--recording", "nowhere"}, folder);
  EXPECT_EQ(nothing.status, 1);
  EXPECT_NE(nothing.err.find("\"nowhere\" holds no recording"), std::string::npos) << nothing.err;
}

TEST(ExperimentsProgram, RecordsExperiment1OnASimulatedBus)
{
  if (std::string(SIMULATED_LIBRARY).empty() || !fs::exists(SIMULATED_LIBRARY)) {
    GTEST_SKIP() << "there is no simulated FireWire bus: it needs dc1394/dc1394.h";
  }
  const fs::path folder = emptyFolder();
  // Where everything is built with sanitizers, what is preloaded comes before their own library.
  const std::vector<std::string> arguments = {"ASAN_OPTIONS=verify_asan_link_order=0:detect_leaks=0",
                                              "bash",
                                              EXPERIMENT_1_SCRIPT,
                                              "--build",
                                              CIRCLE_MARKER_BUILD_DIR,
                                              "--output",
                                              "results",
                                              "--simulated",
                                              "--frames",
                                              "3",
                                              "--places",
                                              "2 slide"};
  const Outcome outcome = run("env", arguments, folder);
  EXPECT_EQ(outcome.status, done) << outcome.err;
  // The marker is where the scenario has it, to a tenth of a millimetre at 2 m; the images are kept.
  const std::string report = contentOf(folder / "results" / "report.md");
  EXPECT_NE(report.find("| (0, 0, 2000) | 3 | 100.0 | 1.00 | ("), std::string::npos) << report;
  EXPECT_TRUE(report.find(", 1999.9") != std::string::npos || report.find(", 2000.0") != std::string::npos) << report;
  EXPECT_NE(report.find("| slide | 3 | 100.0 |"), std::string::npos) << report;
  EXPECT_TRUE(fs::exists(folder / "results" / "recording" / "slide" / "img0002.png"));
  // A second call finds all recorded.
  const Outcome again = run("env", arguments, folder);
  EXPECT_EQ(again.status, done) << again.err;
  EXPECT_NE(again.err.find("2m is recorded already"), std::string::npos) << again.err;
  EXPECT_EQ(run("bash", {EXPERIMENT_1_SCRIPT}, folder).status, 2);
}

TEST(ExperimentsProgram, WrongArgumentsEndWithTwo)
{
  const fs::path folder = emptyFolder();
  const std::vector<std::vector<std::string>> wrong = {
      {},
      {"--output", "results"},
      {"--experiment", "3"},
      {"--output", "", "--experiment", "3"},
      {"--output", "results", "--experiment", "4"},
      {"--output", "results", "--experiment", "1"}, // Without a recording.
      {"--output", "results", "--experiment", "3", "--frames", "0"},
      {"--output", "results", "--experiment", "3", "--frames", "many"},
      {"--output", "results", "--experiment", "3", "--max-angle", "91"},
      {"--output", "results", "--experiment", "3", "--max-angle", "nan"},
      {"--output", "results", "--experiment", "3", "--max-distance", "0"},
      {"--output", "results", "--experiment", "2", "--max-angle", "30"},
      {"--output", "results", "--experiment", "3", "--threads", "0"},
      {"--output", "results", "--experiment", "3", "--unknown"},
      {"--output", "results", "--experiment", "3", "stray"}};
  for (const auto &arguments : wrong) {
    const Outcome outcome = run(program, arguments, folder);
    EXPECT_EQ(outcome.status, 2) << ::testing::PrintToString(arguments);
    EXPECT_EQ(outcome.err.rfind("circle-marker-experiments: ", 0), 0u) << outcome.err;
    EXPECT_TRUE(outcome.out.empty());
  }
  EXPECT_TRUE(filesIn(folder).empty());
}

TEST(ExperimentsProgram, HelpSaysWhatThereIs)
{
  const Outcome outcome = run(program, {"--help"}, emptyFolder());
  EXPECT_EQ(outcome.status, 0);
  for (const std::string option : {"--output", "--experiment", "--frames", "--seed", "--max-distance", "--max-angle",
                                   "--report-only", "resilience", "requirements"}) {
    EXPECT_NE(outcome.out.find(option), std::string::npos) << option;
  }
}

TEST(ExperimentsProgram, WhatCannotBeUsedEndsWithOne)
{
  const fs::path folder = emptyFolder();
  const Outcome missing = run(program, {"--output", "empty", "--experiment", "3", "--report-only"}, folder);
  EXPECT_EQ(missing.status, 1);
  EXPECT_NE(missing.err.find("there is no \"experiment-3.csv\" in \"empty\""), std::string::npos) << missing.err;
  write(folder / "file", "");
  const Outcome file = run(program, {"--output", "file", "--experiment", "3", "--frames", "1"}, folder);
  EXPECT_EQ(file.status, 1);
  EXPECT_EQ(file.err.rfind("circle-marker-experiments: ", 0), 0u) << file.err;
}
