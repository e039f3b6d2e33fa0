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
 * First guess of a camera and of the target's poses.
 */

#ifndef VP_CALIBRATE_START_H
#define VP_CALIBRATE_START_H

#include "adjust.h"

namespace calibrate {
/*!
  A camera and poses near enough for adjust(): focal lengths from the views' homographies and some that ordinary and
  wide lenses have, poses by OpenCV's solvePnP; the one that a few steps of adjust() like best.

  \exception std::runtime_error : If no such camera can see the target as it was seen.
*/
Adjustment firstGuess(const Target &target, const std::vector<View> &views, LensModel model);
} // namespace calibrate

#endif
