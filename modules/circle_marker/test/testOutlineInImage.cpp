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
 * An outline's readings, which are kept while families ask for them.
 */

#include "testRoomTools.h"

#include "decode/outline_in_image.h"

using namespace circle_marker;
using namespace room_test;

namespace {
void expectSame(const Judged<SectorReading> &kept, const Judged<SectorReading> &read)
{
  ASSERT_TRUE(kept);
  ASSERT_TRUE(read);
  EXPECT_EQ(kept->sectors, read->sectors);
  EXPECT_EQ(kept->phase, read->phase);
  for (unsigned int k = 0; k < read->sectors; ++k) {
    EXPECT_EQ(kept->soft[k], read->soft[k]) << k;
  }
}
} // namespace

// More kinds of tracks than are kept: each family gets what is read for it at the pose it asks for, whatever was asked
// before; and what is alike is the same object.
TEST(OutlineInImage, ReadingsAreThoseOfTheFamilyAndThePose)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily golay(vpCircleMarkerFamily::GOLAY23);
  const MarkerScene scene = markerScene(random, golay, 7, 100., 0.6, 150);
  const vpImage<unsigned char> I = photograph(150, 150, 0.7, scene);
  const CameraModel camera(scene.camera());
  MarkerPlane other = scene.plane();
  other.center *= 1.02; // so that the readings differ
  const PosePair poses = {scene.plane(), other};
  const EllipseCandidate outline;
  OutlineInImage seen(I, camera, poses, outline);

  vpCircleMarkerLayout narrow;
  narrow.codeInner = 0.45;
  const std::array<vpCircleMarkerFamily, 4> families = {golay, vpCircleMarkerFamily(vpCircleMarkerFamily::BCH31),
                                                        golay.withLayout(narrow),
                                                        vpCircleMarkerFamily(vpCircleMarkerFamily::BCH31R)};
  for (int round = 0; round < 2; ++round) {
    for (const vpCircleMarkerFamily &family : families) {
      for (std::size_t pose = 0; pose < poses.size(); ++pose) {
        expectSame(seen.sectorsAt(pose, family), readSectors(I, camera, poses[pose], family));
      }
    }
  }
  EXPECT_NE(seen.sectorsAt(0, golay)->soft, seen.sectorsAt(1, golay)->soft);
  EXPECT_EQ(&seen.sectorsAt(0, families[1]), &seen.sectorsAt(0, families[3])); // bch31 and bch31r have one track

  for (std::size_t pose = 0; pose < poses.size(); ++pose) {
    const auto &profile = seen.profileAt(pose);
    ASSERT_TRUE(profile);
    EXPECT_EQ(&profile, &seen.profileAt(pose));
    EXPECT_EQ(profile->grey, radialProfile(I, camera, poses[pose])->grey);
  }
}
