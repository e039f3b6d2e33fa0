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
 * ViSP's own calibration on the same pictures.
 */

#ifndef VP_CALIBRATE_VISP_PEER_H
#define VP_CALIBRATE_VISP_PEER_H

#include <string>
#include <vector>

#include "target.h"
#include "view.h"
#include "lens.h"

namespace calibrate {
/*! What vpCalibration makes of some views. */
struct VispCalibration
{
  vpCameraParameters camera;
  double rms = 0.;     //!< Root of the mean squared distance between points and their images, pixels.
  std::string problem; //!< Why there is none; empty: there is one.
};

/*!
  vpCalibration as ViSP's example calibrate-camera uses it: each view alone, then all together (virtual visual
  servoing, gain 0.5).
  \param target : What was seen.
  \param views : Its points, pixels.
  \param hasDistortion : Whether kud and kdu are sought.
*/
VispCalibration calibrateByVisp(const Target &target, const std::vector<View> &views, bool hasDistortion);
} // namespace calibrate

#endif
