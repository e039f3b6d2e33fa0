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
 * The picture with what was found, what is true, and the room's edges.
 */

#ifndef VP_SIMULATOR_PICTURE_H
#define VP_SIMULATOR_PICTURE_H

#include <string>

#include <visp3/core/vpImage.h>
#include <visp3/core/vpRGBa.h>

#include "controls.h"
#include "world.h"

namespace simulator {
/*! \return The image with overlays: edges of the room, markers, true errors, the state of the knobs. */
vpImage<vpRGBa> pictureOf(const World &world, const Shot &shot, const Controls &controls);

/*! \return A line of JSON: pose of the camera wMc, knobs, and for each marker before the camera its true distance,
  tilt, and the errors. */
std::string jsonLineOf(const Shot &shot, const Controls &controls, unsigned long number);
} // namespace simulator

#endif
