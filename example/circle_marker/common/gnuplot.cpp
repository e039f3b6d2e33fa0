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
 * Pieces of gnuplot's scripts: data, and one style for all plots.
 */

#include <iomanip>
#include <sstream>

#include "gnuplot.h"

namespace common {
std::string dataBlock(const std::string &name, const Points &points)
{
  std::ostringstream out;
  out << std::setprecision(6) << '$' << name << " << EOD\n";
  for (const auto &point : points) {
    out << point[0] << ' ' << point[1] << '\n';
  }
  out << (points.empty() ? "NaN NaN\n" : "") << "EOD\n";
  return out.str();
}

// Colours of Okabe and Ito (2002).
const char *const plotStyle = R"(
if (!exists("suffix")) suffix = ""
set encoding utf8
set terminal svg size 900,600 font "sans-serif,14" background "white" enhanced
set grid back linecolor rgb "#dddddd" linetype 1
set key at screen 0.5, screen 0.015 center bottom maxrows 2 Left reverse width -1
set bmargin at screen 0.2
set rmargin at screen 0.96
set style line 1 linecolor rgb "#0072B2" linewidth 2.5 pointtype 7 pointsize 0.6
set style line 2 linecolor rgb "#D55E00" linewidth 2.5 pointtype 5 pointsize 0.6
set style line 3 linecolor rgb "#CC79A7" linewidth 2.5 pointtype 9 pointsize 0.6
set style line 4 linecolor rgb "#888888" linewidth 2.5 dashtype 2
set style line 5 linecolor rgb "#0072B2" linewidth 2.5 pointtype 6 pointsize 0.9 dashtype 2
set style line 6 linecolor rgb "#D55E00" linewidth 2.5 pointtype 4 pointsize 0.9 dashtype 2
set style line 7 linecolor rgb "#CC79A7" linewidth 2.5 pointtype 8 pointsize 0.9 dashtype 2
set style line 11 linecolor rgb "#990072B2" pointtype 7 pointsize 0.3
set style line 12 linecolor rgb "#99D55E00" pointtype 5 pointsize 0.3
)";
} // namespace common
