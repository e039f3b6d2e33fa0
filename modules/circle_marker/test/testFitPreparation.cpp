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
 * Tests of the preparation of pixels for a fit.
 */

#include "refine/fit_preparation.h"

#include <gtest/gtest.h>

#include "testFitTools.h"

using namespace fit_test;

// A fit to white sectors alone, which tell no spin, turned by 16 to 180 degrees, as the pixels went on to be compared
// with the sectors that they had seen before.
TEST(FitPreparation, PixelsAreSortedAgainWhenThePrintHasTurned)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  const MarkerScene scene = markerScene(random, family, 5, 90., 0.4, side);
  const Case made = makeCase(scene, 5, digitise(expose(side, side, 0.7, scene), 2., random));
  const FitSettings settings = settingsOf(family);
  FitMemory memory;
  Likelihood likelihood(made.pattern, settings, memory);
  FitPreparation preparation(made.pixels, settings, likelihood, memory);
  Photometry photometry;
  photometry.white = paper;
  preparation.prepare(scene.plane(), photometry, 2.);
  const auto isStaleAfter = [&](double pixels) { // of the outline
    MarkerPlane turned = scene.plane();
    turned.spin(pixels / 45.);
    return preparation.isStale(turned, photometry, 2.);
  };
  EXPECT_FALSE(isStaleAfter(0.));
  for (const double sign : {-1., 1.}) {
    EXPECT_FALSE(isStaleAfter(1.3 * sign));
    EXPECT_TRUE(isStaleAfter(1.7 * sign));
    EXPECT_TRUE(isStaleAfter(70. * sign)); // a quarter of a turn
  }
}
