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
 * What circle-marker-accuracy is asked to do.
 */

#ifndef VP_ACCURACY_SETTINGS_H
#define VP_ACCURACY_SETTINGS_H

#include <cstdint>
#include <set>
#include <string>

#include <visp3/circle_marker_simulator/vpMarkerPoseBound.h>

#include "common/footprint.h"
#include "common/reference_camera.h"

namespace accuracy {
using namespace common;

/*! What the command line fixes. */
struct Settings
{
  std::string output;          //!< Folder of the results; empty: none are made.
  std::string from;            //!< Folder of earlier results to be read instead.
  std::string page;            //!< Folder of the report page; empty: none.
  std::set<std::string> parts; //!< Of partNames.
  unsigned int frames = 20;    //!< In each cell of the limits; the other parts take shares or multiples of it.
  std::uint64_t seed = 1;      //!< Of poses, ids, light and noise.
  unsigned int jobs = 1;       //!< Threads.
  vpMarkerPoseBound::Surround surround = vpMarkerPoseBound::UNKNOWN_SURROUND; //!< What the bound knows.
};

/*! limits: random poses against the bound; model: what the model does not know; cells: the thesis's; apriltag. */
constexpr const char *partNames[] = {"limits", "model", "cells", "apriltag"};
} // namespace accuracy

#endif
