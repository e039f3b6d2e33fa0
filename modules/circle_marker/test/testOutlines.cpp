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
 * Outlines of markers at three scales of the image.
 */

#include "ellipse/outlines.h"

#include "ellipse/fit_conic.h"
#include "testSheetTools.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 320; // pixels

// A ring that faces the camera: its outline is a circle about its centre.
MarkerScene ringScene(Random &random, double diameter)
{
  MarkerScene scene = markerScene(random, vpCircleMarkerFamily(vpCircleMarkerFamily::RING), -1, diameter, 0., side);
  scene.sheet = 2.;
  return scene;
}

// The outer outline, if it is among those of an image: of several the nearest, as arcs of it may stand for it besides.
std::optional<EllipseParameters> outlineIn(const vpImage<unsigned char> &I, const MarkerScene &scene, double diameter,
                                           OutlineMemory &memory)
{
  const SoughtCenters sought = {true, false, 0.};
  Workers workers;
  std::optional<EllipseParameters> nearest;
  double least = 0.05 * diameter;
  for (const EllipseCandidate &outline : findOutlines(I, sought, workers, Deadline(), memory)) {
    const double far = (outline.ellipse.center - scene.frame().center).norm();
    if (std::abs(outline.ellipse.a - 0.5 * diameter) < 0.05 * diameter && far < least) {
      nearest = outline.ellipse;
      least = far;
    }
  }
  return nearest;
}
} // namespace

// Through blurs with a standard deviation of up to 9 pixels: their edges are sharp at a smaller scale only, and from
// each a place comes back to the same pixels.
TEST(Outlines, AtAnyScaleAnOutlineIsWhereItIs)
{
  Random random = randomOfTest();
  for (const double blur : {0.8, 3., 6., 9.}) {
    constexpr int rings = 20;
    double squares = 0.;
    for (int i = 0; i < rings; ++i) {
      const double diameter = uniform(random, 120., 180.);
      const MarkerScene scene = ringScene(random, diameter);
      const vpImage<unsigned char> I = digitise(expose(side, side, blur, scene), 3., random);
      OutlineMemory memory;
      const auto outline = outlineIn(I, scene, diameter, memory);
      ASSERT_TRUE(outline) << "blur " << blur;
      const double far = (outline->center - scene.frame().center).norm();
      EXPECT_LT(far, 2. * (0.1 + 0.05 * blur)) << "blur " << blur;
      squares += far * far / rings;
      EXPECT_TRUE(memory.reduced[0].isUsed && memory.reduced[1].isUsed);
    }
    RecordProperty("blur " + std::to_string(blur), std::to_string(std::sqrt(squares)));
    EXPECT_LT(std::sqrt(squares), 0.7 * (0.1 + 0.05 * blur)) << "blur " << blur;
  }
}

// Where the ground is brighter than the paper, the edges of ring and sheet run into one another where they are near.
// The ring's dark line is left, of rings of up to 30 pixels.
TEST(Outlines, OfRingsOnGroundBrighterThanTheirPaper)
{
  Random random = randomOfTest();
  const double ringInner = vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23).getLayout().ringInner;
  const SoughtCenters sought = {true, false, ringInner};
  Workers workers;
  OutlineMemory memory;
  constexpr int scenes = 200;
  int found = 0;
  for (int i = 0; i < scenes; ++i) {
    MarkerScene scene = sheetScene(random, side / 2, {22., 29.}, {0., 0.9}, 150.);
    scene.white = 80.;
    scene.black = 15.;
    const vpImage<unsigned char> I = digitise(expose(side / 2, side / 2, 0.6, scene), 0.1, random);
    std::vector<Eigen::Vector2d> outer;
    for (int k = 0; k < 40; ++k) {
      const double angle = 2. * M_PI * k / 40.;
      outer.push_back(project(scene, Eigen::Vector2d(std::cos(angle), std::sin(angle))));
    }
    const EllipseParameters truth = *ellipseFromConic(*fitEllipse(outer.data(), outer.size()));
    const auto &outlines = findOutlines(I, sought, workers, Deadline(), memory);
    found += std::any_of(outlines.begin(), outlines.end(), [&](const EllipseCandidate &outline) {
      const EllipseParameters &ellipse = outline.ellipse;
      return (ellipse.center - truth.center).norm() < 0.5 && std::abs(ellipse.a - truth.a) < 0.7 &&
             std::abs(ellipse.b - truth.b) < 0.7;
    });
  }
  EXPECT_GE(found, scenes - 1);
}

TEST(Outlines, ImagesWithoutRoomAreNotReduced)
{
  Random random = randomOfTest();
  OutlineMemory memory;
  Workers workers;
  const vpImage<unsigned char> I = digitise(vpImage<double>(63, 200, 128.), 2., random);
  EXPECT_TRUE(findOutlines(I, SoughtCenters(), workers, Deadline(), memory).empty());
  EXPECT_TRUE(memory.reduced[0].isUsed);
  EXPECT_FALSE(memory.reduced[1].isUsed) << "15 pixels high";
  const vpImage<unsigned char> small = digitise(vpImage<double>(16, 16, 128.), 2., random);
  EXPECT_TRUE(findOutlines(small, SoughtCenters(), workers, Deadline(), memory).empty());
  EXPECT_FALSE(memory.reduced[0].isUsed || memory.reduced[1].isUsed);
}

TEST(Outlines, NoiseOfAllScalesIsTakenOver)
{
  OutlineMemory from;
  from.full.gradient.noise.sigma = 3.;
  from.reduced[0].gradient.noise.sigma = 2.;
  from.reduced[1].gradient.noise.sigma = 1.;
  OutlineMemory to;
  to.takeNoise(from);
  EXPECT_EQ(to.full.gradient.noise.sigma, 3.);
  EXPECT_EQ(to.reduced[0].gradient.noise.sigma, 2.);
  EXPECT_EQ(to.reduced[1].gradient.noise.sigma, 1.);
}
