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
 * Tests of what is known of one detected marker.
 */

#include <visp3/circle_marker/vpCircleMarkerDetection.h>
#include <visp3/core/vpExponentialMap.h>
#include <visp3/core/vpThetaUVector.h>

#include <gtest/gtest.h>

#include "testRandom.h"

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif
using namespace random_test;

// Against finite differences of the exponential map itself: where the marker is after a small motion about the camera.
TEST(CircleMarkerDetection, CovarianceOfTheCentreIsThatOfWhereTheMarkerIs)
{
  Random random = randomOfTest();
  for (int i = 0; i < 20; ++i) {
    vpCircleMarkerDetection detection;
    detection.cMo = vpHomogeneousMatrix(uniform(random, -2., 2.), uniform(random, -2., 2.), uniform(random, 1., 10.),
                                        uniform(random, -1., 1.), uniform(random, -1., 1.), uniform(random, -1., 1.));
    vpMatrix root(6, 6);
    vpMatrix change(6, 6); // of (t, rotation) by delta
    constexpr double step = 1e-6;
    for (unsigned int k = 0; k < 6; ++k) {
      for (unsigned int row = 0; row < 6; ++row) {
        root[row][k] = uniform(random, -1., 1.);
      }
      vpColVector delta(6, 0.);
      delta[k] = step;
      const vpHomogeneousMatrix moved = vpExponentialMap::direct(delta) * detection.cMo;
      const vpThetaUVector turn(moved.getRotationMatrix() * detection.cMo.getRotationMatrix().t());
      for (unsigned int row = 0; row < 3; ++row) {
        change[row][k] = (moved[row][3] - detection.cMo[row][3]) / step;
        change[3 + row][k] = turn[row] / step;
      }
    }
    detection.covariance = root * root.t();
    const vpMatrix expected = change * detection.covariance * change.t();
    const vpMatrix difference = detection.getCovarianceOfCenter() - expected;
    EXPECT_LT(difference.frobeniusNorm(), 1e-4 * expected.frobeniusNorm());
  }
}
