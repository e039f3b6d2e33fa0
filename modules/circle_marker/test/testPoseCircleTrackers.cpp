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
 * Pose of a circle from what ViSP's trackers measure in an image.
 */

#include "testPoseCircleInputs.h"

#include <visp3/blob/vpDot2.h>
#include <visp3/core/vpImage.h>
#include <visp3/core/vpPixelMeterConversion.h>
#include <visp3/me/vpMe.h>
#include <visp3/me/vpMeEllipse.h>

using namespace pose_circle_test;

namespace {
//! A dark image with a bright filled circle, each pixel the mean of 8 x 8 samples.
vpImage<unsigned char> render(const View &view, const vpCameraParameters &cam)
{
  vpImage<unsigned char> I(480, 640, 0);
  const Eigen::Matrix3d Q = view.exactConic().cast<double>();
  const int samples = 8;
  for (unsigned int v = 0; v < I.getHeight(); v++) {
    for (unsigned int u = 0; u < I.getWidth(); u++) {
      int inside = 0;
      for (int k = 0; k < samples * samples; k++) {
        double x = 0., y = 0.;
        vpPixelMeterConversion::convertPoint(cam, u - 0.5 + (k % samples + 0.5) / samples,
                                             v - 0.5 + (k / samples + 0.5) / samples, x, y);
        const Eigen::Vector3d p(x, y, 1.);
        inside += (p.dot(Q * p) < 0.) ? 1 : 0;
      }
      I[v][u] = static_cast<unsigned char>(20 + 200 * inside / (samples * samples));
    }
  }
  return I;
}
} // namespace

TEST(PoseCircleTrackers, FromDot)
{
  const View view = knownView();
  for (const vpCameraParameters &cam : {radial(), fisheye()}) {
    const vpImage<unsigned char> I = render(view, cam);
    vpDot2 dot;
    const vpImagePoint start = exactPixel({0.06, -0.04}, cam);
    dot.initTracking(I, start, 121, 255);
    vpPoseCircle pose;
    pose.setEllipse(dot, cam);
    const Errors errors = errorsOfPose(pose, view);
    // The border is known to whole pixels: 0.3 pixel of rounding in each of 200 to 400 points. Half a pixel all round
    // would be a hundredth of the depth.
    EXPECT_LT(errors.center, 3e-4);
    EXPECT_LT(errors.normal, 5e-3);
  }
}

TEST(PoseCircleTrackers, ADotTakesThePlaceOfTheLastOne)
{
  const View view = knownView();
  const vpCameraParameters cam = radial();
  const vpImage<unsigned char> I = render(view, cam);
  vpDot2 dot;
  dot.initTracking(I, exactPixel({0.06, -0.04}, cam), 121, 255);
  vpPoseCircle pose;
  pose.setEllipse(dot, cam);
  const unsigned int count = pose.getNbPoints();
  EXPECT_GT(count, 100u);
  pose.setEllipse(dot, cam);
  EXPECT_EQ(pose.getNbPoints(), count);
}

TEST(PoseCircleTrackers, FromMovingEdges)
{
  const View view = knownView();
  vpCameraParameters cam;
  cam.initPersProjWithoutDistortion(800., 810., 319.5, 239.5);
  const vpImage<unsigned char> I = render(view, cam);
  vpMe me;
  me.setRange(8);
  me.setThreshold(1000.);
  me.setSampleStep(3);
  vpMeEllipse tracker;
  tracker.setMe(&me);
  tracker.initTracking(I, exactPixels(view.contour(8), cam));
  tracker.track(I);
  vpPoseCircle pose;
  pose.setEllipse(tracker, cam);
  const Errors errors = errorsOfPose(pose, view);
  // Moving edges are found to whole pixels along the normal, that is with 0.3 pixel of noise.
  EXPECT_LT(errors.center, 3e-3);
  EXPECT_LT(errors.normal, 1e-2);
}
