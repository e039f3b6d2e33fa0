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
 * Tests of what pixels see of ring and sectors along lines, against integration of the image.
 */

#include "refine/track_lines.h"

#include <gtest/gtest.h>

#include "testRoomTools.h"

#include "support/camera_model.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 80;
constexpr double blur = 0.7;

MarkerScene narrowScene(Random &random, const vpCircleMarkerFamily &family)
{
  const double minorAxis = uniform(random, 4., 9.);
  const double diameter = uniform(random, 16., 36.);
  const int id = static_cast<int>(random() % family.getNbIds());
  MarkerScene scene = markerScene(random, family, id, diameter, std::acos(minorAxis / diameter), side);
  scene.white = 0.;
  scene.black = 1.;
  scene.sheet = 1e9;
  return scene;
}

// The pixel on the plane, by one standard deviation of blur and pixel together.
PlanePoint pointAt(const MarkerScene &scene, unsigned int u, unsigned int v)
{
  const CameraModel camera(scene.camera());
  const Eigen::Vector2d p(u, v);
  PlanePoint point = planePoint({camera.toMeter(p), camera.meterPerPixel(p)}, scene.plane());
  point.byPixel *= std::sqrt(blur * blur + 1. / 12.);
  return point;
}
} // namespace

TEST(TrackLines, AgreeWithIntegration)
{
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31}) {
    const vpCircleMarkerFamily family(type);
    const auto sectors = static_cast<int>(family.getNbSectors());
    for (int i = 0; i < 5; ++i) {
      const MarkerScene scene = narrowScene(random, family);
      const vpImage<double> truth = expose(side, side, blur, scene, 8);
      double squares = 0., worst = 0.;
      int pixels = 0;
      for (unsigned int v = 0; v < side; ++v) {
        for (unsigned int u = 0; u < side; ++u) {
          std::vector<TrackPiece> pieces;
          double black = cutLines(pointAt(scene, u, v), family.getLayout(), pieces);
          SectorVector shares = SectorVector::Zero();
          for (const TrackPiece &piece : pieces) {
            addSectors(piece, SectorBorders(sectors, 0.), shares);
          }
          for (int sector = 0; sector < sectors; ++sector) {
            black += isSectorBlack(scene.word, sector, sectors) ? shares[sector] : 0.;
          }
          const double difference = std::abs(black - truth[v][u]);
          worst = std::max(worst, difference);
          if (truth[v][u] > 0.001) {
            squares += difference * difference;
            ++pixels;
          }
        }
      }
      ASSERT_GT(pixels, 50);
      EXPECT_LT(worst, 0.05) << family.getName();
      EXPECT_LT(std::sqrt(squares / pixels), 0.008) << family.getName();
    }
  }
}

// Wherever the first sector begins, all together are what is seen of the track.
TEST(TrackLines, SectorsAreTheWholeTrack)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  const MarkerScene scene = narrowScene(random, family);
  for (unsigned int v = 30; v < 50; ++v) {
    std::vector<TrackPiece> pieces;
    cutLines(pointAt(scene, side / 2, v), family.getLayout(), pieces);
    double whole = 0.;
    for (const TrackPiece &piece : pieces) {
      EXPECT_LE(std::abs(piece.turn), M_PI);
      whole += piece.weight * (piece.after - piece.before);
    }
    for (const double start : {-7., -0.1, 0., 0.05, 2.}) {
      SectorVector shares = SectorVector::Zero();
      const SectorBorders borders(static_cast<int>(family.getNbSectors()), start);
      for (const TrackPiece &piece : pieces) {
        addSectors(piece, borders, shares);
      }
      EXPECT_NEAR(shares.sum(), whole, 1e-9);
      EXPECT_GE(shares.minCoeff(), -1e-12);
    }
  }
}

TEST(TrackLines, AreWantedWhereSectorsAreSmallerThanTheBlur)
{
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  const auto sectors = static_cast<int>(family.getNbSectors());
  const vpCircleMarkerLayout &layout = family.getLayout();
  PlanePoint point;
  point.q << 0.5 * (layout.codeInner + layout.codeOuter), 0.;
  point.byPixel = Eigen::Matrix2d::Identity() / 60.; // 60 standard deviations to the outer edge
  EXPECT_FALSE(wantsLines(point, layout, sectors));
  point.byPixel = Eigen::Matrix2d::Identity() / 6.;
  EXPECT_TRUE(wantsLines(point, layout, sectors));
  point.byPixel = Eigen::Vector2d(1. / 60., 1. / 6.).asDiagonal(); // on the long axis of a narrow ellipse
  EXPECT_TRUE(wantsLines(point, layout, sectors));
}
