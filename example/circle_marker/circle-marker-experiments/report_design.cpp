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
 * The section of the report on the design of the marker, and its figures.
 */

#include "common/numbers.h"
#include "curves.h"
#include "design_figures.h"
#include "figures.h"
#include "report.h"

namespace experiments {
namespace {
using Value = std::function<double(const DesignFigures &)>;

Panel panelOf(const Experiment &experiment, const RunData &data, const std::string &group, const std::string &yLabel,
              const std::vector<std::pair<std::string, Value>> &values)
{
  Panel panel = {"", "", yLabel, "set yrange [0:1e-3<*]\n", {}};
  unsigned int style = 1;
  for (const auto &value : values) {
    Curve curve = {value.first, "with linespoints linestyle " + std::to_string(style++), {}};
    for (std::size_t i = 0; i < experiment.series.size(); ++i) {
      const Series &series = experiment.series[i];
      if (series.group == group) {
        panel.xLabel = series.title.substr(0, series.title.rfind(": "));
        curve.points.push_back({series.level, value.second(designFiguresOf(data[i]))});
      }
    }
    panel.curves.push_back(curve);
  }
  return panel;
}
} // namespace

std::vector<CaptionedFigure> figuresOfDesign(const Experiment &experiment, const RunData &data)
{
  std::vector<CaptionedFigure> figures;
  std::string group;
  for (const Series &series : experiment.series) {
    if (series.group == group || series.group == "family") {
      continue;
    }
    group = series.group;
    const std::string label = series.title.substr(0, series.title.rfind(": "));
    Figure figure = {"design-" + group + ".svg", "Against the " + label + ", in units of the ring's radius", 4, {}};
    figure.panels = {panelOf(experiment, data, group, "depth [mm], median",
                             {{"limit", [](const DesignFigures &f) { return f.depthLimit; }},
                              {"detector", [](const DesignFigures &f) { return f.depthError; }}}),
                     panelOf(experiment, data, group, "normal [°], median",
                             {{"limit", [](const DesignFigures &f) { return f.normalLimit; }}}),
                     panelOf(experiment, data, group, "poses with weak separation [%]",
                             {{"limit", [](const DesignFigures &f) { return 100. * f.weakSeparation; }}}),
                     panelOf(experiment, data, group, "reach [m]",
                             {{"", [](const DesignFigures &) { return 0.; }},
                              {"detector", [](const DesignFigures &f) { return f.reach; }}})};
    figure.panels.back().curves.erase(figure.panels.back().curves.begin()); // The detector's colour is the second.
    figures.push_back({figure, "Limit: standard deviations of the Cramér-Rao bound; separation: mean log-odds between "
                               "the two solutions below 10. Detector: median |error| of the depth; the depth to which "
                               "its share of markers found and identified reaches, at angles to 60°."});
  }
  return figures;
}

void addDesign(const Experiment &experiment, const RunData &data, Document &document)
{
  document.addHeading(experiment.title);
  document.addParagraph(
      "The thesis left this open (6.2.4). One measure after another, all others as by default; the sheet stays the "
      "same, and so do the poses: 5 m to 22 m, to 60°. Measures are in units of the ring's outer radius. The limit is "
      "the Cramér-Rao bound with an unknown surround, medians over the poses; separation is of the two solutions, weak "
      "if their mean log-odds are below 10; the detector is the real one, told the design.");
  std::vector<std::vector<std::string>> table;
  for (std::size_t i = 0; i < experiment.series.size(); ++i) {
    const DesignFigures f = designFiguresOf(data[i]);
    table.push_back({experiment.series[i].title, digits(f.lateralLimit), digits(f.depthLimit), digits(f.normalLimit),
                     digits(f.separation), digits(100. * f.weakSeparation), digits(f.depthError),
                     digits(100. * f.mirrored), digits(100. * f.found), digits(f.reach), std::to_string(f.frames)});
  }
  addFigures(figuresOfDesign(experiment, data), document);
  document.addTable("All designs",
                    {"", "limit across, mm", "limit of depth, mm", "limit of normal, °", "separation, σ",
                     "weak separation, %", "detector: depth, mm", "mirrored, %", "found, %", "reach, m", "frames"},
                    table);
}
} // namespace experiments
