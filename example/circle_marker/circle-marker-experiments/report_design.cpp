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

// Those whose markers the detector cannot read: only what the image itself allows is drawn.
constexpr const char *limitsOnly = "sectors";

/*!
  Whether the detector can look for the marker: one of its families, or a ring with nothing inside that it knows as a
  plain ring.
*/
bool isSought(const Series &series)
{
  const std::optional<Design> design = series.scene(0, 1).design;
  if (!design || !design->composition) {
    return true;
  }
  const Composition &parts = *design->composition;
  return parts.rings.size() == 1 && parts.track[0] >= parts.rings.front()[1];
}

std::string measureOf(const Series &series)
{
  return series.title.substr(0, series.title.rfind(": "));
}

/*! A curve over the designs of a group. */
Curve curveOf(const Experiment &experiment, const RunData &data, const std::string &group, const std::string &title,
              unsigned int style, const Value &value)
{
  Curve curve = {title, "with linespoints linestyle " + std::to_string(style), {}};
  for (std::size_t i = 0; i < experiment.series.size(); ++i) {
    if (experiment.series[i].group == group) {
      curve.points.push_back({experiment.series[i].level, value(designFiguresOf(data[i]))});
    }
  }
  return curve;
}

CaptionedFigure figureOfMeasure(const Experiment &experiment, const RunData &data, const Series &first)
{
  const std::string label = measureOf(first);
  const bool hasUnits = first.group != limitsOnly;
  Figure figure = {"design-" + first.group + ".svg",
                   "Against the " + label + (hasUnits ? ", in units of the ring's radius" : ""),
                   3,
                   {}};
  const auto add = [&](const std::string &yLabel, const Value &limit, const Value &detector) {
    Panel panel = {"", label, yLabel, "set yrange [0:1e-3<*]\n", {}};
    if (limit) {
      panel.curves.push_back(curveOf(experiment, data, first.group, "limit", 1, limit));
    }
    if (detector && first.group != limitsOnly) {
      panel.curves.push_back(curveOf(experiment, data, first.group, "detector", 2, detector));
    }
    if (!panel.curves.empty()) {
      figure.panels.push_back(panel);
    }
  };
  add(
      "depth [mm], median", [](const DesignFigures &f) { return f.depthLimit; },
      [](const DesignFigures &f) { return f.depthError; });
  add("normal [°], median", [](const DesignFigures &f) { return f.normalLimit; }, {});
  add("separation of the two poses [σ], median", [](const DesignFigures &f) { return f.separation; }, {});
  add("to the marker most like it [σ], median", [](const DesignFigures &f) { return f.reading; }, {});
  add("reach [m]", {}, [](const DesignFigures &f) { return f.reach; });
  return {figure, "Limit: standard deviations of the Cramér-Rao bound; distances between the images of the two "
                  "solutions and between those of the marker and the one most like it, in standard deviations of the "
                  "noise. Detector: the standard deviation of the depth that the median |error| stands for; the depth "
                  "to which its share of markers found and "
                  "identified reaches, at angles to 60°."};
}

/*! A bar for each marker of another kind; their letters stand below. */
Panel rivalPanel(const Experiment &experiment, const RunData &data, const std::string &yLabel, unsigned int style,
                 const Value &value)
{
  Panel panel = {"", "", yLabel, "", {}};
  Curve curve = {"", "using 1:2:(0.75) with boxes fill solid noborder linestyle " + std::to_string(style), {}};
  std::string tics;
  std::size_t count = 0;
  for (std::size_t i = 0; i < experiment.series.size(); ++i) {
    const Series &series = experiment.series[i];
    if (series.group == rivalGroup) {
      if (style == 1 || isSought(series)) {
        curve.points.push_back({series.level, value(designFiguresOf(data[i]))});
      }
      ++count;
      tics += (tics.empty() ? "" : ", ") + ("\"" + series.title.substr(0, 1) + "\" ") + digits(series.level);
    }
  }
  panel.curves = {curve};
  if (style == 1 && !curve.points.empty()) {
    // The default's level across the panel, to compare by.
    panel.curves.push_back(level("", 0.3, static_cast<double>(curve.points.size()) + 0.7, curve.points.front()[1]));
  }
  panel.setup = "set yrange [0:1e-3<*]\nset xrange [0.3:" + std::to_string(count) + ".7]\nset xtics (" + tics + ")\n";
  return panel;
}

CaptionedFigure figureOfRivals(const Experiment &experiment, const RunData &data)
{
  Figure figure = {"design-rivals.svg", "Markers of other kinds on the same sheet", 3, {}};
  const auto add = [&](const std::string &yLabel, unsigned int style, const Value &value) {
    figure.panels.push_back(rivalPanel(experiment, data, yLabel, style, value));
  };
  add("limit across [mm], median", 1, [](const DesignFigures &f) { return f.lateralLimit; });
  add("limit of the depth [mm], median", 1, [](const DesignFigures &f) { return f.depthLimit; });
  add("limit of the normal [°], median", 1, [](const DesignFigures &f) { return f.normalLimit; });
  add("separation of the two poses [σ], median", 1, [](const DesignFigures &f) { return f.separation; });
  add("to the marker most like it [σ], median", 1, [](const DesignFigures &f) { return f.reading; });
  add("reach of the detector [m]", 2, [](const DesignFigures &f) { return f.reach; });
  std::string letters;
  for (const Series &series : experiment.series) {
    if (series.group == rivalGroup) {
      letters += (letters.empty() ? "" : "; ") + series.title;
    }
  }
  return {figure, letters + ". Blue: limits of the image; orange: the real detector, which in D and E looks for the "
                            "ring alone and in J is ViSP's; it has no way to look for B, C, F and I."};
}
} // namespace

std::vector<CaptionedFigure> figuresOfDesign(const Experiment &experiment, const RunData &data)
{
  std::vector<CaptionedFigure> figures;
  std::string group;
  for (const Series &series : experiment.series) {
    if (series.group != group && series.group != "family" && series.group != rivalGroup) {
      figures.push_back(figureOfMeasure(experiment, data, series));
    }
    group = series.group;
  }
  figures.push_back(figureOfRivals(experiment, data));
  return figures;
}

void addDesign(const Experiment &experiment, const RunData &data, Document &document)
{
  document.addHeading(experiment.title);
  document.addParagraph(
      "The thesis left this open (6.2.4). One measure after another, all others as by default; the sheet stays the "
      "same, and so do the poses: 5 m to 22 m, to 60°. Measures are in units of the ring's outer radius. The limit is "
      "the Cramér-Rao bound with an unknown surround, medians over the poses; separation is of the two solutions, weak "
      "if their mean log-odds are below 10. To the marker most like it: the distance between the two images, in "
      "standard deviations of the noise; below 10 an ideal reader errs once in 3 million. The detector is the real "
      "one, "
      "told the design; codes outside the ring it cannot read, it seeks the ring alone (D, E). AprilTag's is ViSP's. "
      "Found: without poses that mislead.");
  std::vector<std::vector<std::string>> table;
  for (std::size_t i = 0; i < experiment.series.size(); ++i) {
    const DesignFigures f = designFiguresOf(data[i]);
    const bool hasDetector = isSought(experiment.series[i]);
    const auto ofDetector = [hasDetector](double value) { return hasDetector ? digits(value) : "-"; };
    table.push_back({experiment.series[i].title, digits(f.lateralLimit), digits(f.depthLimit), digits(f.normalLimit),
                     digits(f.separation), digits(100. * f.weakSeparation), f.reading > 0. ? digits(f.reading) : "-",
                     ofDetector(f.depthError), ofDetector(100. * f.mirrored), ofDetector(100. * f.found),
                     ofDetector(f.reach), std::to_string(f.frames)});
  }
  addFigures(figuresOfDesign(experiment, data), document);
  document.addTable("All designs",
                    {"", "limit across, mm", "limit of depth, mm", "limit of normal, °", "separation, σ",
                     "weak separation, %", "to the marker most like it, σ", "detector: depth, mm", "mirrored, %",
                     "found, %", "reach, m", "frames"},
                    table);
}
} // namespace experiments
