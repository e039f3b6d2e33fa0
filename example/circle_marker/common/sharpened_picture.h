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
 * A picture of a camera that sharpens.
 */

#ifndef VP_COMMON_SHARPENED_PICTURE_H
#define VP_COMMON_SHARPENED_PICTURE_H

#include <visp3/core/vpImage.h>

#include "common/visp_names.h"

namespace common {
/*!
  Unsharp mask, as most cameras sharpen: adds to a picture, noise and all, so many times what a Gaussian takes from it.
  \param amount : How many times.
  \param sigma : Standard deviation of the Gaussian, pixels.
  \param I : The picture. Grey levels beyond 0 and 255 are cut off.
*/
void sharpen(double amount, double sigma, vpImage<unsigned char> &I);
} // namespace common

#endif
