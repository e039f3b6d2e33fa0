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
 * Images full of the signs of other systems.
 */

#ifndef VP_BENCH_OTHER_SYSTEMS_H
#define VP_BENCH_OTHER_SYSTEMS_H

#include <cstdint>
#include <string>
#include <vector>

#include <visp3/core/vpImage.h>

namespace bench {
#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

/*!
  Names of the systems whose signs otherSystemsImage() draws: square tags (AprilTag's families and ArUco's, with
  OpenCV's module of them), checkerboards, concentric rings as CCTag's, discs with a hole as WhyCon's, rings with teeth
  on their inner edge as WhyCode's, rings of dots as RUNE-Tag's, grids of dots, squares in squares as in QR codes,
  letters.
*/
std::vector<std::string> otherSystems();

/*!
  An image with a dozen signs of one system, of any size, tilt and turn, some across one another, on a ground of any
  grey; with blur and noise.
  \param system : One of otherSystems().
  \param width, height : Pixels.
  \param seed : The same seed gives the same image.
  \exception vpException::badValue : If the system is not known.
*/
vpImage<unsigned char> otherSystemsImage(const std::string &system, unsigned int width, unsigned int height,
                                         std::uint64_t seed);
} // namespace bench

#endif
