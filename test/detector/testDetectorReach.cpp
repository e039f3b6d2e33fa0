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
 * The smallest rings that the detector promises to find.
 */

#include <gtest/gtest.h>

#include "detector_scenes.h"

using namespace detector_test;

// Their black line and their quiet zone are thinner than a pixel: no outer edge is left of them.
TEST(DetectorReach, RingsFromAMinorAxisOfEightPixels)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::RING);
  vpDetectorCircleMarker detector(family);
  constexpr int columns = 6;
  constexpr int rows = 4;
  unsigned int markers = 0;
  unsigned int found = 0;
  for (int image = 0; image < 8; ++image) {
    vpMarkerSceneSimulator simulator(straightCamera(), width, height);
    simulator.setBackground(vpSceneBackground::plain(uniform(random, 80., 160.)));
    for (int i = 0; i < columns * rows; ++i) {
      const double u = width * (i % columns + 0.5) / columns + uniform(random, -5., 5.);
      const double v = height * (i / columns + 0.5) / rows + uniform(random, -5., 5.);
      const double tilt = uniform(random, 0., 1.);
      vpSimulatedMarker marker = printed(family, -1);
      simulator.addMarker(marker.setPose(randomPose(random, uniform(random, 8., 12.) / std::cos(tilt), tilt, u, v)));
    }
    vpImage<unsigned char> I;
    const auto truth = simulator.render(I, random());
    detector.detect(I);
    for (const auto &marker : truth) {
      ++markers;
      for (const vpCircleMarkerDetection &detection : detector.getDetections()) {
        found += vpImagePoint::distance(detection.center, marker.center) < 1. ? 1 : 0;
      }
    }
    EXPECT_LE(detector.getNbObjects(), truth.size());
  }
  EXPECT_GE(found, 0.97 * markers) << "of " << markers;
}
