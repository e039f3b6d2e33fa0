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
 * The thresholds of the gradient, which follow the noise.
 */

#include "testRoomTools.h"

#include "segment/gradient.h"

using namespace circle_marker;
using namespace room_test;

TEST(Gradient, PureNoiseStartsNothing)
{
  Random random = randomOfTest();
  for (const double sigma : {0.5, 3., 12.}) {
    const vpImage<unsigned char> I = digitise(greyPlane(640, 480, 127., 0., 0.), sigma, random);
    Gradient gradient;
    computeGradient(I, gradient);
    int starts = 0;
    int continued = 0;
    for (int y = 0; y < 480; ++y) {
      for (int x = 0; x < 640; ++x) {
        const int squared = gradient.squaredMagnitude(x, y);
        starts += squared >= gradient.startAt * gradient.startAt;
        continued += squared >= gradient.continueAbove * gradient.continueAbove;
      }
    }
    EXPECT_EQ(starts, 0) << "sigma " << sigma;
    EXPECT_LT(continued, 640 * 480 / 1000) << "sigma " << sigma;
    EXPECT_LT(gradient.continueAbove, gradient.startAt);
  }
}

TEST(Gradient, ThresholdsFollowTheNoise)
{
  Random random = randomOfTest();
  Gradient gradient;
  double previous = 0.;
  for (const double sigma : {4., 8., 16.}) {
    computeGradient(digitise(greyPlane(1280, 960, 127., 0., 0.), sigma, random), gradient);
    if (previous > 0.) {
      EXPECT_NEAR(gradient.startAt / previous, 2., 0.1);
    }
    previous = gradient.startAt;
  }
}

// Rows are worked on in runs of 1024 columns: the ends of runs, and of images that end near one, are as all others.
TEST(Gradient, IsSobelsInEveryColumn)
{
  Random random = randomOfTest();
  Gradient gradient;
  for (const unsigned int width : {16U, 17U, 1023U, 1024U, 1025U, 1026U, 1027U, 2050U, 2051U}) {
    vpImage<unsigned char> I(17, width);
    for (unsigned int i = 0; i < I.getSize(); ++i) {
      I.bitmap[i] = static_cast<unsigned char>(random() % 256);
    }
    computeGradient(I, gradient);
    int differing = 0;
    for (unsigned int v = 0; v < 17; ++v) {
      for (unsigned int u = 0; u < width; ++u) {
        int dx = 0;
        int dy = 0;
        if (u > 0 && v > 0 && u + 1 < width && v + 1 < 17) {
          for (int k = -1; k <= 1; ++k) {
            const int weight = k == 0 ? 2 : 1;
            dx += weight * (I[v + k][u + 1] - I[v + k][u - 1]);
            dy += weight * (I[v + 1][u + k] - I[v - 1][u + k]);
          }
        }
        const GradientVector &found = gradient.at(static_cast<int>(u), static_cast<int>(v));
        differing += found.dx != dx || found.dy != dy;
      }
    }
    EXPECT_EQ(differing, 0) << width;
  }
}

TEST(Gradient, LeastStepWithoutNoise)
{
  // A sharp vertical step of 7 grey levels starts a chain, one of 6 does not; 4 goes on, 3 does not.
  Gradient gradient;
  for (int step = 1; step <= 12; ++step) {
    vpImage<unsigned char> I(64, 64, 100);
    for (unsigned int v = 0; v < 64; ++v) {
      for (unsigned int u = 32; u < 64; ++u) {
        I[v][u] = static_cast<unsigned char>(100 + step);
      }
    }
    computeGradient(I, gradient);
    EXPECT_EQ(gradient.at(32, 30).dx, 4 * step);
    EXPECT_EQ(gradient.at(32, 30).dy, 0);
    EXPECT_EQ(gradient.squaredMagnitude(32, 30) >= gradient.startAt * gradient.startAt, step >= 7) << step;
    EXPECT_EQ(gradient.squaredMagnitude(32, 30) >= gradient.continueAbove * gradient.continueAbove, step >= 4) << step;
  }
}

TEST(Gradient, PointsToTheBrightSide)
{
  Gradient gradient;
  const EllipseScene disc = {Eigen::Vector2d(40., 40.), 20., 20., 0.};
  computeGradient(photograph(80, 80, 0.7, disc), gradient);
  for (int k = 0; k < 16; ++k) {
    const double angle = 2. * M_PI * k / 16.;
    const int x = static_cast<int>(std::lround(40. + 20. * std::cos(angle)));
    const int y = static_cast<int>(std::lround(40. + 20. * std::sin(angle)));
    const Eigen::Vector2d g(gradient.at(x, y).dx, gradient.at(x, y).dy);
    EXPECT_GT(g.normalized().dot(Eigen::Vector2d(std::cos(angle), std::sin(angle))), 0.98);
  }
}

// An earlier, wider image of stripes has edges where, in its memory, the rows of another one begin and end.
TEST(Gradient, MemoryOfAnEarlierImageIsForgotten)
{
  vpImage<unsigned char> striped(200, 200);
  for (unsigned int v = 0; v < striped.getHeight(); ++v) {
    for (unsigned int u = 0; u < striped.getWidth(); ++u) {
      striped[v][u] = u / 6 % 2 == 0 ? 30 : 220;
    }
  }
  const EllipseScene disc = {Eigen::Vector2d(80., 90.), 40., 40., 0.};
  const vpImage<unsigned char> I = photograph(157, 180, 0.7, disc);
  Gradient fresh;
  computeGradient(I, fresh);
  Gradient used;
  computeGradient(striped, used);
  computeGradient(I, used);
  for (int y = 0; y < fresh.height; ++y) {
    for (int x = 0; x < fresh.width; ++x) {
      ASSERT_EQ(used.at(x, y).dx, fresh.at(x, y).dx) << x << ", " << y;
      ASSERT_EQ(used.at(x, y).dy, fresh.at(x, y).dy) << x << ", " << y;
      if (y % rowsBetweenStarts == firstStartRow) {
        const auto column = static_cast<std::size_t>(x);
        ASSERT_EQ(used.strong[used.strongIndex(y) + column], fresh.strong[fresh.strongIndex(y) + column]) << x;
      }
    }
  }
}

TEST(Gradient, AfterTheDeadlineNothingOfAnEarlierImageIsLeft)
{
  const EllipseScene disc = {Eigen::Vector2d(60., 60.), 40., 40., 0.};
  const vpImage<unsigned char> I = photograph(120, 120, 0.7, disc);
  Gradient gradient;
  computeGradient(I, gradient);
  const Deadline passed(1e-6);
  while (!passed.hasPassed()) {
  }
  computeGradient(I, gradient, passed);
  for (const GradientVector &vector : gradient.vectors) {
    ASSERT_EQ(vector.squared(), 0);
  }
}
