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
 * What the tests of vpPoseCircle share: cameras, exact pixels, errors of its poses.
 */

#ifndef VP_TEST_POSE_CIRCLE_INPUTS_H
#define VP_TEST_POSE_CIRCLE_INPUTS_H

#include "testPoseCircleTools.h"

#include <cmath>
#include <vector>

#include <visp3/circle_marker/vpPoseCircle.h>
#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpImagePoint.h>

namespace pose_circle_test {
inline vpCameraParameters pinhole()
{
  vpCameraParameters cam;
  cam.initPersProjWithoutDistortion(1600., 1580., 639.5, 479.5);
  return cam;
}

inline vpCameraParameters radial()
{
  vpCameraParameters cam;
  cam.initPersProjWithDistortion(800., 805., 320.3, 239.1, -0.21, 0.25);
  return cam;
}

inline vpCameraParameters fisheye()
{
  vpCameraParameters cam;
  cam.initProjWithKannalaBrandtDistortion(400., 402., 319.5, 239.5, {0.05, -0.01, 0.003, -0.0005});
  return cam;
}

//! Pixel that vpPixelMeterConversion takes to a point: the inverse of ViSP's model pixel to metre, by Newton.
inline vpImagePoint exactPixel(const Eigen::Vector2d &point, const vpCameraParameters &cam)
{
  const double r = point.norm();
  double distorted = r;
  if (cam.get_projModel() == vpCameraParameters::perspectiveProjWithDistortion) {
    // The vector from the centre grows by 1 + kdu rd^2 from pixel to metre.
    for (int i = 0; i < 30; i++) {
      const double f = distorted * (1. + cam.get_kdu() * distorted * distorted) - r;
      distorted -= f / (1. + 3. * cam.get_kdu() * distorted * distorted);
    }
  }
  else if (cam.get_projModel() == vpCameraParameters::ProjWithKannalaBrandtDistortion) {
    const std::vector<double> k = cam.getKannalaBrandtDistortionCoefficients();
    const double t = std::atan(r), t2 = t * t;
    distorted = t * (1. + t2 * (k[0] + t2 * (k[1] + t2 * (k[2] + t2 * k[3]))));
  }
  const double factor = (r > 0.) ? distorted / r : 1.;
  return vpImagePoint(cam.get_v0() + cam.get_py() * factor * point.y(),
                      cam.get_u0() + cam.get_px() * factor * point.x());
}

inline std::vector<vpImagePoint> exactPixels(const std::vector<Eigen::Vector2d> &points, const vpCameraParameters &cam)
{
  std::vector<vpImagePoint> pixels;
  for (const Eigen::Vector2d &point : points) {
    pixels.push_back(exactPixel(point, cam));
  }
  return pixels;
}

//! Errors of the better one of both poses.
inline Errors errorsOfPose(vpPoseCircle &pose, const View &view, bool zAligned = false)
{
  pose.setRadius(static_cast<double>(view.radius));
  vpHomogeneousMatrix cMo, cMo2;
  EXPECT_TRUE(pose.computePose(cMo, &cMo2));
  return better(errorsOf(view, cMo, zAligned), errorsOf(view, cMo2, zAligned));
}

inline View knownView()
{
  View view;
  view.center = Vector3(0.06L, -0.04L, 1.L);
  view.normal = Vector3(0.5L, 0.3L, 0.8L).normalized();
  view.radius = 0.1L;
  return view;
}
} // namespace pose_circle_test

#endif
