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
 * A camera with its principal point elsewhere.
 */

#ifndef VP_TUTORIAL_MOVED_CAMERA_H
#define VP_TUTORIAL_MOVED_CAMERA_H

#include <visp3/core/vpCameraParameters.h>

#include "visp_names.h"

namespace tutorial {
/*!
  \return The camera, of any model, with its principal point moved by (du, dv) pixels: for pixels that are counted from
  another origin. Lens distortion moves with it.
*/
inline vpCameraParameters movedPrincipalPoint(const vpCameraParameters &cam, double du, double dv)
{
  const double px = cam.get_px(), py = cam.get_py(), u0 = cam.get_u0() + du, v0 = cam.get_v0() + dv;
  vpCameraParameters moved;
  switch (cam.get_projModel()) {
  case vpCameraParameters::perspectiveProjWithoutDistortion:
    moved.initPersProjWithoutDistortion(px, py, u0, v0);
    break;
  case vpCameraParameters::perspectiveProjWithDistortion:
    moved.initPersProjWithDistortion(px, py, u0, v0, cam.get_kud(), cam.get_kdu());
    break;
  default:
    moved.initProjWithKannalaBrandtDistortion(px, py, u0, v0, cam.getKannalaBrandtDistortionCoefficients());
    break;
  }
  return moved;
}
} // namespace tutorial

#endif
