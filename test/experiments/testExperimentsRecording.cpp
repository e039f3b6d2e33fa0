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
 * Tests of experiment 1: recordings of a marker at several places, their means, covariances and lines.
 */

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "recording.h"
#include "report_recording.h"
#include "run_data.h"
#include "station_figures.h"

using namespace experiments;

namespace {
namespace fs = std::filesystem;

std::mt19937_64 generator()
{
  return std::mt19937_64(std::hash<std::string>()(::testing::UnitTest::GetInstance()->current_test_info()->name()));
}

fs::path emptyFolder()
{
  const fs::path folder = fs::temp_directory_path() / (std::string("circle-marker-") +
                                                       ::testing::UnitTest::GetInstance()->current_test_info()->name());
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

/*! A line of the detector's programs: a marker that faces the camera, at a place in metres. */
nlohmann::json lineOf(int id, double x, double y, double z, const std::array<double, 3> &sigma)
{
  nlohmann::json marker;
  marker["family"] = "golay23";
  marker["id"] = id;
  marker["size_m"] = 0.18;
  marker["cMo"] = {1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z, 0, 0, 0, 1};
  std::vector<double> covariance(36, 0.);
  for (std::size_t i = 0; i < 3; ++i) {
    covariance[7 * i] = sigma[i] * sigma[i];
  }
  marker["covariance"] = covariance;
  return {{"image", "img"}, {"cpu_ms", 4.}, {"markers", nlohmann::json::array({marker})}};
}

void write(const fs::path &folder, const std::string &station, const std::vector<nlohmann::json> &lines)
{
  fs::create_directories(folder / station);
  std::ofstream file(folder / station / "poses.jsonl");
  for (const auto &line : lines) {
    file << line.dump() << "\n";
  }
}

std::string problemOf(const fs::path &folder, std::optional<int> id = std::nullopt)
{
  try {
    recordingIn(folder.string(), id);
  }
  catch (const DataError &e) {
    return e.what();
  }
  return "";
}
} // namespace

TEST(ExperimentsRecording, MeanAndCovarianceOfAStation)
{
  std::mt19937_64 random = generator();
  std::normal_distribution<double> normal;
  // x and y hang together: y has half of x's noise besides its own. Metres.
  const double a = 2e-4, b = 1e-4, c = 3e-3;
  const fs::path folder = emptyFolder();
  std::vector<nlohmann::json> lines;
  constexpr int count = 4000;
  for (int i = 0; i < count; ++i) {
    const double dx = a * normal(random);
    lines.push_back(lineOf(5, 0.1 + dx, -0.2 + 0.5 * dx + b * normal(random), 2. + c * normal(random), {a, b, c}));
  }
  write(folder, "2m", lines);
  const Recording recording = recordingIn(folder.string(), std::nullopt);
  ASSERT_EQ(recording.stations.size(), 1u);
  EXPECT_EQ(recording.id, 5);
  EXPECT_EQ(*recording.stations[0].distance, 2.);
  const StationFigures f = figuresOf(recording.stations[0]);
  EXPECT_EQ(f.found, static_cast<std::size_t>(count));
  // Millimetres; means within 5 of their standard deviations, variances within 5 of theirs (2.2 % each).
  const double ofMean = 5. / std::sqrt(count);
  EXPECT_NEAR(f.mean[0], 100., 1e3 * a * ofMean);
  EXPECT_NEAR(f.mean[2], 2000., 1e3 * c * ofMean);
  constexpr double share = 0.12;
  EXPECT_NEAR(f.covariance[0][0], 1e6 * a * a, share * 1e6 * a * a);
  EXPECT_NEAR(f.covariance[0][1], 0.5e6 * a * a, share * 1e6 * a * a);
  EXPECT_DOUBLE_EQ(f.covariance[0][1], f.covariance[1][0]);
  EXPECT_NEAR(f.covariance[1][1], 1e6 * (0.25 * a * a + b * b), share * 1e6 * a * a);
  EXPECT_NEAR(f.covariance[2][2], 1e6 * c * c, share * 1e6 * c * c);
  EXPECT_NEAR(f.stated[2][2], 1e6 * c * c, 1e-9);
  // The stated y is too small: (0.25 a^2 + b^2) / b^2 = 2 there, 1 in x and z.
  EXPECT_NEAR(f.consistency, 4. / 3., share);
  EXPECT_NEAR(f.tilt, 0., 1e-9);
  EXPECT_NEAR(f.normalSpread, 0., 1e-9);
}

TEST(ExperimentsRecording, CovarianceOfTheCentreHasTheTurnsShare)
{
  // A turn of 1e-3 about the camera's y moves a centre at 2 m by 2 mm in x, and one at x = 0.5 m by 0.5 mm in z.
  const fs::path folder = emptyFolder();
  nlohmann::json line = lineOf(5, 0.5, 0., 2., {0., 0., 0.});
  line["markers"][0]["covariance"][7 * 4] = 1e-6;
  write(folder, "2m", {line, line});
  const StationFigures f = figuresOf(recordingIn(folder.string(), std::nullopt).stations[0]);
  EXPECT_NEAR(f.stated[0][0], 4., 1e-9); // mm^2
  EXPECT_NEAR(f.stated[2][2], 0.25, 1e-9);
  EXPECT_NEAR(f.stated[0][2], -1., 1e-9);
}

TEST(ExperimentsRecording, SlideIsAStraightLine)
{
  std::mt19937_64 random = generator();
  std::normal_distribution<double> normal;
  const fs::path folder = emptyFolder();
  std::vector<nlohmann::json> lines;
  for (int i = 0; i < 400; ++i) {
    const double z = 1. + 0.01 * i;
    lines.push_back(lineOf(5, 0.03 * z + 1e-4 * normal(random), 0.04 * z + 1e-4 * normal(random), z, {1., 1., 1.}));
  }
  write(folder, "slide", lines);
  const Recording recording = recordingIn(folder.string(), std::nullopt);
  ASSERT_FALSE(recording.stations[0].distance.has_value());
  const SlideLine line = experiments::lineOf(recording.stations[0]);
  EXPECT_NEAR(line.nearest, 1000., 1e-6);
  EXPECT_NEAR(line.farthest, 4990., 1e-6);
  EXPECT_NEAR(line.angle, std::atan(0.05) * 180. / M_PI, 1e-2);
  EXPECT_NEAR(line.distances.rms, 0.1 * std::sqrt(2.), 0.02);
}

TEST(ExperimentsRecording, StationsAreInOrderAndMissesCount)
{
  const fs::path folder = emptyFolder();
  const auto here = lineOf(5, 0., 0., 1., {1e-3, 1e-3, 1e-3});
  auto none = here;
  none["markers"] = nlohmann::json::array();
  write(folder, "slide", {here});
  write(folder, "10m", {none, here, none, here});
  write(folder, "2.5m", {here, lineOf(7, 0., 0., 1., {1., 1., 1.})});
  const Recording recording = recordingIn(folder.string(), std::nullopt);
  ASSERT_EQ(recording.stations.size(), 3u);
  EXPECT_EQ(recording.stations[0].name, "2.5m");
  EXPECT_EQ(recording.stations[1].name, "10m");
  EXPECT_EQ(recording.stations[2].name, "slide");
  EXPECT_EQ(recording.id, 5); // The one found most often.
  EXPECT_EQ(figuresOf(recording.stations[0]).found, 1u);
  EXPECT_EQ(figuresOf(recording.stations[1]).found, 2u);
  EXPECT_DOUBLE_EQ(figuresOf(recording.stations[1]).markers, 0.5);
  // Stations with one estimate or none are reported all the same.
  common::Document document("test");
  addRecording(recording, document);
  EXPECT_NE(document.markdown().find("experiment-1-clouds.svg"), std::string::npos);
  EXPECT_EQ(recordingIn(folder.string(), 7).id, 7);
}

TEST(ExperimentsRecording, WhatIsNoRecordingIsRefused)
{
  const fs::path folder = emptyFolder();
  EXPECT_NE(problemOf(folder).find("holds no recording"), std::string::npos);
  EXPECT_NE(problemOf(folder / "nowhere").find("holds no recording"), std::string::npos);
  write(folder, "2m", {nlohmann::json{{"cpu_ms", 1.}, {"markers", nlohmann::json::array()}}});
  EXPECT_NE(problemOf(folder).find("no marker was found"), std::string::npos);
  write(folder, "2m", {nlohmann::json{{"cpu_ms", 1.}}});
  EXPECT_NE(problemOf(folder).find("are not those of tutorial-circle-marker-detector"), std::string::npos);
  std::ofstream(folder / "2m" / "poses.jsonl") << "no JSON\n";
  EXPECT_NE(problemOf(folder).find("is not JSON"), std::string::npos);
  fs::rename(folder / "2m", folder / "near");
  EXPECT_NE(problemOf(folder).find("\"near\" is named neither"), std::string::npos);
}

TEST(ExperimentsRecording, EllipseHasTheCovariance)
{
  // The points p of the ellipse of k deviations have p^T C^-1 p = k^2.
  const Square C = {{{4., 0., 3.}, {0., 1., 0.}, {3., 0., 9.}}};
  const double determinant = C[0][0] * C[2][2] - C[0][2] * C[0][2];
  for (const auto &p : ellipseOf(C, 0, 2, 2.)) {
    EXPECT_NEAR((C[2][2] * p[0] * p[0] - 2. * C[0][2] * p[0] * p[1] + C[0][0] * p[1] * p[1]) / determinant, 4., 1e-9);
  }
}
