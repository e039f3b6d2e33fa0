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
 * Tests of the places where markers of the last images are looked for.
 */

#include "testRoomTools.h"

#include "track/marker_tracks.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr int width = 642; // no multiple of eight
constexpr int height = 481;

SeenMarker seenAt(double u, double v, double a = 40., int id = 3)
{
  SeenMarker marker;
  marker.id = id;
  marker.outline.center = Eigen::Vector2d(u, v);
  marker.outline.a = a;
  marker.outline.b = 0.7 * a;
  marker.outline.angle = 0.5;
  return marker;
}

bool contains(const PixelBox &box, const EllipseParameters &ellipse, double margin)
{
  const PixelBox inner = boxAround(ellipse, margin, width, height);
  return box.left <= inner.left && box.top <= inner.top && box.right >= inner.right && box.bottom >= inner.bottom;
}
} // namespace

TEST(BoxAround, TouchesTheEllipse)
{
  Random random = randomOfTest();
  for (int i = 0; i < 100; ++i) {
    EllipseParameters ellipse;
    ellipse.center = Eigen::Vector2d(uniform(random, 200., 400.), uniform(random, 200., 300.));
    ellipse.a = uniform(random, 20., 100.);
    ellipse.b = uniform(random, 5., ellipse.a);
    ellipse.angle = uniform(random, -1.57, 1.57);
    double left = 1e9, top = 1e9, right = -1e9, bottom = -1e9;
    for (int k = 0; k < 720; ++k) {
      const double x = ellipse.a * std::cos(k * M_PI / 360.);
      const double y = ellipse.b * std::sin(k * M_PI / 360.);
      const double u = ellipse.center.x() + std::cos(ellipse.angle) * x - std::sin(ellipse.angle) * y;
      const double v = ellipse.center.y() + std::sin(ellipse.angle) * x + std::cos(ellipse.angle) * y;
      left = std::min(left, u);
      right = std::max(right, u);
      top = std::min(top, v);
      bottom = std::max(bottom, v);
    }
    const PixelBox box = boxAround(ellipse, 0., width, height);
    EXPECT_NEAR(box.left, left, 1.01);
    EXPECT_NEAR(box.right, right, 1.01);
    EXPECT_NEAR(box.top, top, 1.01);
    EXPECT_NEAR(box.bottom, bottom, 1.01);
  }
}

TEST(MarkerTracks, NothingToFollowNoBoxes)
{
  MarkerTracks tracks;
  EXPECT_TRUE(tracks.predict(width, height).empty());
  tracks.follow({seenAt(300., 200.)}, width, height);
  EXPECT_EQ(tracks.predict(width, height).size(), 1u);
  EXPECT_TRUE(tracks.predict(height, width).empty()) << "another size of image";
  tracks.clear();
  EXPECT_TRUE(tracks.predict(width, height).empty());
}

TEST(MarkerTracks, BoxesFollowTheSpeed)
{
  MarkerTracks tracks;
  const Eigen::Vector2d speed(60., -25.); // more than the radius each image
  Eigen::Vector2d place(100., 400.);
  tracks.follow({seenAt(place.x(), place.y())}, width, height);
  place += speed;
  tracks.follow({seenAt(place.x(), place.y())}, width, height);
  for (int i = 0; i < 5; ++i) {
    place += speed;
    const SeenMarker next = seenAt(place.x(), place.y());
    const std::vector<PixelBox> boxes = tracks.predict(width, height);
    ASSERT_EQ(boxes.size(), 1u);
    EXPECT_TRUE(contains(boxes[0], next.outline, 10.));
    EXPECT_LT(boxes[0].width(), 240);
    EXPECT_EQ(boxes[0].left % 8, 0);
    EXPECT_EQ(boxes[0].top % 8, 0);
    EXPECT_TRUE(tracks.haveAll({next}));
    tracks.follow({next}, width, height);
  }
}

TEST(MarkerTracks, BoxesThatTouchAreOne)
{
  MarkerTracks tracks;
  // A chain of neighbours and one on its own.
  tracks.follow(
      {seenAt(100., 100., 40., 1), seenAt(290., 100., 40., 2), seenAt(195., 120., 40., 3), seenAt(560., 400., 30., 4)},
      width, height);
  const std::vector<PixelBox> boxes = tracks.predict(width, height);
  ASSERT_EQ(boxes.size(), 2u);
  EXPECT_TRUE(contains(boxes[0], seenAt(100., 100.).outline, 8.));
  EXPECT_TRUE(contains(boxes[0], seenAt(290., 100.).outline, 8.));
  EXPECT_TRUE(contains(boxes[1], seenAt(560., 400., 30.).outline, 8.));
}

TEST(MarkerTracks, ManyLargeMarkersAreLookedForInTheWholeImage)
{
  MarkerTracks tracks;
  tracks.follow({seenAt(160., 240., 110., 1), seenAt(480., 240., 110., 2)}, width, height);
  EXPECT_TRUE(tracks.predict(width, height).empty());
}

TEST(MarkerTracks, WhatIsMissingIsNoticed)
{
  MarkerTracks tracks;
  const SeenMarker first = seenAt(150., 150., 40., 1);
  const SeenMarker second = seenAt(450., 300., 40., 2);
  tracks.follow({first, second}, width, height);
  tracks.predict(width, height);
  EXPECT_TRUE(tracks.haveAll({first, second}));
  EXPECT_TRUE(tracks.haveAll({second, first}));
  EXPECT_FALSE(tracks.haveAll({first}));
  EXPECT_FALSE(tracks.haveAll({first, seenAt(450., 300., 40., 5)})) << "another id in its place";
  EXPECT_FALSE(tracks.haveAll({}));
  // An outline at the side of its box may go on beyond it; at the image's own border it may not.
  const PixelBox box = tracks.predict(width, height)[0];
  SeenMarker atSide = first;
  atSide.outline.center.x() = box.left + 38.;
  EXPECT_FALSE(tracks.haveAll({atSide, second}));
  tracks.clear(); // or it would have come there at a speed
  tracks.follow({seenAt(20., 150., 40., 1)}, width, height);
  tracks.predict(width, height);
  EXPECT_TRUE(tracks.haveAll({seenAt(20., 150., 40., 1)}));
}

TEST(MarkerTracks, WhatThereWasNoTimeForIsStillExpected)
{
  const SeenMarker first = seenAt(150., 150., 40., 1);
  const SeenMarker second = seenAt(450., 300., 40., 2);
  const SeenMarker moved = seenAt(455., 302., 40., 2);
  for (const bool isCutShort : {false, true}) {
    MarkerTracks tracks;
    tracks.follow({first, second}, width, height);
    tracks.follow({first, moved}, width, height);
    tracks.follow({first}, width, height, isCutShort);
    EXPECT_EQ(tracks.predict(width, height).size(), 2u);
    EXPECT_EQ(tracks.haveAll({first}), !isCutShort);
    ASSERT_EQ(tracks.getExpected().size(), isCutShort ? 2u : 1u);
    if (isCutShort) { // it goes on as it did, in the image that was not looked at, too
      EXPECT_NEAR((tracks.getExpected()[1].center - Eigen::Vector2d(465., 306.)).norm(), 0., 1e-9);
    }
  }
}

TEST(MarkerTracks, ALostOneIsLookedForWhereItWasButNotWaitedFor)
{
  const SeenMarker first = seenAt(150., 150., 40., 1);
  const SeenMarker second = seenAt(450., 300., 40., 2);
  MarkerTracks tracks;
  tracks.follow({first, seenAt(445., 298., 40., 2)}, width, height);
  tracks.follow({first, second}, width, height);
  EXPECT_FALSE(tracks.haveLost());
  for (int image = 0; image < 30; ++image) {
    tracks.follow({first}, width, height);
    const std::vector<PixelBox> boxes = tracks.predict(width, height);
    ASSERT_EQ(boxes.size(), 2u) << image;
    EXPECT_TRUE(contains(boxes[1], seenAt(455., 302., 40., 2).outline, 8.)) << "where it was expected, and no farther";
    EXPECT_EQ(tracks.getExpected().size(), 1u);
    EXPECT_TRUE(tracks.haveLost());
    EXPECT_TRUE(tracks.haveAll({first}));
    EXPECT_TRUE(tracks.haveAll({first, second}));
  }
  MarkerTracks again = tracks;
  again.follow({first, second}, width, height);
  EXPECT_FALSE(again.haveLost()) << "it is there again";
  tracks.follow({first}, width, height);
  EXPECT_FALSE(tracks.haveLost()) << "a second is over";
  EXPECT_EQ(tracks.predict(width, height).size(), 1u);
}

// It has moved since it was seen last, by 40 pixels in many images: it does not move as far until the next.
TEST(MarkerTracks, WhatIsSeenAgainHasNoSpeed)
{
  const SeenMarker first = seenAt(150., 150., 40., 1);
  MarkerTracks tracks;
  tracks.follow({first, seenAt(300., 300., 15., 2)}, width, height);
  for (int image = 0; image < 20; ++image) {
    tracks.follow({first}, width, height);
  }
  tracks.follow({first, seenAt(340., 300., 15., 2)}, width, height);
  EXPECT_FALSE(tracks.haveLost());
  const std::vector<PixelBox> boxes = tracks.predict(width, height);
  ASSERT_EQ(boxes.size(), 2u);
  EXPECT_TRUE(contains(boxes[1], seenAt(342., 300., 15., 2).outline, 4.));
  EXPECT_NEAR((tracks.getExpected()[1].center - Eigen::Vector2d(340., 300.)).norm(), 0., 1e-9);
}

TEST(MarkerTracks, WhereAllAreLostTheWholeImageIsLookedAt)
{
  MarkerTracks tracks;
  tracks.follow({seenAt(150., 150., 40., 1)}, width, height);
  tracks.follow({}, width, height);
  EXPECT_TRUE(tracks.predict(width, height).empty());
}

TEST(MarkerTracks, WhatTurnsUpElsewhereIsNotLost)
{
  MarkerTracks tracks;
  const SeenMarker first = seenAt(150., 150., 40., 1);
  tracks.follow({first, seenAt(550., 400., 30., 2)}, width, height);
  tracks.follow({first, seenAt(150., 400., 30., 2)}, width, height);
  EXPECT_FALSE(tracks.haveLost());
}

TEST(MarkerTracks, WhatWasWholeHasToBeWholeIfThatIsAsked)
{
  const SeenMarker whole = seenAt(150., 150.);
  SeenMarker part = whole;
  part.isWhole = false;
  MarkerTracks tracks;
  tracks.follow({whole}, width, height);
  tracks.predict(width, height);
  EXPECT_TRUE(tracks.areWhole());
  EXPECT_TRUE(tracks.haveAll({part}));
  EXPECT_FALSE(tracks.haveAll({part}, true));
  EXPECT_TRUE(tracks.haveAll({whole}, true));
  tracks.follow({part}, width, height);
  tracks.predict(width, height);
  EXPECT_FALSE(tracks.areWhole());
  EXPECT_TRUE(tracks.haveAll({part}, true));
}

TEST(MarkerTracks, WhatIsExpectedOutsideOfTheImageIsNot)
{
  MarkerTracks tracks;
  tracks.follow({seenAt(100., 150., 40., 1)}, width, height);
  tracks.follow({seenAt(50., 150., 40., 1)}, width, height);
  tracks.follow({}, width, height, true);
  EXPECT_FALSE(tracks.haveAll({})) << "at the border it is still expected";
  tracks.follow({}, width, height, true);
  EXPECT_TRUE(tracks.haveAll({}));
}

TEST(MarkerTracks, MarkersWithoutACodeAreToldApartByPlace)
{
  MarkerTracks tracks;
  const SeenMarker left = seenAt(150., 150., 30., -1);
  const SeenMarker right = seenAt(450., 150., 30., -1);
  tracks.follow({left, right}, width, height);
  tracks.predict(width, height);
  EXPECT_TRUE(tracks.haveAll({left, right}));
  EXPECT_FALSE(tracks.haveAll({left, seenAt(160., 150., 30., -1)})) << "twice the same place";
}

TEST(MarkerTracks, ExpectsTheOutlineWhereItMovesTo)
{
  MarkerTracks tracks;
  tracks.follow({seenAt(200., 150., 40.)}, width, height);
  tracks.predict(width, height);
  ASSERT_EQ(tracks.getExpected().size(), 1u);
  EXPECT_EQ(tracks.getExpected()[0].center, Eigen::Vector2d(200., 150.)); // its speed is not known yet
  tracks.follow({seenAt(206., 147., 42.)}, width, height);
  tracks.predict(width, height);
  ASSERT_EQ(tracks.getExpected().size(), 1u);
  const EllipseParameters expected = tracks.getExpected()[0];
  EXPECT_EQ(expected.center, Eigen::Vector2d(212., 144.));
  EXPECT_NEAR(expected.a, 44., 1e-9);
  EXPECT_NEAR(expected.b, 0.7 * 44., 1e-9);
  EXPECT_EQ(expected.angle, 0.5);
  tracks.predict(width, height + 1); // another camera
  EXPECT_TRUE(tracks.getExpected().empty());
}

TEST(MarkerTracks, FastMarkersHaveRoomToChangeTheirSpeed)
{
  MarkerTracks tracks;
  constexpr double way = 120.; // pixels in an image
  tracks.follow({seenAt(340. - 2. * way, 240.)}, width, height);
  tracks.follow({seenAt(340. - way, 240.)}, width, height);
  const std::vector<PixelBox> boxes = tracks.predict(width, height);
  ASSERT_EQ(boxes.size(), 1u);
  EXPECT_TRUE(contains(boxes[0], seenAt(340., 240.).outline, 0.5 * way)) << "half as far as it came";
}

TEST(MarkerTracks, GrowingMarkersHaveRoomToGrow)
{
  MarkerTracks tracks;
  tracks.follow({seenAt(320., 240., 40.)}, width, height);
  tracks.follow({seenAt(320., 240., 60.)}, width, height);
  const std::vector<PixelBox> boxes = tracks.predict(width, height);
  ASSERT_EQ(boxes.size(), 1u);
  EXPECT_TRUE(contains(boxes[0], seenAt(320., 240., 80.).outline, 8.));
}

TEST(MarkerTracks, BoxesThatOneGrowsIntoAreOneAsWell)
{
  // The first touches neither of the others, but the box around both of them, which is made later, reaches over it.
  MarkerTracks tracks;
  const SeenMarker first = seenAt(150., 290., 30., 1);
  const SeenMarker large = seenAt(200., 110., 60., 2);
  const SeenMarker beside = seenAt(360., 200., 30., 3);
  tracks.follow({first, large}, width, height);
  EXPECT_EQ(tracks.predict(width, height).size(), 2u);
  tracks.clear();
  tracks.follow({first, beside}, width, height);
  EXPECT_EQ(tracks.predict(width, height).size(), 2u);
  tracks.clear();
  tracks.follow({first, large, beside}, width, height);
  const std::vector<PixelBox> boxes = tracks.predict(width, height);
  ASSERT_EQ(boxes.size(), 1u);
  for (const SeenMarker &marker : {first, large, beside}) {
    EXPECT_TRUE(contains(boxes[0], marker.outline, 8.));
  }
}

TEST(MarkerTracks, AMarkerOfAnotherFamilyIsAnotherOne)
{
  MarkerTracks tracks;
  const SeenMarker golay23 = seenAt(150., 150.);
  tracks.follow({golay23}, width, height);
  tracks.predict(width, height);
  EXPECT_TRUE(tracks.haveAll({golay23}));
  SeenMarker bch31 = golay23;
  bch31.family = vpCircleMarkerFamily::BCH31;
  EXPECT_FALSE(tracks.haveAll({bch31}));
}

TEST(MarkerTracks, OfTwoThatItMayHaveBeenItWasTheNearer)
{
  // Two rings, one inside of the other's reach; the second one moves by -2 pixels and the first is gone.
  MarkerTracks tracks;
  tracks.follow({seenAt(200., 200., 40., -1), seenAt(245., 200., 40., -1)}, width, height);
  tracks.follow({seenAt(243., 200., 40., -1)}, width, height);
  tracks.predict(width, height);
  ASSERT_EQ(tracks.getExpected().size(), 1u);
  EXPECT_NEAR(tracks.getExpected()[0].center.x(), 241., 1e-9);
}
