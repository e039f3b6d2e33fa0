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
 * The plots of the report page.
 */

#include <algorithm>
#include <cmath>
#include <functional>

#include "parts.h"
#include "plots.h"
#include "ranges.h"

namespace accuracy {
namespace {
using common::Curve;
using common::Figure;
using common::Panel;
using common::Points;

// A root mean square over fewer images is a guess: it errs by 25 %.
constexpr std::size_t leastImages = 8;

/*! What errors are drawn against. */
struct Axis
{
  const char *file, *title, *label, *setup;
  double Record::*value;
  std::vector<double> bins;
};

const std::vector<Axis> &axes()
{
  static const std::vector<Axis> all = {
      {"ratio-diameter.svg",
       "Error over bound against the diameter of the marker's image",
       "diameter of the ring's image [px]",
       "set logscale x\nset xrange [16:420]\nset xtics (17, 34, 68, 136, 272)\n",
       &Record::diameter,
       {17., 24., 34., 48., 68., 96., 136., 192., 272., 400.}},
      {"ratio-tilt.svg",
       "Error over bound against the viewing angle",
       "angle between normal and line of sight [°]",
       "set xrange [0:80]\nset xtics 15\n",
       &Record::tilt,
       {8., 15., 22., 30., 38., 45., 52., 60., 68., 75.}},
      {"ratio-noise.svg",
       "Error over bound against the noise",
       "standard deviation of the noise [grey levels]",
       "set xrange [0.8:5.2]\nset xtics 1\n",
       &Record::noise,
       {1., 1.5, 2., 2.5, 3., 3.5, 4., 4.5, 5.}},
      {"ratio-blur.svg",
       "Error over bound against the blur",
       "standard deviation of the blur [px]",
       "set xrange [0.45:1.25]\nset xtics 0.2\n",
       &Record::blur,
       {0.5, 0.6, 0.7, 0.8, 0.9, 1., 1.1, 1.2}},
  };
  return all;
}

struct Line
{
  std::string title, style;
  Records records;
};

std::vector<Line> linesOf(const Records &records)
{
  const Records limits = chosen(records, inPart("limits"));
  const Records tags = chosen(records, inPart("apriltag"));
  std::vector<Line> lines;
  const char *const styles[] = {"with linespoints linestyle 1", "with linespoints linestyle 6",
                                "with linespoints linestyle 7"};
  for (std::size_t i = 0; i < std::size(families); ++i) {
    lines.push_back({families[i], styles[i], chosen(limits, inGroup(families[i]))});
  }
  lines.push_back(
      {"AprilTag 36h11, decimation 1", "with linespoints linestyle 2", chosen(tags, byMethod("apriltag-1"))});
  lines.push_back(
      {"AprilTag 36h11, decimation 2", "with linespoints linestyle 3", chosen(tags, byMethod("apriltag-2"))});
  lines.erase(std::remove_if(lines.begin(), lines.end(), [](const Line &line) { return line.records.empty(); }),
              lines.end());
  return lines;
}

Points binned(const Records &records, const Axis &axis, const std::function<double(const Summary &)> &value)
{
  Points points;
  for (std::size_t i = 0; i + 1 < axis.bins.size(); ++i) {
    const double from = axis.bins[i];
    const double to = axis.bins[i + 1];
    const Records here = chosen(records, [&](const Record &r) { return r.*axis.value >= from && r.*axis.value < to; });
    const Summary summary = summaryOf(here);
    if (summary.right >= leastImages) {
      points.push_back({0.5 * (from + to), value(summary)});
    }
  }
  return points;
}

Figure figureOf(const Axis &axis, const std::vector<Line> &lines)
{
  struct Part
  {
    const char *title;
    std::function<double(const Summary &)> value;
  };
  const Part parts[] = {
      {"Across the line of sight (x, y)",
       [](const Summary &s) { return std::sqrt(0.5 * (s.ratio[X] * s.ratio[X] + s.ratio[Y] * s.ratio[Y])); }},
      {"Depth (z)", [](const Summary &s) { return s.ratio[Z]; }},
      {"Normal", [](const Summary &s) { return s.ratio[NORMAL]; }},
  };
  Figure figure = {axis.file, axis.title, 3, {}};
  for (const Part &part : parts) {
    Panel panel = {part.title,
                   axis.label,
                   "RMS of error / bound",
                   std::string(axis.setup) + "set logscale y\nset yrange [0.7:100]\n",
                   {}};
    for (const Line &line : lines) {
      panel.curves.push_back({line.title, line.style, binned(line.records, axis, part.value)});
    }
    panel.curves.push_back({"bound", "with lines linestyle 5", {{axis.bins.front(), 1.}, {axis.bins.back(), 1.}}});
    figure.panels.push_back(panel);
  }
  return figure;
}

/*! Distribution function of chi-squared with 5 or 6 degrees of freedom, in closed form. */
double chiSquared(double x, double dof)
{
  return dof == 6. ? 1. - std::exp(-0.5 * x) * (1. + 0.5 * x + 0.125 * x * x)
                   : std::erf(std::sqrt(0.5 * x)) - std::sqrt(2. * x / M_PI) * std::exp(-0.5 * x) * (1. + x / 3.);
}

/*! Share of the images whose squared error by the reported covariance is as rare as this, or not as rare. */
Curve honestyOf(const Line &line)
{
  std::vector<double> probabilities;
  for (const Record &record : line.records) {
    if (record.isFound() && !record.isWrong() && std::isfinite(record.mahalanobis)) {
      probabilities.push_back(chiSquared(record.mahalanobis, record.dof));
    }
  }
  std::sort(probabilities.begin(), probabilities.end());
  Curve curve = {line.title, line.style, {}};
  constexpr std::size_t mostPoints = 50;
  const std::size_t count = probabilities.size();
  for (std::size_t i = 0; i < std::min(count, mostPoints); ++i) {
    const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(std::min(count, mostPoints));
    curve.points.push_back({probabilities[static_cast<std::size_t>(share * static_cast<double>(count))], share});
  }
  return curve;
}

Figure honesty(const std::vector<Line> &lines)
{
  Figure figure = {"honesty.svg", "Is the reported covariance true?", 3, {}};
  Panel panel = {"Squared error by the covariance",
                 "share that chi-squared predicts",
                 "share of the images",
                 "set xrange [0:1]\nset yrange [0:1]\n",
                 {}};
  for (const Line &line : lines) {
    if (line.title.rfind("AprilTag", 0) != 0) {
      panel.curves.push_back(honestyOf(line));
    }
  }
  panel.curves.push_back({"ideal", "with lines linestyle 5", {{0., 0.}, {1., 1.}}});
  figure.panels.push_back(panel);

  Panel ratios = {"Depth: error / reported deviation",
                  axes()[0].label,
                  "RMS",
                  std::string(axes()[0].setup) + "set yrange [0:2]\n",
                  {}};
  Panel normals = {"Normal: error / reported deviation",
                   axes()[0].label,
                   "RMS",
                   std::string(axes()[0].setup) + "set yrange [0:2]\n",
                   {}};
  for (const Line &line : lines) {
    if (line.title.rfind("AprilTag", 0) != 0) {
      ratios.curves.push_back(
          {line.title, line.style, binned(line.records, axes()[0], [](const Summary &s) { return s.optimism[Z]; })});
      normals.curves.push_back({line.title, line.style,
                                binned(line.records, axes()[0], [](const Summary &s) { return s.optimism[NORMAL]; })});
    }
  }
  for (Panel *other : {&ratios, &normals}) {
    other->curves.push_back({"ideal", "with lines linestyle 5", {{17., 1.}, {400., 1.}}});
    figure.panels.push_back(*other);
  }
  return figure;
}
} // namespace

std::vector<Figure> figuresOf(const Records &records)
{
  std::vector<Figure> figures;
  const std::vector<Line> lines = linesOf(records);
  if (lines.empty()) {
    return figures;
  }
  for (const Axis &axis : axes()) {
    figures.push_back(figureOf(axis, lines));
  }
  figures.push_back(honesty(lines));
  return figures;
}
} // namespace accuracy
