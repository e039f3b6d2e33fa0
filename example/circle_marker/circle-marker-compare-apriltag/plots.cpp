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
 * The plots, as a script for gnuplot that holds its data.
 */

#include <algorithm>
#include <cmath>
#include <functional>
#include <sstream>

#include <visp3/core/vpMath.h>

#include "common/gnuplot.h"
#include "plots.h"
#include "summary.h"

namespace compare {
namespace {
// Bins with fewer frames have no median that says anything.
constexpr std::size_t leastFrames = 5;
// Frames that see the marker at a glancing angle have detection rates of their own.
constexpr double glancing = 60.; // Degrees.
// Distances are even up to a depth of 18.4 m in the middle of the image, hence up to 20.6 m in its corners.
const std::vector<double> distanceBins = {0., 1., 2., 3., 4., 6., 8., 10., 12., 14., 16., 18., 21.};
// Rates need more frames than medians, hence wider bins.
const std::vector<double> rateBins = {0., 3., 6., 9., 12., 15., 18., 21.};
const std::vector<double> tiltBins = {0., 5., 10., 20., 30., 40., 50., 60., 70., 80., 90.};

using Value = std::function<double(const Trial &)>;
using Filter = std::function<bool(const Trial &)>;

double distance(const Trial &trial)
{
  return distanceOf(trial.cMo);
}
double tilt(const Trial &trial)
{
  return vpMath::deg(tiltOf(trial.cMo));
}
Value positionError(Method method)
{
  return [method](const Trial &trial) { return 1000. * trial[method].error->position; }; // Millimetres.
}
Value normalError(Method method)
{
  return [method](const Trial &trial) { return vpMath::deg(trial[method].error->normal); };
}
Filter foundBy(Method method)
{
  return [method](const Trial &trial) { return trial[method].error.has_value(); };
}

std::vector<Trial> chosen(const std::vector<Trial> &trials, const Filter &filter)
{
  std::vector<Trial> result;
  std::copy_if(trials.begin(), trials.end(), std::back_inserter(result), filter);
  return result;
}

std::string scatter(const std::string &name, const std::vector<Trial> &trials, const Value &x, const Value &y)
{
  Points points;
  for (const Trial &trial : trials) {
    points.push_back({x(trial), y(trial)});
  }
  return dataBlock(name, points);
}

/*! The medians of x and of `summary` over the trials of each bin of x that holds enough of them. */
std::string binned(const std::string &name, const std::vector<Trial> &trials, const std::vector<double> &bins,
                   std::size_t least, const Value &x, const Value &y,
                   const std::function<double(const Statistics &)> &summary)
{
  Points points;
  for (std::size_t bin = 0; bin + 1 < bins.size(); ++bin) {
    const std::vector<Trial> inside =
        chosen(trials, [&](const Trial &trial) { return x(trial) >= bins[bin] && x(trial) < bins[bin + 1]; });
    if (inside.size() < least) {
      continue;
    }
    std::vector<double> xs;
    std::vector<double> ys;
    for (const Trial &trial : inside) {
      xs.push_back(x(trial));
      ys.push_back(y(trial));
    }
    points.push_back({statisticsOf(xs).median, summary(statisticsOf(ys))});
  }
  return dataBlock(name, points);
}

/*! Name of a method's data: gnuplot's names have no hyphens. */
std::string dataName(const std::string &kind, Method method)
{
  std::string name = kind + "_" + methodNames[indexOf(method)];
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

std::string errorData(const std::vector<Trial> &trials)
{
  const auto median = [](const Statistics &statistics) { return statistics.median; };
  std::string text;
  for (std::size_t i = 0; i < methodCount; ++i) {
    const Method method = static_cast<Method>(i);
    const std::vector<Trial> found = chosen(trials, foundBy(method));
    text += scatter(dataName("position", method), found, distance, positionError(method)) +
            scatter(dataName("normal", method), found, tilt, normalError(method)) +
            binned(dataName("position_median", method), found, distanceBins, leastFrames, distance,
                   positionError(method), median) +
            binned(dataName("normal_median", method), found, tiltBins, leastFrames, tilt, normalError(method), median);
  }
  return text;
}

std::string rateData(const std::vector<Trial> &trials)
{
  const auto mean = [](const Statistics &statistics) { return statistics.mean; };
  const std::vector<Trial> steep = chosen(trials, [](const Trial &trial) { return tilt(trial) < glancing; });
  const std::vector<Trial> flat = chosen(trials, [](const Trial &trial) { return tilt(trial) >= glancing; });
  std::string text;
  for (const Method method : {Method::Circle, Method::AprilTag1, Method::AprilTag2}) {
    const Value found = [method](const Trial &trial) { return trial[method].error ? 100. : 0.; };
    text += binned(dataName("rate_below", method), steep, rateBins, leastFrames, distance, found, mean) +
            binned(dataName("rate_above", method), flat, rateBins, leastFrames, distance, found, mean);
  }
  return text;
}

constexpr const char *positionPlot = R"(
set output "position-error.svg".suffix
set title "Error of the position against the distance: frames of all cells, and medians"
set logscale xy
set xrange [0.4:25]
set xtics (0.5, 1, 2, 5, 10, 20)
set yrange [*:*]
set format y "%g"
set xlabel "distance of the marker’s centre [m]"
set ylabel "|C - eC| [mm]"
plot $position_circle with points linestyle 11 notitle, \
     $position_apriltag_1_half_pixel with points linestyle 12 notitle, \
     $position_median_circle with linespoints linestyle 1 title "circle", \
     $position_median_apriltag_1_half_pixel with linespoints linestyle 2 title "AprilTag, decimation 1, half-pixel", \
     $position_median_apriltag_2_half_pixel with linespoints linestyle 3 title "AprilTag, decimation 2, half-pixel", \
     $position_median_apriltag_1 with lines linestyle 4 title "AprilTag, decimation 1, as delivered"
unset output
)";

constexpr const char *normalPlot = R"(
set output "normal-error.svg".suffix
set title "Error of the normal against the viewing angle: frames of all cells, and medians"
unset logscale x
set xrange [0:90]
set xtics 0, 10, 90
set xlabel "angle between normal and line of sight [°]"
set ylabel "angle between measured and true normal [°]"
plot $normal_circle with points linestyle 11 notitle, \
     $normal_apriltag_1_half_pixel with points linestyle 12 notitle, \
     $normal_median_circle with linespoints linestyle 1 title "circle", \
     $normal_median_apriltag_1_half_pixel with linespoints linestyle 2 title "AprilTag, decimation 1, half-pixel", \
     $normal_median_apriltag_2_half_pixel with linespoints linestyle 3 title "AprilTag, decimation 2, half-pixel", \
     $normal_median_apriltag_1 with lines linestyle 4 title "AprilTag, decimation 1, as delivered"
unset output
)";

constexpr const char *ratePlot = R"(
set output "detection-rate.svg".suffix
set key maxrows 3
set bmargin at screen 0.23
set title "Share of frames with the right marker found, against the distance: frames of all cells"
unset logscale y
set xrange [0:21]
set xtics 0, 2, 20
set yrange [0:105]
set ytics 0, 20, 100
set xlabel "distance of the marker’s centre [m]"
set ylabel "found [%]"
plot $rate_below_apriltag_2 with linespoints linestyle 3 title "AprilTag, decimation 2, below 60°", \
     $rate_above_apriltag_2 with linespoints linestyle 7 title "AprilTag, decimation 2, 60° to 90°", \
     $rate_below_apriltag_1 with linespoints linestyle 2 linewidth 6 title "AprilTag, decimation 1, below 60°", \
     $rate_above_apriltag_1 with linespoints linestyle 6 title "AprilTag, decimation 1, 60° to 90°", \
     $rate_below_circle with linespoints linestyle 1 title "circle, angle below 60°", \
     $rate_above_circle with linespoints linestyle 5 title "circle, 60° to 90°"
unset output
)";
} // namespace

std::string plotScript(const Settings &settings, const std::vector<Trial> &trials)
{
  std::ostringstream out;
  out << "# Draws the plots of circle-marker-compare-apriltag (seed " << settings.seed << ", " << settings.frames
      << " frames in each cell): gnuplot compare.gp\n"
      << errorData(trials) << rateData(trials) << plotStyle << positionPlot << normalPlot << ratePlot;
  return out.str();
}
} // namespace compare
