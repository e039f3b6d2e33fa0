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
 * Markers of the same footprint: what fits on one sheet.
 */

#ifndef VP_COMMON_FOOTPRINT_H
#define VP_COMMON_FOOTPRINT_H

namespace common {
/*! Outer diameter of a ring that with its quiet zone of R/6 fills A4's width of 210 mm, metres. */
constexpr double defaultRing = 0.18;

/*! Side of the square sheet of a ring, metres: the ring and a quiet zone of R/6. */
constexpr double sheetOfRing(double ring)
{
  return ring * (1. + 1. / 6.);
}

/*! Side of the black square of an AprilTag 36h11 that fills a sheet, metres: 8 of its 10 cells. */
constexpr double tagOnSheet(double sheet)
{
  return 0.8 * sheet;
}

constexpr int tagIds = 10; // AprilTags the simulated camera knows: 0 to 9.
} // namespace common

#endif
