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
 * Tests of the comparison of codewords by what they leave of a blurred image.
 */

#include "decode/blurred_words.h"

#include <limits>

#include <Eigen/Cholesky>

#include <gtest/gtest.h>

#include "testRoomTools.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 200; // pixels
constexpr double lens = 0.7;       // blur, pixels
constexpr int way = 15;            // pixels

//! What light, of three parameters, and one contrast of ring and black sectors leave: least squares with four unknowns.
double leftBy(CyclicCode::Word word, const BlurredFit &fit, int sectors)
{
  constexpr int light = BlurredFit::lightSize;
  Eigen::MatrixXd parts = Eigen::MatrixXd::Zero(fit.matrix.rows(), light + 1);
  parts.topLeftCorner(light, light).setIdentity();
  parts(BlurredFit::ringAt, light) = 1.;
  for (int k = 0; k < sectors; ++k) {
    parts(BlurredFit::firstSector + k, light) = isSectorBlack(word, k, sectors) ? 1. : 0.;
  }
  const Eigen::VectorXd right = parts.transpose() * fit.right;
  return fit.total - right.dot((parts.transpose() * fit.matrix * parts).ldlt().solve(right));
}
} // namespace

TEST(BlurredWords, TheBestTwoAreThoseThatLeaveLeast)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  const CyclicCode &code = codeOf(family);
  for (int i = 0; i < 3; ++i) {
    MarkerScene scene = markerScene(random, family, static_cast<int>(random() % family.getNbIds()), 80.,
                                    uniform(random, 0., 0.6), side);
    scene.sheet = 2.;
    const vpImage<unsigned char> I = digitise(moved(expose(side, side, lens, scene), way), 1., random);
    const CameraModel camera(scene.camera());
    BlurredMarker marker(I, camera, family);
    BlurredFit fit;
    fit.plane = scene.plane();
    fit.blur.motion = Eigen::Vector2d(way, 0.);
    marker.select(fit.plane, fit.blur, 500);
    marker.solve(fit);
    double least = std::numeric_limits<double>::max();
    double next = least;
    code.forEachCodeword([&](CyclicCode::Word word) {
      const double left = leftBy(word, fit, static_cast<int>(code.getLength()));
      next = std::min(next, std::max(left, least));
      least = std::min(least, left);
    });
    const BestWords words = bestWords(fit, code, Deadline());
    EXPECT_EQ(words.best, scene.word);
    EXPECT_NEAR(words.squares, least, 1e-6 * fit.plain);
    EXPECT_NEAR(words.next, next, 1e-6 * fit.plain);
    EXPECT_LT(words.squares, 0.01 * fit.plain);
  }
}
