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

#ifndef VP_COMMON_GNUPLOT_H
#define VP_COMMON_GNUPLOT_H

#include <array>
#include <string>
#include <vector>

namespace common {
using Points = std::vector<std::array<double, 2>>;

/*! A data block `$name`; an empty one would be an error, so it then holds a point that is not drawn. */
std::string dataBlock(const std::string &name, const Points &points);

/*! Terminal, grid, key below the plot, and colours that the colour-blind tell apart as well. */
extern const char *const plotStyle;
} // namespace common

#endif
