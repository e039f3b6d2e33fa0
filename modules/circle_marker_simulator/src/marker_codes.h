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
 * Codewords of the circular families, recomputed from the generator polynomials.
 */

#ifndef VP_SIMULATOR_MARKER_CODES_H
#define VP_SIMULATOR_MARKER_CODES_H

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <visp3/circle_marker_simulator/vpConfigCircleMarkerSimulator.h>

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

//! A binary cyclic code; polynomials as bits, the constant term the least significant one.
struct CyclicCode
{
  unsigned int length;     //!< Number of sectors.
  unsigned int dimension;  //!< Number of information bits.
  std::uint32_t generator; //!< Generator polynomial.
};

//! Code of a family; empty for a family without one.
std::optional<CyclicCode> codeOf(const std::string &family);

/*!
  Words printed for the ids 0, 1, ...: the smallest word of each orbit under rotation that has as many members as the
  word has bits, in ascending order. The most significant bit is sector 0.
*/
const std::vector<std::uint32_t> &representativesOf(const std::string &family);

} // namespace marker_simulator
END_VISP_NAMESPACE

#endif
