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
 * Test of the covariance through lenses of very long focal length.
 */

#include "detector_scenes.h"

using namespace detector_test;

TEST(DetectorLongLens, NoVarianceIsNegative)
{
  // The depth of so small a marker is known a ten-thousandth as well as its place across.
  Random random = randomOfTest();
  vpDetectorCircleMarker detector;
  detector.setZAlignedWithCameraAxis(true);
  for (const double length : {20000., 40000., 80000.}) {
    const vpCameraParameters cam(length, length, 319.5, 239.5);
    unsigned int found = 0;
    for (int i = 0; i < 60; ++i) {
      const double diameter = i % 2 == 0 ? 12. : 24.;
      vpHomogeneousMatrix truth = randomPose(random, diameter, uniform(random, 0.2, 1.));
      for (unsigned int row = 0; row < 3; ++row) { // the same image through this lens
        truth[row][3] *= row == 2 ? length / focal : 1.;
      }
      const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
      std::vector<vpHomogeneousMatrix> cMo;
      detector.detect(imageOf(cam, {printed(family, randomId(random, family)).setPose(truth)}, random), size, cam, cMo);
      for (const vpCircleMarkerDetection &detection : detector.getDetections()) {
        ++found;
        for (unsigned int k = 0; k < 6; ++k) {
          EXPECT_GT(detection.covariance[k][k], 0.) << length;
        }
        const double depth = detection.covariance[2][2];
        // Through longer ones the sums' rounding is as large as what they tell of the depth of the smallest.
        EXPECT_TRUE(length > 20000. || std::pow(detection.cMo[2][3] - truth[2][3], 2.) < fiveSigma(5) * depth);
      }
    }
    EXPECT_GT(found, 30u) << length;
  }
}
