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
 * Tests of what is seen of a covered marker.
 */

#include "decode/seen_parts.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "refine/coarse_fits.h"
#include "testRoomTools.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 150;
constexpr unsigned int perSector = 8; // directions

struct Looked
{
  vpCircleMarkerFamily family = vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23);
  int id;
  MarkerScene scene;
  SeenParts seen;

  //! All of a marker is seen, in a plane whose spin is another one.
  explicit Looked(Random &random)
      : id(static_cast<int>(random() % family.getNbIds())), scene(markerScene(random, family, id, 80., 0.5, side))
  {
    seen.plane = scene.plane();
    seen.plane.spin(uniform(random, 0., 6.));
    seen.directions = perSector * family.getNbSectors();
    seen.gap = 0.74;
    seen.core = 0.35;
    seen.ring.set();
    seen.track.set();
    seen.center.set();
  }

  //! The direction, in the seen plane, of an angle of the marker.
  std::size_t directionOf(double angle) const
  {
    const Eigen::Vector2d q =
        seen.plane.intersect(scene.plane().project(Eigen::Vector2d(std::cos(angle), std::sin(angle))));
    return static_cast<std::size_t>((std::atan2(q.y(), q.x()) / (2. * M_PI) + 1.) * seen.directions) % seen.directions;
  }

  unsigned int borders() const { return seen.bordersSeen(scene.word, family.getNbSectors(), scene.plane()); }

  bool isBlack(unsigned int sector) const
  {
    const unsigned int n = family.getNbSectors();
    return isSectorBlack(scene.word, sector % n, n);
  }
};
} // namespace

TEST(SeenParts, BordersAreSeenWhereTheDirectionsBesideThemAre)
{
  Random random = randomOfTest();
  for (int i = 0; i < 10; ++i) {
    Looked looked(random);
    const unsigned int n = looked.family.getNbSectors();
    unsigned int all = 0;
    for (unsigned int k = 0; k < n; ++k) {
      all += looked.isBlack(k) != looked.isBlack(k + n - 1) ? 1 : 0;
    }
    EXPECT_EQ(looked.borders(), all);
    for (unsigned int k = 0; k < n; ++k) {
      const unsigned int isBorder = looked.isBlack(k) != looked.isBlack(k + n - 1) ? 1 : 0;
      for (const double sectors : {-1. / perSector, 0., 1. / perSector, 0.5}) {
        Looked without = looked;
        without.seen.track[looked.directionOf(2. * M_PI * (k + sectors) / n)] = false;
        EXPECT_EQ(without.borders(), sectors < 0.5 ? all - isBorder : all) << k << " " << sectors;
      }
    }
    looked.seen.track.reset();
    EXPECT_EQ(looked.borders(), 0u);
  }
}

// By hand, around the end of the directions, too.
TEST(SeenParts, PiecesThatAreNotSeenAreCountedAround)
{
  SeenParts seen;
  seen.directions = 10;
  EXPECT_EQ(seen.piecesNotSeen(), 0u) << "all of it is one without an end";
  for (unsigned int direction = 0; direction < seen.directions; ++direction) {
    seen.track[direction] = true;
  }
  EXPECT_EQ(seen.piecesNotSeen(), 0u);
  seen.track[9] = seen.track[0] = false;
  EXPECT_EQ(seen.piecesNotSeen(), 1u);
  seen.track[3] = seen.track[4] = seen.track[6] = false;
  EXPECT_EQ(seen.piecesNotSeen(), 3u);
}

// Where bars cross a track they may leave white sectors alone, which tell no spin: a fit to those turned by 16 degrees
// and more.
TEST(SeenParts, TheTrackIsNotDroppedUnlessEnoughOfItsBordersAreSeen)
{
  Random random = randomOfTest();
  Looked looked(random);
  const unsigned int n = looked.family.getNbSectors();
  std::vector<FitPixel> all;
  for (int v = 0; v < static_cast<int>(side); ++v) {
    for (int u = 0; u < static_cast<int>(side); ++u) {
      FitPixel pixel;
      pixel.meter = CameraModel(looked.scene.camera()).toMeter(Eigen::Vector2d(u, v)).cast<float>();
      all.push_back(pixel);
    }
  }
  looked.seen.track.reset();
  looked.seen.ring.reset();
  Recognition marker;
  marker.family = looked.family;
  marker.code.id = looked.id;
  marker.poses = {looked.scene.plane(), looked.scene.plane()};
  unsigned int borders = 0;
  for (unsigned int k = 0; k < n && borders < 5; ++k) {
    if (looked.isBlack(k) == looked.isBlack(k + n - 1)) {
      continue;
    }
    for (const double sectors : {-1. / perSector, 0., 1. / perSector}) {
      looked.seen.track[looked.directionOf(2. * M_PI * (k + sectors) / n)] = true;
    }
    ++borders;
    marker.seen = looked.seen;
    std::vector<FitPixel> pixels = all;
    dropCovered(marker, pixels);
    for (const FitPixel &pixel : pixels) {
      const double radius = looked.scene.plane().intersect(pixel.meter.cast<double>()).norm();
      EXPECT_LE(radius, looked.seen.gap) << "the ring is not seen";
    }
    const auto onTrack = [&](const FitPixel &pixel) { return looked.seen.isOnTrack(pixel.meter.cast<double>()); };
    const auto ofAll = std::count_if(all.begin(), all.end(), onTrack);
    const auto kept = std::count_if(pixels.begin(), pixels.end(), onTrack);
    if (borders < 3) {
      EXPECT_EQ(kept, ofAll) << borders;
    }
    else {
      EXPECT_LT(kept, ofAll / 5) << borders;
      EXPECT_GT(kept, 0);
    }
  }
  EXPECT_EQ(borders, 5u);
}
