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
 * Pictures of a camera that raises the contrast.
 */

#ifndef VP_COMMON_TONED_PICTURE_H
#define VP_COMMON_TONED_PICTURE_H

#include <visp3/core/vpImage.h>

#include "common/visp_names.h"

namespace common {
/*!
  A tone curve that is an S, as cameras have it that raise the contrast: a logistic function.
  \param share : Grey level, from 0 to 1.
  \param strength : Of the logistic function: by the slope in the middle, strength / 4 / tanh(strength / 4).
  \return Grey level, 0 and 1 as before.
*/
double contrastRaised(double share, double strength);

/*! The same of a picture's grey levels, from 0 to 255. */
void raiseContrast(double strength, vpImage<unsigned char> &I);
} // namespace common

#endif
