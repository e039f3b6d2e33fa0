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
 * What becomes of hard pictures between the sensor and the detector.
 */

#ifndef VP_BENCH_HARD_PICTURES_H
#define VP_BENCH_HARD_PICTURES_H

#include "hardships.h"
#include "scenes.h"

namespace bench {
/*! Whether a hardship is what becomes of the picture; its level is the noise then, grey levels. */
bool isOfPictures(const Hardship &hardship);

/*! The camera of a hardship's frames of some size: with a distortion where pictures are undistorted. */
vpCameraParameters hardCamera(const Hardship &hardship, unsigned int width, unsigned int height);

/*! Makes the picture as it comes to the detector, with what is true of it. */
void processPicture(const Hardship &hardship, double noise, std::uint64_t seed, Scene &scene);
} // namespace bench

#endif
