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
 * Test of the detector on images that a camera has sharpened: edges are overdone, which the model does not know.
 */

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>
#include <utility>

#include "../../modules/circle_marker/test/testSharpening.h"
#include "detector_scenes.h"

using namespace detector_test;
using sharpening_test::sharpened;

namespace {
//! diameters: least and greatest, pixels.
Honesty sharpenedHonesty(const vpCircleMarkerFamily &family, double amount, double sigma, Random &random,
                         const std::pair<double, double> &diameters = {40., 110.})
{
  HonestyScenes scenes(family);
  scenes.diameters = diameters;
  scenes.noise = 1.;
  scenes.process = [&](vpImage<unsigned char> &I, Random &) { I = sharpened(I, amount, sigma); };
  return honestyOf(scenes, random);
}
} // namespace

TEST(DetectorHalo, ImagesThatAreNotSharpened)
{
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::RING}) {
    const Honesty honesty = sharpenedHonesty(type, 0., 1., random);
    EXPECT_EQ(honesty.found, 40u);
    EXPECT_LT(honesty.squared, 1.3);
    EXPECT_GT(honesty.squared, 0.75) << "the covariance is no larger for it";
  }
}

namespace {
//! What sharpened images of a family are measured like, by name, as it is recorded.
struct Sharpened
{
  Honesty honesty;
  std::string what;
};

Sharpened sharpenedBy(vpCircleMarkerFamily::vpType type, double amount, double sigma, Random &random,
                      const std::pair<double, double> &diameters)
{
  const vpCircleMarkerFamily family(type);
  std::ostringstream what;
  what << family.getName() << " of " << diameters.first << " pixels, " << amount << " times, " << sigma << " pixels";
  return {sharpenedHonesty(family, amount, sigma, random, diameters), what.str()};
}
} // namespace

// What the camera sharpened is undone before markers are measured. Taken for a Gaussian's edges, those poses were 1.5
// to 8 times too sure of themselves; and codes whose halos were cut off at both ends of the grey levels, one in ten of
// 40 to 60 pixels, 50 times.
TEST(DetectorHalo, SharpenedImagesAreMeasuredAsOthers)
{
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::RING}) {
    for (const auto &[amount, sigma] : {std::pair<double, double>(1., 1.), {1., 2.}, {2., 2.}}) {
      const auto [honesty, what] = sharpenedBy(type, amount, sigma, random, {40., 110.});
      RecordProperty(what, honesty.text());
      EXPECT_LT(honesty.squared, 1.5) << what;
      EXPECT_GE(honesty.found, 36u) << what;
      EXPECT_LT(honesty.wrongOdds, 5.) << what;
    }
  }
}

// Small markers have no ring that is wide enough for a halo: all of their pixels tell the mask.
TEST(DetectorHalo, SoAreSmallMarkersInSharpenedImages)
{
  Random random = randomOfTest();
  for (const auto &[amount, sigma] : {std::pair<double, double>(0.5, 1.), {1., 1.}, {0.5, 2.}, {1., 2.}}) {
    const auto [honesty, what] = sharpenedBy(vpCircleMarkerFamily::GOLAY23, amount, sigma, random, {20., 40.});
    RecordProperty(what, honesty.text());
    EXPECT_LT(honesty.squared, 1.5) << what;
    EXPECT_GE(honesty.found, 38u) << what;
    EXPECT_LT(honesty.wrongOdds, 5.) << what;
  }
  const auto [honesty, what] = sharpenedBy(vpCircleMarkerFamily::RING, 1., 1., random, {20., 40.});
  RecordProperty(what, honesty.text());
  EXPECT_LT(honesty.squared, 1.5) << what;
  EXPECT_GE(honesty.found, 38u) << what;
}
