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
 * Lenses that darken the corners of the picture.
 */

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "common/darkened_picture.h"
#include "detector_scenes.h"

using namespace detector_test;

// With a plane for the light d^2 by degrees of freedom was 3.5 of golay23 and 20 of plain rings of 100 to 220 pixels
// where the corners have 0.64 of the light, as any lens of 800 pixels leaves 27 degrees off its axis; and golay23's
// depth was off by 2.9 standard deviations. Greys are rounded twice here.
TEST(DetectorCurvedLight, MarkersAreMeasuredBeforeLensesThatDarkenTheCorners)
{
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::RING}) {
    for (const std::pair<double, double> &diameters : {std::make_pair(40., 100.), {100., 220.}}) {
      for (const double corner : {1., 0.8, 0.64, 0.5}) {
        if (corner < 0.6 && diameters.second > 200.) { // bends by more than the second order over a large marker
          continue;
        }
        HonestyScenes scenes{vpCircleMarkerFamily(type)};
        scenes.diameters = diameters;
        scenes.process = [corner, noise = scenes.noise](vpImage<unsigned char> &I, Random &random) {
          common::darkenCorners(corner, straightCamera(), noise, random(), I);
        };
        const Honesty honesty = honestyOf(scenes, random);
        const std::string what = scenes.family.getName() + " from " + std::to_string(diameters.first) + " pixels, " +
                                 std::to_string(corner) + " of the light";
        RecordProperty(what, honesty.text());
        EXPECT_LT(honesty.squared, 1.5) << what;
        EXPECT_LT(std::abs(honesty.bias), 0.6) << what; // by chance 0.16
        EXPECT_GE(honesty.found, scenes.images - 1) << what;
      }
    }
  }
}
