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
 * Log-odds of large rings whose edges are sharper than a lens makes them.
 */

#include <algorithm>

#include "detector_scenes.h"

using namespace detector_test;

// The model has no edges as sharp as these: what it lacks widens the covariance and lowers the odds, but the mirrored
// pose of a large ring, near by, is nowhere near the image. It is given up on its way, so its cost is not known then.
TEST(DetectorOddsOfSharp, LargeRingsHaveClearPosesWhateverTheModelLacks)
{
  constexpr int images = 40;
  constexpr double leastLogOdds = 10.; // e^10, where without what the model lacks they are e^500
  Random random = randomOfTest();
  vpDetectorCircleMarker detector(vpCircleMarkerFamily::RING);
  detector.setZAlignedWithCameraAxis(true);
  vpScenePhotometry photometry;
  photometry.blurSigma = 0.1;
  double least = HUGE_VAL;
  for (int i = 0; i < images; ++i) {
    const vpHomogeneousMatrix truth =
        randomPose(random, uniform(random, 130., 260.), uniform(random, 0.4, 1.), 320., 240.);
    vpMarkerSceneSimulator simulator(straightCamera(), width, height);
    simulator.setPhotometry(photometry);
    simulator.addMarker(printed(vpCircleMarkerFamily(vpCircleMarkerFamily::RING), -1).setPose(truth));
    std::vector<vpHomogeneousMatrix> cMo;
    vpImage<unsigned char> I;
    simulator.render(I, random());
    ASSERT_TRUE(detector.detect(I, size, straightCamera(), cMo)) << i;
    ASSERT_EQ(cMo.size(), 1u) << i;
    const vpCircleMarkerDetection &found = detector.getDetections()[0];
    EXPECT_GT(found.logOdds, leastLogOdds) << i;
    EXPECT_LT(mahalanobis(truth, cMo[0], found.covariance, found.dof), fiveSigma(found.dof)) << i;
    least = std::min(least, found.logOdds);
  }
  RecordProperty("leastLogOdds", std::to_string(least));
}
