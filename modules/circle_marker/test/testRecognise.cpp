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
 * Tests which marker an outline is.
 */

#include "decode/recognise.h"

#include <gtest/gtest.h>

#include "ellipse/outlines.h"
#include "support/workers.h"
#include "testRoomTools.h"

using namespace circle_marker;
using namespace room_test;

// Sectors as dark as they were read, in the order of the code, wherever on the plane that starts: where one is clearly
// black or white it is what is printed.
TEST(Recognise, AnUncertainCodeHasItsSectorsAsTheyWereRead)
{
  Random random = randomOfTest();
  constexpr unsigned int side = 120;
  constexpr double noise = 1.;
  constexpr double clear = 0.3; // from the middle between white and black
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  int recognised = 0;
  int sectors = 0;
  int right = 0;
  for (int i = 0; i < 40; ++i) {
    const int id = static_cast<int>(random() % family.getNbIds());
    const MarkerScene scene =
        markerScene(random, family, id, uniform(random, 30., 45.), uniform(random, 0., 0.6), side);
    const vpImage<unsigned char> I = digitise(expose(side, side, 0.7, scene), noise, random);
    const CameraModel camera(scene.camera());
    OutlineMemory memory;
    Workers workers(1);
    SoughtCenters sought;
    sought.bright = true;
    for (const EllipseCandidate &outline : findOutlines(I, sought, workers, Deadline(), memory)) {
      const auto poses = posesFromOutline(outline.points, camera, scene.plane().radius);
      if (!poses) {
        continue;
      }
      OutlineInImage seen(I, camera, *poses, outline);
      const auto marker = recogniseUncertain(seen, family, noise);
      if (!marker || marker->code.id != id) {
        continue;
      }
      ++recognised;
      EXPECT_FALSE(marker->isCertain);
      ASSERT_TRUE(marker->darkness);
      for (unsigned int k = 0; k < family.getNbSectors(); ++k) {
        const double beyondGrey = (*marker->darkness)[k] - 0.5;
        if (std::abs(beyondGrey) > clear) {
          const bool isBlack = isSectorBlack(scene.word, k, family.getNbSectors());
          ++sectors;
          right += isBlack == (beyondGrey > 0.) ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GE(recognised, 30);
  EXPECT_GE(sectors, 15 * recognised);
  EXPECT_EQ(right, sectors);
}
