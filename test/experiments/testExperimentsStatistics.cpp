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
 * Tests of the experiments' statistics, reports and shared work.
 */

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

#include "common/document.h"
#include "common/figure.h"
#include "common/parallel.h"
#include "curves.h"
#include "summary.h"

using namespace experiments;

namespace {
Sample found(const Deviation &first)
{
  Sample sample;
  sample.z = 2.;
  sample.markers = 1;
  sample.first = first;
  return sample;
}
} // namespace

TEST(ExperimentsStatistics, OfKnownNumbers)
{
  const Statistics statistics = statisticsOf({4., 1., 3., 2., 10.});
  EXPECT_DOUBLE_EQ(statistics.mean, 4.);
  EXPECT_DOUBLE_EQ(statistics.sigma, std::sqrt(10.)); // Squares of 0, 3, 1, 2, 6 over 5.
  EXPECT_DOUBLE_EQ(statistics.least, 1.);
  EXPECT_DOUBLE_EQ(statistics.most, 10.);
  EXPECT_TRUE(std::isnan(statisticsOf({}).sigma));
}

TEST(ExperimentsStatistics, SpreadOfLargeNumbersDoesNotCancel)
{
  EXPECT_DOUBLE_EQ(statisticsOf({1e9 + 1., 1e9 + 3.}).sigma, 1.);
}

TEST(ExperimentsStatistics, BothSolutionsCountWhereTheThesisCountsBoth)
{
  Sample sample = found({3., 4., 0., 1.});
  sample.second = Deviation{0., 0., 10., 59.};
  const Summary both = summaryOf({sample}, Solutions::Both);
  EXPECT_DOUBLE_EQ(both.position.mean, 7.5); // Of 5 and 10.
  EXPECT_DOUBLE_EQ(both.angle.mean, 30.);
  EXPECT_DOUBLE_EQ(both.angle.sigma, 29.);
  const Summary first = summaryOf({sample}, Solutions::First);
  EXPECT_DOUBLE_EQ(first.position.mean, 5.);
  EXPECT_DOUBLE_EQ(first.angle.mean, 1.);
  EXPECT_EQ(both.found, 1u); // One marker, of two solutions.
}

TEST(ExperimentsStatistics, OffsetHasTheThesissSign)
{
  // Estimated 2 mm too far: C - eC is -2 mm, as in the thesis's table 5.6, whose estimates are too far.
  const Summary summary = summaryOf({found({0.5, -1., 2., 0.})}, Solutions::First);
  EXPECT_DOUBLE_EQ(summary.offset[0].mean, -0.5);
  EXPECT_DOUBLE_EQ(summary.offset[1].mean, 1.);
  EXPECT_DOUBLE_EQ(summary.offset[2].mean, -2.);
}

TEST(ExperimentsStatistics, CountsWhatIsNotThere)
{
  Sample missed;
  missed.z = 2.;
  missed.markers = 2; // Of other ids.
  Sample mirrored = found({0., 0., 0., 40.});
  mirrored.isMirrored = true;
  const Summary summary =
      summaryOf({missed, mirrored, found({0., 0., 201., 0.}), found({0., 0., 199., 19.})}, Solutions::First);
  EXPECT_EQ(summary.frames, 4u);
  EXPECT_EQ(summary.found, 3u);
  EXPECT_EQ(summary.falseMarkers, 2u);
  EXPECT_EQ(summary.mirrored, 1u);
  EXPECT_EQ(summary.wrong, 2u); // 40 degrees; 201 mm of 2 m.
  EXPECT_DOUBLE_EQ(summary.markers, 1.25);
}

TEST(ExperimentsStatistics, BoundCountsWhereTheMarkerIsFound)
{
  Sample circleFound = found({1., 0., 0., 0.});
  Sample circleMissed;
  Sample atBound = found({2., 0., 0., 0.});
  atBound.method = Method::Bound;
  const std::vector<std::optional<FrameSamples>> series = {
      FrameSamples{circleFound, atBound}, FrameSamples{circleMissed, atBound}, FrameSamples{circleFound}, std::nullopt};
  EXPECT_EQ(samplesOf(series, Method::Circle).size(), 3u);
  EXPECT_EQ(samplesOf(series, Method::Bound).size(), 1u);
}

TEST(ExperimentsStatistics, BinsHoldTheirLowerEdge)
{
  std::vector<Sample> samples(5);
  const double depths[] = {-1., 0., 1., 1.5, 2.};
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].z = depths[i];
  }
  const auto bins = inBins(samples, evenBins(0., 2., 2), [](const Sample &sample) { return sample.z; });
  ASSERT_EQ(bins.size(), 2u);
  EXPECT_EQ(bins[0].size(), 1u);
  EXPECT_EQ(bins[1].size(), 2u);
}

TEST(ExperimentsStatistics, MeanCurvesLeaveEmptyBinsOut)
{
  std::vector<Sample> samples(6, found({3., 4., 0., 0.}));
  for (Sample &sample : samples) {
    sample.z = 1.5;
  }
  samples.push_back(found({0., 0., 1., 0.})); // Alone in its bin.
  const Curve curve = meanCurve(
      samples, circle, evenBins(0., 3., 3), [](const Sample &sample) { return sample.z; },
      [](const Deviation &deviation) { return deviation.position(); });
  ASSERT_EQ(curve.points.size(), 1u);
  EXPECT_DOUBLE_EQ(curve.points[0][0], 1.5);
  EXPECT_DOUBLE_EQ(curve.points[0][1], 5.);
}

TEST(ExperimentsReport, TextIsEscaped)
{
  Document document("A & B");
  document.addTable("|x| < 2", {"a", "b"}, {{"<c>", "d|e"}});
  EXPECT_NE(document.html().find("<h1>A &amp; B</h1>"), std::string::npos);
  EXPECT_NE(document.html().find("<td>&lt;c&gt;</td><td>d|e</td>"), std::string::npos);
  EXPECT_NE(document.markdown().find("| \\<c> | d\\|e |"), std::string::npos);
}

TEST(ExperimentsReport, KeyNamesTheCurvesOfAllPanels)
{
  const Curve here = {"here", "with lines", {{0., 1.}}};
  const Curve elsewhere = {"elsewhere", "with points", {{0., 1.}}};
  const std::string script =
      figureScript({{"f.svg", "F", 2, {{"p", "x", "y", "", {here}}, {"q", "x", "y", "", {here, elsewhere}}}}});
  EXPECT_NE(script.find("NaN with points title \"elsewhere\""), std::string::npos);
  std::size_t count = 0;
  for (std::size_t at = script.find("title \"here\""); at != std::string::npos;
       at = script.find("title \"here\"", at + 1)) {
    ++count;
  }
  EXPECT_EQ(count, 1u);
}

TEST(ExperimentsReport, PanelsOfNothingHaveRangesAllTheSame)
{
  // gnuplot stops at an axis that it finds no range for.
  const Curve none = {"none", "with lines", {}};
  const Curve zero = {"zero", "with lines", {{1., 0.}}};
  const Panel empty = {"p", "x", "y", "set yrange [0:1e-3<*]\n", {none}};
  const Panel logarithmic = {"p", "x", "y", logarithmicY, {zero}};
  for (const Panel &panel : {empty, logarithmic}) {
    const std::string script = figureScript({{"f.svg", "F", 1, {panel}}});
    const std::size_t last = script.rfind("set yrange ");
    ASSERT_NE(last, std::string::npos);
    EXPECT_EQ(script.substr(last, script.find('\n', last) - last), "set yrange [0.1:1]");
  }
}

TEST(ParallelWork, DoesEachItemOnce)
{
  for (const unsigned int threads : {1u, 2u, 5u}) {
    std::vector<std::atomic<int>> done(100);
    std::atomic<unsigned int> workers(0);
    std::size_t last = 0;
    forEachItem(
        done.size(), threads,
        [&]() {
          ++workers;
          return [&](std::size_t item) { ++done[item]; };
        },
        [&](std::size_t number, std::size_t all) {
          EXPECT_EQ(number, ++last);
          EXPECT_EQ(all, done.size());
        });
    EXPECT_EQ(workers, threads);
    EXPECT_EQ(last, done.size());
    EXPECT_TRUE(std::all_of(done.begin(), done.end(), [](const std::atomic<int> &count) { return count == 1; }));
  }
}

TEST(ParallelWork, PassesOnWhatAWorkerThrows)
{
  std::atomic<int> done(0);
  const auto work = [&]() {
    return [&](std::size_t item) {
      if (item == 3) {
        throw std::runtime_error("three");
      }
      // Items of no length would all be done before the first thread has thrown.
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      ++done;
    };
  };
  EXPECT_THROW(forEachItem(1000, 2, work, nullptr), std::runtime_error);
  EXPECT_LT(done, 999); // The other thread stops too.
}
