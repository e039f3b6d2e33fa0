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
 * Figures of several panels, drawn by gnuplot.
 */

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <sstream>

#include "figure.h"

namespace common {
namespace {
// Pixels of the pictures: three panels make a page's width.
constexpr double panelWidth = 400.;
constexpr double panelHeight = 310.;
constexpr double left = 75.; // Margins of a panel, for tics and labels.
constexpr double right = 15.;
constexpr double top = 32.;
constexpr double bottom = 56.;
constexpr double titleHeight = 34.;
constexpr double keyHeight = 54.; // Two lines.

/*! Colours that the colour-blind tell apart as well (Okabe and Ito, 2002). */
constexpr const char *styles = R"(if (!exists("suffix")) suffix = ""
set encoding utf8
unset mxtics
unset mytics
set border 3 linecolor rgb "#666666"
set tics nomirror scale 0.5 textcolor rgb "#222222"
set style line 1 linecolor rgb "#0072B2" linewidth 2 pointtype 7 pointsize 0.5
set style line 2 linecolor rgb "#D55E00" linewidth 2 pointtype 5 pointsize 0.5
set style line 3 linecolor rgb "#CC79A7" linewidth 2 pointtype 9 pointsize 0.6
set style line 4 linecolor rgb "#888888" linewidth 2 dashtype 2 pointtype 2 pointsize 0.6
set style line 5 linecolor rgb "#000000" linewidth 1.5 dashtype 3 pointtype 2 pointsize 0.4
set style line 6 linecolor rgb "#009E73" linewidth 2 pointtype 6 pointsize 0.6
set style line 7 linecolor rgb "#E69F00" linewidth 2 pointtype 4 pointsize 0.5
set style line 11 linecolor rgb "#440072B2" pointtype 7 pointsize 0.25
set style line 12 linecolor rgb "#44D55E00" pointtype 7 pointsize 0.4
set style line 13 linecolor rgb "#44CC79A7" pointtype 7 pointsize 0.25
set style line 16 linecolor rgb "#009E73" pointtype 6 pointsize 0.7
)";

/*! Where a panel is, as shares of the picture. */
std::string margins(const Figure &figure, std::size_t index, double width, double height)
{
  const double x = panelWidth * static_cast<double>(index % figure.columns);
  const double y = titleHeight + panelHeight * static_cast<double>(index / figure.columns);
  std::ostringstream out;
  out << "set lmargin at screen " << (x + left) / width << "\nset rmargin at screen "
      << (x + panelWidth - right) / width << "\nset tmargin at screen " << 1. - (y + top) / height
      << "\nset bmargin at screen " << 1. - (y + panelHeight - bottom) / height << "\n";
  return out.str();
}

/*! The ends of what is drawn on an axis; the least is above the most if nothing is. */
std::array<double, 2> extentOf(const Panel &panel, std::size_t axis)
{
  const bool isLogarithmic = panel.setup.find("logscale y") != std::string::npos;
  std::array<double, 2> extent = {HUGE_VAL, -HUGE_VAL};
  for (const Curve &curve : panel.curves) {
    for (const auto &point : curve.points) {
      if (std::isfinite(point[0]) && std::isfinite(point[1]) && (point[1] > 0. || !isLogarithmic)) {
        extent[0] = std::min(extent[0], point[axis]);
        extent[1] = std::max(extent[1], point[axis]);
      }
    }
  }
  return extent;
}

/*! A panel's ranges and setup. What gnuplot cannot find itself are ranges of no points, or of points at one place. */
std::string setupOf(const Panel &panel)
{
  const std::string nothing = "[0.1:1]\n"; // Above 0: the axis may be logarithmic.
  std::ostringstream out;
  for (const std::size_t axis : {0u, 1u}) {
    const auto [least, most] = extentOf(panel, axis);
    out << "set " << (axis == 0 ? 'x' : 'y') << "range ";
    if (least == most) {
      constexpr double share = 0.1;
      const double room = least == 0. ? 1. : share * std::fabs(least);
      out << "[" << least - room << ":" << most + room << "]\n";
    }
    else {
      out << (least > most ? nothing : "[*:*]\n");
    }
  }
  out << panel.setup;
  const auto [least, most] = extentOf(panel, 1);
  if (least > most) {
    out << "set yrange " << nothing;
  }
  else if (most == 0. && least == 0. && panel.setup.find("*]") != std::string::npos) {
    out << "set yrange [0:1]\n"; // Half of the range is the setup's own, the other cannot be found.
  }
  return out.str();
}

std::string quoted(const std::string &text)
{
  std::string result = "\"";
  for (const char letter : text) {
    result += letter == '"' || letter == '\\' ? std::string("\\") + letter : std::string(1, letter);
  }
  return result + "\"";
}

/*!
  The plot command of a panel. The first panel has the key of all; what it does not draw itself but others do is added
  to it as a curve of no points.
*/
std::string plotCommand(const Figure &figure, std::size_t index, const std::string &dataPrefix)
{
  std::ostringstream out;
  std::set<std::string> titles;
  std::string separator = "plot ";
  const auto entry = [&](const std::string &data, const Curve &curve, bool isNamed) {
    out << separator << data << ' ' << curve.style
        << (isNamed ? " title " + quoted(curve.title) : std::string(" notitle"));
    separator = ", \\\n     ";
  };
  const Panel &panel = figure.panels[index];
  for (std::size_t i = 0; i < panel.curves.size(); ++i) {
    const Curve &curve = panel.curves[i];
    entry("$" + dataPrefix + std::to_string(i), curve,
          index == 0 && !curve.title.empty() && titles.insert(curve.title).second);
  }
  for (std::size_t other = 1; index == 0 && other < figure.panels.size(); ++other) {
    for (const Curve &curve : figure.panels[other].curves) {
      if (!curve.title.empty() && titles.insert(curve.title).second) {
        entry("NaN", curve, true);
      }
    }
  }
  if (panel.curves.empty()) {
    out << separator << "NaN notitle";
  }
  return out.str() + "\n";
}

bool hasKey(const Figure &figure)
{
  return std::any_of(figure.panels.begin(), figure.panels.end(), [](const Panel &panel) {
    return std::any_of(panel.curves.begin(), panel.curves.end(), [](const Curve &c) { return !c.title.empty(); });
  });
}

std::string scriptOf(const Figure &figure, std::size_t number)
{
  const std::size_t columns = std::min<std::size_t>(figure.columns, figure.panels.size());
  const std::size_t rows = (figure.panels.size() + figure.columns - 1) / figure.columns;
  const double width = panelWidth * static_cast<double>(columns);
  const double height = titleHeight + panelHeight * static_cast<double>(rows) + (hasKey(figure) ? keyHeight : 0.);
  std::ostringstream data;
  std::ostringstream out;
  out << "\nset terminal svg size " << width << ',' << height
      << " font \"sans-serif,13\" background \"white\" enhanced\nset output " << quoted(figure.file)
      << ".suffix\nset multiplot\n"
      << "set label 1 " << quoted(figure.title) << " at screen 0.5, screen " << 1. - 0.5 * titleHeight / height
      << " center font \"sans-serif,15\" noenhanced\n";
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    const Panel &panel = figure.panels[i];
    const std::string prefix = "f" + std::to_string(number) + "p" + std::to_string(i) + "c";
    for (std::size_t curve = 0; curve < panel.curves.size(); ++curve) {
      data << dataBlock(prefix + std::to_string(curve), panel.curves[curve].points);
    }
    out << margins(figure, i, width, height) << "unset logscale\n"
        << "set xtics auto\nset ytics auto\nset format \"%g\"\n"
        << "set grid back linecolor rgb \"#dddddd\" linetype 1\n"
        << (i == 0 ? "set key at screen 0.5, screen 0.01 center bottom maxrows 2 Left reverse width -1\n"
                   : "unset key\nunset label 1\n")
        << "set title " << quoted(panel.title) << " noenhanced offset 0,-0.5\nset xlabel " << quoted(panel.xLabel)
        << " noenhanced offset 0,0.4\nset ylabel " << quoted(panel.yLabel) << " noenhanced\n"
        << setupOf(panel) << plotCommand(figure, i, prefix);
  }
  out << "unset multiplot\nunset output\nunset label 1\n";
  return data.str() + out.str();
}
} // namespace

std::string figureScript(const std::vector<Figure> &figures)
{
  std::string script = styles;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    script += scriptOf(figures[i], i);
  }
  return script;
}

std::vector<std::string> filesOf(const std::vector<Figure> &figures)
{
  std::vector<std::string> files;
  for (const Figure &figure : figures) {
    files.push_back(figure.file);
  }
  return files;
}
} // namespace common
