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
 * Pictures of the target as a known camera sees it.
 */

#ifndef VP_CALIBRATE_SIMULATE_H
#define VP_CALIBRATE_SIMULATE_H

#include <cstdint>
#include <vector>

#include <visp3/core/vpImage.h>

#include "lens.h"
#include "target.h"
#include "view.h"

namespace calibrate {
/*! How the target is held. */
struct HoldRange
{
  double leastTilt = 10.; //!< Least angle between its normal and the optical axis, degrees.
  double mostTilt = 45.;  //!< Greatest such angle, degrees.
};

/*! \return The lens of a camera of ViSP. */
Lens lensOf(const vpCameraParameters &cam);

/*!
  A random pose in which the target is seen large: every point of a chessboard or grid, most of a sheet of markers.
  \exception std::runtime_error : If there is none.
*/
TargetPose randomPose(const Target &target, const Lens &lens, unsigned int width, unsigned int height,
                      const HoldRange &range, std::uint64_t seed);

/*!
  The picture, by the simulated camera, with blur of 0.7 pixels and noise of 2 grey levels.
*/
vpImage<unsigned char> renderTarget(const Target &target, const vpCameraParameters &cam, unsigned int width,
                                    unsigned int height, const TargetPose &pose, std::uint64_t seed);
} // namespace calibrate

#endif
