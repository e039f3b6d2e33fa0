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
 * Pictures before a lens that darkens the corners.
 */

#ifndef VP_COMMON_DARKENED_PICTURE_H
#define VP_COMMON_DARKENED_PICTURE_H

#include <cstdint>

#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpImage.h>

#include "common/visp_names.h"

namespace common {
/*!
  Vignetting: light falls off from the camera's axis as the fourth power of the cosine of an angle does.
  \param corner : Share of the light that is left in the corner that is farthest from the axis.
  \param camera : The camera; its principal point counts.
  \param noise : Standard deviation of the picture's noise, grey levels; it stays what it is.
  \param seed : Of what of it is made anew.
  \param I : The picture.
*/
void darkenCorners(double corner, const vpCameraParameters &camera, double noise, std::uint64_t seed,
                   vpImage<unsigned char> &I);
} // namespace common

#endif
