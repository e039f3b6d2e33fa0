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
 * The first ten tags of the family 36h11.
 */

#ifndef VP_SIMULATOR_APRIL_TAG_36H11_H
#define VP_SIMULATOR_APRIL_TAG_36H11_H

#include <visp3/core/vpImage.h>

#include <visp3/circle_marker_simulator/vpConfigCircleMarkerSimulator.h>

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

//! Cells of a tag, 8 x 8: black border one cell wide around 6 x 6 bits; 0 is black, 255 white. Ids 0 to 9.
vpImage<unsigned char> aprilTagCells(int id);

} // namespace marker_simulator
END_VISP_NAMESPACE

#endif
