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
 * Frames whose marker is covered in part, or whose picture is bad.
 */

#ifndef VP_BENCH_HARDSHIPS_H
#define VP_BENCH_HARDSHIPS_H

#include <cstdint>
#include <string>
#include <vector>

#include "scenes.h"

namespace bench {
/*! What a frame suffers: one thing covers the marker, or one thing spoils the picture, or both. */
struct Hardship
{
  std::string name;    //!< What it is.
  double level = 0.;   //!< How much of it; of what covers the marker: the share of its disc's image.
  bool covers = false; //!< Whether it covers the marker, and does nothing else.
};

/*! All that the table of hardships has. */
const std::vector<Hardship> &hardships();

/*! Diameters of the markers of hard frames before their tilt, and their light. */
enum class HardMarkers
{
  USUAL, //!< 40 to 160 pixels.
  SMALL  //!< 12 to 45 pixels, in any light.
};

/*!
  A frame of 640 x 480 pixels with one marker on clutter, at a tilt up to 60 degrees.
  \param hardship : What it suffers.
  \param family : Of the marker.
  \param seed : The same seed gives the same frame.
  \param markers : How large the marker is, in which light.
*/
Scene makeHardScene(const Hardship &hardship, const std::string &family, std::uint64_t seed,
                    HardMarkers markers = HardMarkers::USUAL);
} // namespace bench

#endif
