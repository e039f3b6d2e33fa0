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
 * Pictures of rectangular cells, such as tags, as regions of the marker's plane.
 */

#ifndef VP_SIMULATOR_PRINTED_GRID_H
#define VP_SIMULATOR_PRINTED_GRID_H

#include <vector>

#include "print.h"

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

//! Regions of the picture of a tag or bitmap: one for each shade that is not white. Ink spread moves a tag's edges.
std::vector<PrintedRegion> printedGrid(const vpSimulatedMarker &marker);

} // namespace marker_simulator
END_VISP_NAMESPACE

#endif
