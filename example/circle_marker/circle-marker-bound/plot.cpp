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
 * The plot of circle-marker-bound.
 */

#include <algorithm>
#include <functional>
#include <sstream>

#include <visp3/core/vpMath.h>

#include "common/gnuplot.h"
#include "report.h"

namespace planner {
namespace {
using Value = std::function<std::optional<double>(const Row &)>;

// Curves in one panel that still can be told apart: plotStyle has as many.
constexpr std::size_t mostCurves = 7;
// Odds beyond which a wrong choice does not happen; and gnuplot's logarithmic axis ends somewhere.
constexpr double never = 1e-9;

struct Panel
{
  const char *name, *title, *label;
  Value value;
  std::optional<double> wanted; //!< In the panel's unit.
};

std::string dataName(const Panel &panel, std::size_t angle)
{
  return std::string(panel.name) + std::to_string(angle);
}

std::string dataOf(const Settings &settings, const std::vector<Row> &rows, const Panel &panel)
{
  std::string text;
  for (std::size_t angle = 0; angle < settings.angles.size(); ++angle) {
    Points points;
    for (const Row &row : rows) {
      const auto value = panel.value(row);
      if (row.angle == settings.angles[angle] && value) {
        points.push_back({row.distance, *value});
      }
    }
    text += dataBlock(dataName(panel, angle), points);
  }
  return text;
}

std::string plotOf(const Settings &settings, const Panel &panel, bool hasKey)
{
  std::ostringstream out;
  out << (hasKey ? "set key at screen 0.5, screen 0.01 center bottom maxrows 1 Left reverse width -1\n" : "unset key\n")
      << "set title \"" << panel.title << "\" offset 0,-0.5\nset ylabel \"" << panel.label << "\"\nplot ";
  const std::size_t curves = std::min(settings.angles.size(), mostCurves);
  for (std::size_t angle = 0; angle < curves; ++angle) {
    out << '$' << dataName(panel, angle) << " with linespoints linestyle " << angle + 1 << " title \""
        << settings.angles[angle] << "°\", ";
  }
  if (panel.wanted) {
    out << *panel.wanted << " with lines linecolor rgb \"black\" dashtype 3 title \"wanted\"\n";
  }
  else {
    out << "NaN with lines linecolor rgb \"black\" dashtype 3 "
        << (settings.wanted.any() ? "title \"wanted\"" : "notitle") << "\n";
  }
  return out.str();
}

std::optional<double> scaled(const std::optional<double> &value, double scale)
{
  return value ? std::optional<double>(scale * *value) : std::nullopt;
}
} // namespace

std::string plotScript(const Settings &settings, const std::vector<Row> &rows)
{
  constexpr double millimetres = 1000.;
  const Panel panels[] = {
      {"lateral", "Position across the line of sight", "σ of x, y [mm]",
       [](const Row &row) { return millimetres * std::max(row.bound.x, row.bound.y); },
       scaled(settings.wanted.xy, millimetres / settings.reserve)},
      {"depth", "Depth", "σ of z [mm]", [](const Row &row) { return millimetres * row.bound.z; },
       scaled(settings.wanted.z, millimetres / settings.reserve)},
      {"normal", "Normal", "RMS angle [°]", [](const Row &row) { return vpMath::deg(row.bound.normal); },
       scaled(settings.wanted.normal, vpMath::deg(1.) / settings.reserve)},
      {"wrong", "Mirrored pose taken for the true one", "share of images [%]",
       [](const Row &row) -> std::optional<double> {
         const auto &separation = row.separation;
         return separation && separation->wrongChoice > never ? std::optional<double>(100. * separation->wrongChoice)
                                                              : std::nullopt;
       },
       scaled(settings.wanted.wrong, 100.)},
  };
  std::ostringstream out;
  out << "# Draws the plot of circle-marker-bound: gnuplot bound.gp\n";
  for (const Panel &panel : panels) {
    out << dataOf(settings, rows, panel);
  }
  out << plotStyle << "set terminal svg size 900,760 font \"sans-serif,13\" background \"white\" enhanced\n"
      << "set output \"bound.svg\".suffix\nunset bmargin\nunset rmargin\nset format y \"%g\"\n"
      << "set multiplot layout 2,2 margins screen 0.1,0.97,0.14,0.95 spacing screen 0.12,0.13\n"
      << "set logscale xy\nset xtics (0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100)\n"
      << "set xrange [" << 0.95 * settings.minDistance << ":" << 1.05 * settings.maxDistance
      << "]\nset xlabel \"distance [m]\" offset 0,0.4\n";
  for (const Panel &panel : panels) {
    out << (std::string(panel.name) == "wrong" ? "set yrange [1e-7:100]\n" : "")
        << plotOf(settings, panel, std::string(panel.name) == "lateral");
  }
  out << "unset multiplot\nunset output\n";
  return out.str();
}
} // namespace planner
