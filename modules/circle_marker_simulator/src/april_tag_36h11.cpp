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

#include <array>

#include <visp3/core/vpException.h>

#include "april_tag_36h11.h"

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

namespace {

// Rows of the 6 x 6 bits from the top, the leftmost bit the most significant one; 1 is black. Read off the pictures
// that the AprilTag library draws of its family (E. Olson, AprilTag: a robust and flexible visual fiducial system).
constexpr std::array<std::array<unsigned int, 6>, 10> BLACK_BITS = {{{{0x0a, 0x22, 0x27, 0x17, 0x29, 0x3b}},
                                                                     {{0x09, 0x28, 0x03, 0x27, 0x12, 0x36}},
                                                                     {{0x08, 0x2d, 0x1f, 0x36, 0x3b, 0x31}},
                                                                     {{0x06, 0x38, 0x18, 0x16, 0x0d, 0x27}},
                                                                     {{0x05, 0x03, 0x10, 0x35, 0x1f, 0x1d}},
                                                                     {{0x03, 0x0e, 0x09, 0x14, 0x31, 0x13}},
                                                                     {{0x3e, 0x29, 0x16, 0x22, 0x3d, 0x3a}},
                                                                     {{0x3b, 0x39, 0x2b, 0x11, 0x38, 0x2b}},
                                                                     {{0x37, 0x14, 0x38, 0x20, 0x05, 0x12}},
                                                                     {{0x36, 0x1a, 0x14, 0x2f, 0x2e, 0x0d}}}};

} // namespace

vpImage<unsigned char> aprilTagCells(int id)
{
  if (id < 0 || id >= static_cast<int>(BLACK_BITS.size())) {
    throw vpException(vpException::badValue, "the simulator knows the tags 0 to %d of 36h11, not %d",
                      static_cast<int>(BLACK_BITS.size()) - 1, id);
  }
  vpImage<unsigned char> cells(8, 8, 0);
  for (unsigned int row = 0; row < 6; ++row) {
    for (unsigned int column = 0; column < 6; ++column) {
      const bool black = (BLACK_BITS[id][row] >> (5 - column)) & 1;
      cells[row + 1][column + 1] = black ? 0 : 255;
    }
  }
  return cells;
}

} // namespace marker_simulator
END_VISP_NAMESPACE
