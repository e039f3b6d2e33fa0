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

#ifndef VP_COMMON_FIGURE_H
#define VP_COMMON_FIGURE_H

#include <string>
#include <vector>

#include "gnuplot.h"

namespace common {
/*! Points drawn in one way. */
struct Curve
{
  std::string title; //!< In the key; empty: not there.
  std::string style; //!< What follows "plot $data", such as "with points linestyle 1".
  Points points;
};

/*! One system of axes. */
struct Panel
{
  std::string title, xLabel, yLabel;
  std::string setup; //!< Commands of gnuplot for this panel alone: ranges, logarithmic axes, tics.
  std::vector<Curve> curves;
};

/*! For a panel's setup: a logarithmic y axis with short numbers. */
constexpr const char *logarithmicY = "set logscale y\nset format y \"10^{%L}\"\n";

/*! Panels in rows, below them one key for all. */
struct Figure
{
  std::string file; //!< Name of the SVG file.
  std::string title;
  unsigned int columns = 3;
  std::vector<Panel> panels;
};

/*! What draws figures: `gnuplot script` in its folder; the variable `suffix` is added to the names of the files. */
std::string figureScript(const std::vector<Figure> &figures);

/*! Names of the figures' files. */
std::vector<std::string> filesOf(const std::vector<Figure> &figures);
} // namespace common

#endif
