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
 * The figures of the resilience: rate and errors against each disturbance.
 */

#include <algorithm>

#include "curves.h"
#include "figures.h"

namespace experiments {
namespace {
const std::vector<View> views = {ringFirst, circle, aprilTag};

using SummaryValue = std::function<double(const Summary &)>;

/*! The value of a summary against the level of the disturbance; levels with too few poses are left out. */
Curve curveOf(const Experiment &experiment, const RunData &data, const std::string &group, const View &view,
              std::size_t leastFound, const SummaryValue &value)
{
  Curve curve = {view.title, lineStyle(view), {}};
  for (std::size_t i = 0; i < experiment.series.size(); ++i) {
    if (experiment.series[i].group == group) {
      const Summary summary = summaryOf(samplesOf(data[i], view.method), view.solutions);
      if (summary.frames > 0 && summary.found >= leastFound) {
        curve.points.push_back({experiment.series[i].level, value(summary)});
      }
    }
  }
  return curve;
}

Panel panelOf(const Experiment &experiment, const RunData &data, const std::string &group, const std::string &xLabel,
              const std::string &yLabel, const std::string &setup, std::size_t leastFound, const SummaryValue &value)
{
  Panel panel = {"", xLabel, yLabel, setup, {}};
  for (const View &view : viewsIn(data, views)) {
    panel.curves.push_back(curveOf(experiment, data, group, view, leastFound, value));
  }
  return panel;
}

CaptionedFigure figureOf(const Experiment &experiment, const RunData &data, const Series &first)
{
  const std::string label = first.title.substr(0, first.title.rfind(": "));
  const auto rate = [](const Summary &s) {
    return 100. * static_cast<double>(s.found) / static_cast<double>(s.frames);
  };
  const auto wrong = [](const Summary &s) {
    return 100. * static_cast<double>(s.wrong) / static_cast<double>(s.frames);
  };
  const auto position = [](const Summary &s) { return s.position.median; };
  const auto normal = [](const Summary &s) { return s.angle.median; };
  constexpr std::size_t few = 5; // Fewer poses have no median that says anything.
  Figure figure = {"resilience-" + first.group + ".svg", "Against " + label, 4, {}};
  figure.panels = {
      panelOf(experiment, data, first.group, label, "found [%]", "set yrange [0:105]\n", 0, rate),
      panelOf(experiment, data, first.group, label, "median |C - eC| [mm]", logarithmicY, few, position),
      panelOf(experiment, data, first.group, label, "median angle between N and eN [°]", logarithmicY, few, normal),
      panelOf(experiment, data, first.group, label, "misleading poses [% of frames]", "set yrange [0:5<*]\n", 0,
              wrong)};
  return {figure,
          "Frames with the marker found, median errors of the poses, and frames with a pose that would mislead: "
          "the normal off by more than 20° or the centre by more than a tenth of the distance."};
}
} // namespace

std::vector<CaptionedFigure> figuresOfResilience(const Experiment &experiment, const RunData &data)
{
  std::vector<CaptionedFigure> figures;
  std::string group;
  for (const Series &series : experiment.series) {
    if (series.group != group) {
      group = series.group;
      figures.push_back(figureOf(experiment, data, series));
    }
  }
  return figures;
}
} // namespace experiments
