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
 * AprilTags of the simulated camera, read by ViSP's detector.
 */

#include <visp3/detection/vpDetectorAprilTag.h>

#include "test_support.h"

using namespace simulator_test;

#if defined(VISP_HAVE_APRILTAG)

TEST(AprilTags, ReadByViSPsDetector)
{
  std::mt19937_64 random = seededFromTestName();
  const vpCameraParameters cam = pinhole(1280, 960);
  // AprilTag counts pixels from their corners and ViSP does not correct for it:
  // its points lie half a pixel further.
  vpCameraParameters shifted;
  shifted.initPersProjWithoutDistortion(1600., 1600., 640., 480.);
  vpDetectorAprilTag detector(vpDetectorAprilTag::TAG_36h11);
  detector.setAprilTagQuadDecimate(1.f);
  detector.setZAlignedWithCameraAxis(true);
  for (int id = 0; id < 10; ++id) {
    vpMarkerSceneSimulator simulator(cam, 1280, 960);
    const double azimuth = uniform(random, 0., 2. * M_PI);
    const double spin = uniform(random, 0., 2. * M_PI);
    const vpHomogeneousMatrix cMo =
        tiltedPose(uniform(random, -0.1, 0.1), uniform(random, -0.1, 0.1), 1., 0.6, azimuth, spin);
    simulator.addMarker(vpSimulatedMarker::aprilTag36h11(id, 0.168).setPose(cMo));
    vpImage<unsigned char> I;
    simulator.render(I, id);
    std::vector<vpHomogeneousMatrix> poses;
    ASSERT_TRUE(detector.detect(I, 0.168, shifted, poses)) << "id " << id;
    ASSERT_EQ(poses.size(), 1u);
    EXPECT_EQ(detector.getMessage(0), "36h11 id: " + std::to_string(id));
    const vpHomogeneousMatrix error = poses[0] * cMo.inverse();
    EXPECT_LT(vpThetaUVector(error.getRotationMatrix()).getTheta(), vpMath::rad(0.5)) << "id " << id;
    EXPECT_LT((poses[0].getTranslationVector() - cMo.getTranslationVector()).frobeniusNorm(), 0.002) << "id " << id;
    // The black square's corners, half a pixel corrected; the detector is good
    // to a tenth of a pixel or so.
    for (const vpImagePoint &corner : detector.getPolygon(0)) {
      double nearest = 1e9;
      for (const double x : {-0.084, 0.084}) {
        for (const double y : {-0.084, 0.084}) {
          const vpImagePoint p =
              simulator.project(cMo[0][0] * x + cMo[0][1] * y + cMo[0][3], cMo[1][0] * x + cMo[1][1] * y + cMo[1][3],
                                cMo[2][0] * x + cMo[2][1] * y + cMo[2][3]);
          nearest = std::min(nearest, vpImagePoint::distance(corner, p + vpImagePoint(0.5, 0.5)));
        }
      }
      EXPECT_LT(nearest, 0.2) << "id " << id;
    }
  }
}

#else

TEST(AprilTags, ReadByViSPsDetector)
{
  GTEST_SKIP() << "this ViSP is built without AprilTag";
}

#endif
