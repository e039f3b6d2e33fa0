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
 * Test of the detector in pictures of much noise.
 */

#include "detector_scenes.h"

using namespace detector_test;

// What a fit leaves is refused if it is no noise, from 32 grey levels on; but where the image has as much, it is.
TEST(DetectorNoise, LargeMarkersAreReadInNoiseOfAFifthOfTheContrast)
{
  constexpr int images = 10;
  constexpr double diameter = 300.; // pixels
  constexpr double deviation = 40.; // grey levels, before the sensor cuts it off
  Random random = randomOfTest();
  std::normal_distribution<double> normal(0., deviation);
  for (int i = 0; i < images; ++i) {
    const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
    const int id = randomId(random, family);
    const vpHomogeneousMatrix truth = randomPose(random, diameter, uniform(random, 0.2, 0.8), 320., 240.);
    vpImage<unsigned char> I = imageOf(printed(family, id).setPose(truth), random);
    for (unsigned int k = 0; k < I.getSize(); ++k) {
      I.bitmap[k] = static_cast<unsigned char>(std::lround(std::clamp(I.bitmap[k] + normal(random), 0., 255.)));
    }
    vpDetectorCircleMarker detector;
    detector.setZAlignedWithCameraAxis(true);
    std::vector<vpHomogeneousMatrix> cMo;
    ASSERT_TRUE(detector.detect(I, size, straightCamera(), cMo)) << i;
    EXPECT_EQ(detector.getTagsId(), std::vector<int>({id})) << i;
    EXPECT_GT(detector.getDetections()[0].logOdds, 0.) << i;
    EXPECT_LT((translationOf(cMo[0]) - translationOf(truth)).norm(), 0.01 * truth[2][3]) << i;
  }
}
