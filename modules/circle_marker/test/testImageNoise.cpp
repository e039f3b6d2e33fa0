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
 * The noise of an image, independent from pixel to pixel or not.
 */

#include "testRoomTools.h"

#include <algorithm>
#include <map>
#include <vector>

#include "segment/image_noise.h"

using namespace circle_marker;
using namespace room_test;

namespace {
// Standard deviation of the noise with the rounding to whole grey levels.
double withRounding(double sigma)
{
  return std::sqrt(sigma * sigma + 1. / 12.);
}

// Of noise that must be told to be independent.
double independentNoiseOf(const vpImage<unsigned char> &I)
{
  const ImageNoise noise = estimateNoise(I);
  EXPECT_EQ(noise.sharing, 1.);
  return noise.sigma;
}

//! Independent noise of a standard deviation, grey levels.
vpImage<double> whiteNoise(unsigned int width, unsigned int height, double sigma, Random &random)
{
  std::normal_distribution<double> normal(0., sigma);
  vpImage<double> noise(height, width);
  for (unsigned int i = 0; i < noise.getSize(); ++i) {
    noise.bitmap[i] = normal(random);
  }
  return noise;
}

//! Each pixel becomes the mean of a square of so many: of white noise the standard deviation falls by that number.
vpImage<double> meansOfSquares(const vpImage<double> &I, unsigned int side)
{
  vpImage<double> means(I.getHeight() - side + 1, I.getWidth() - side + 1);
  for (unsigned int v = 0; v < means.getHeight(); ++v) {
    for (unsigned int u = 0; u < means.getWidth(); ++u) {
      double sum = 0.;
      for (unsigned int k = 0; k < side * side; ++k) {
        sum += I[v + k / side][u + k % side];
      }
      means[v][u] = sum / (side * side);
    }
  }
  return means;
}

//! A picture with noise.
vpImage<unsigned char> pictureOf(const vpImage<double> &scene, const vpImage<double> &noise, Random &random)
{
  vpImage<double> sum(noise.getHeight(), noise.getWidth());
  for (unsigned int v = 0; v < sum.getHeight(); ++v) {
    for (unsigned int u = 0; u < sum.getWidth(); ++u) {
      sum[v][u] = scene[v][u] + noise[v][u];
    }
  }
  return digitise(sum, 0., random);
}
} // namespace

TEST(ImageNoise, OfFlatImages)
{
  Random random = randomOfTest();
  for (double sigma = 1.; sigma <= 20.; sigma *= 1.13) {
    const vpImage<unsigned char> I = digitise(greyPlane(1280, 960, 127.3, 0., 0.), sigma, random);
    EXPECT_NEAR(independentNoiseOf(I), withRounding(sigma), 0.05 * sigma) << "sigma " << sigma;
  }
}

TEST(ImageNoise, OfTiltedImages)
{
  Random random = randomOfTest();
  for (double sigma = 1.; sigma <= 20.; sigma *= 1.17) {
    // 60 sigma of 20 are 20 grey levels short of the range's ends in the corners: no clamping that counts.
    const double slope = uniform(random, -0.06, 0.06);
    const vpImage<unsigned char> I = digitise(greyPlane(1280, 960, 127., slope, 0.5 * slope), sigma, random);
    EXPECT_NEAR(independentNoiseOf(I), withRounding(sigma), 0.05 * sigma) << "sigma " << sigma << " slope " << slope;
  }
}

TEST(ImageNoise, StepsAreNoNoise)
{
  Random random = randomOfTest();
  for (int i = 0; i < 10; ++i) {
    // A straight edge and a disc: the median must not see them.
    const double angle = uniform(random, 0., 2. * M_PI);
    const EllipseScene disc = {Eigen::Vector2d(160., 120.), 60., 40., angle};
    const vpImage<double> exposed = expose(
        320, 240, 0.8,
        [&](double u, double v) {
          return 0.5 * disc(u, v) + ((u - 100.) * std::cos(angle) + (v - 90.) * std::sin(angle) > 0. ? 100. : 0.);
        },
        4);
    const vpImage<unsigned char> clean = digitise(exposed, 0., random);
    EXPECT_LT(independentNoiseOf(clean), 0.1);
    // Coarse: an image of 320 x 240 has only 1200 samples, which fix a median to 3.4 %.
    const vpImage<unsigned char> noisy = digitise(exposed, 5., random);
    EXPECT_NEAR(independentNoiseOf(noisy), withRounding(5.), 0.13 * 5.);
  }
}

// Edges are noise for the Laplacians: a frame full of them, an eighth flat at least, is told by its flat blocks. The
// median of 20 frames of 640 x 480 is off by less than 2 % (the Laplacians alone say up to 7 % more), each by 6 %.
TEST(ImageNoise, BesideManyEdges)
{
  Random random = randomOfTest();
  std::map<double, std::vector<double>> told; // by the noise
  for (int k = 0; k < 20; ++k) {
    const double period = uniform(random, 20., 32.); // pixels
    const double tilt = uniform(random, 0.2, 0.6);
    const double border = uniform(random, 80., 240.);
    const auto greyAt = [&](double u, double v) {
      const double along = std::sin(M_PI / period * (u * std::cos(tilt) + v * std::sin(tilt)));
      const double across = std::sin(M_PI / period * (v * std::cos(tilt) - u * std::sin(tilt)));
      return u > border && along * across > 0. ? 80. : 170.;
    };
    const vpImage<double> scene = expose(640, 480, 0.8, greyAt, 3);
    for (const double sigma : {1., 2., 5.}) {
      const ImageNoise noise = estimateNoise(digitise(scene, sigma, random));
      EXPECT_EQ(noise.sharing, 1.);
      EXPECT_NEAR(noise.sigma, withRounding(sigma), 0.06 * withRounding(sigma)) << sigma << ' ' << period;
      told[sigma].push_back(noise.sigma / withRounding(sigma));
    }
  }
  for (auto &[sigma, ofFrames] : told) {
    std::nth_element(ofFrames.begin(), ofFrames.begin() + 10, ofFrames.end());
    EXPECT_NEAR(ofFrames[10], 1., 0.02) << sigma;
  }
}

// Where noise grows with the light the flattest blocks are the darkest: they do not tell for all, however much the
// variance of the others differs.
TEST(ImageNoise, ThatGrowsWithTheLight)
{
  Random random = randomOfTest();
  std::normal_distribution<double> normal(0., 1.);
  vpImage<double> noise(480, 640);
  double squares = 0.;
  for (unsigned int v = 0; v < 480; ++v) {
    for (unsigned int u = 0; u < 640; ++u) {
      const double variance = (40. + 0.25 * u) / 20.; // of as many electrons
      squares += variance / noise.getSize();
      noise[v][u] = std::sqrt(variance) * normal(random);
    }
  }
  const vpImage<unsigned char> I = pictureOf(greyPlane(640, 480, 120., 0.25, 0.), noise, random);
  EXPECT_GT(independentNoiseOf(I), 0.92 * withRounding(std::sqrt(squares))); // the median's is less than the mean's
}

// Means of four pixels: the noise of a quarter of a block, 4 x 4 pixels, is that of 3.1 pixels that share all of it (in
// one dimension four neighbours have the weights 1/2, 1, 1, 1, 1/2: the variance of their mean is 3.5 / 16 of that of a
// white pixel, 1.75 / 4 of their own). Means of nine: 1, 2, 3, 3, 2, 1 thirds, 28 / 9 / 16, 2.33 / 4 of their own; 5.4.
TEST(ImageNoise, ThatPixelsShare)
{
  Random random = randomOfTest();
  for (const double sigma : {6., 12., 20.}) {
    for (const auto &[side, sharing] : {std::pair<unsigned int, double>(2, 3.06), {3, 5.44}}) {
      const vpImage<double> means = meansOfSquares(whiteNoise(960, 720, sigma, random), side);
      const vpImage<double> scene = greyPlane(960, 720, 127., uniform(random, -0.03, 0.03), 0.);
      const ImageNoise noise = estimateNoise(pictureOf(scene, means, random));
      EXPECT_NEAR(noise.sigma, withRounding(sigma / side), 0.1 * sigma / side) << sigma << ' ' << side;
      EXPECT_NEAR(noise.sharing, sharing, 0.2 * sharing) << sigma << ' ' << side;
    }
  }
}

// The flat tenth of a picture tells: of each picture coarsely, some 25 blocks.
TEST(ImageNoise, SharedInPicturesOfEdges)
{
  Random random = randomOfTest();
  constexpr int pictures = 10;
  ImageNoise mean = {0., 0.};
  for (int k = 0; k < pictures; ++k) {
    vpImage<double> scene = greyPlane(640, 480, 120., 0., 0.);
    for (int i = 0; i < 400; ++i) {
      const double grey = uniform(random, 40., 200.);
      const auto left = static_cast<unsigned int>(uniform(random, 0., 600.));
      const auto top = static_cast<unsigned int>(uniform(random, 0., 440.));
      for (unsigned int v = top; v < top + 40; ++v) {
        for (unsigned int u = left; u < left + 40; ++u) {
          scene[v][u] = grey;
        }
      }
    }
    const vpImage<double> noise = meansOfSquares(whiteNoise(641, 481, 8., random), 2);
    const ImageNoise estimate = estimateNoise(pictureOf(scene, noise, random));
    EXPECT_NEAR(estimate.sigma, withRounding(4.), 0.15 * 4.);
    EXPECT_GT(estimate.sharing, 1.5);
    mean.sigma += estimate.sigma / pictures;
    mean.sharing += estimate.sharing / pictures;
  }
  EXPECT_NEAR(mean.sigma, withRounding(4.), 0.06 * 4.);
  EXPECT_NEAR(mean.sharing, 3.06, 0.2 * 3.06);
}

// Grey levels that are cut off have no noise, and say nothing of the others'.
TEST(ImageNoise, SharedBesideOverExposedPaper)
{
  Random random = randomOfTest();
  const vpImage<double> noise = meansOfSquares(whiteNoise(641, 481, 8., random), 2);
  vpImage<double> scene = greyPlane(640, 480, 127., 0., 0.);
  for (unsigned int i = 0; i < scene.getSize(); ++i) {
    scene.bitmap[i] += i % 640 < 400 ? 300. : 0.;
  }
  const ImageNoise estimate = estimateNoise(pictureOf(scene, noise, random));
  EXPECT_NEAR(estimate.sigma, withRounding(4.), 0.15 * 4.);
  EXPECT_GT(estimate.sharing, 2.);
}

// No texture that is in five sixths of the image is taken for noise, nor is it where there are few blocks to ask.
TEST(ImageNoise, IndependentBesideTexture)
{
  Random random = randomOfTest();
  for (const double sigma : {1., 4.}) {
    vpImage<double> scene = greyPlane(640, 480, 127., 0., 0.);
    for (unsigned int v = 0; v < 480; ++v) {
      for (unsigned int u = 0; u < 640; ++u) {
        scene[v][u] += u < 540 ? 20. * std::sin(0.7 * u) * std::sin(0.6 * v) : 0.;
      }
    }
    EXPECT_EQ(estimateNoise(digitise(scene, sigma, random)).sharing, 1.) << sigma;
  }
  const vpImage<double> noise = meansOfSquares(whiteNoise(41, 41, 8., random), 2);
  EXPECT_EQ(estimateNoise(pictureOf(greyPlane(40, 40, 127., 0., 0.), noise, random)).sharing, 1.);
  EXPECT_EQ(estimateNoise(vpImage<unsigned char>(2, 2, 100)).sigma, 0.);
}

// A checker and stripes of some pixels that leave a sixth of the picture's blocks, or a thirteenth, are noise for the
// Laplacians, and the thirteenth is not the tenth that is flat elsewhere. The rest tells; what is less than half as
// much again is left to the Laplacians.
TEST(ImageNoise, FineTextureInMostOfAPicture)
{
  Random random = randomOfTest();
  for (const double sigma : {1., 3., 8.}) {
    for (const double period : {2.5, 4., 6.}) {
      for (const bool isChecker : {true, false}) {
        // Texture with less than four times the noise is not told from it by so few blocks.
        const double border = isChecker && sigma < 8. ? 290. : 256.;
        const double tilt = uniform(random, 0.2, 0.6);
        const vpImage<double> scene = expose(320, 480, 0.7, [&](double u, double v) {
          const double along = std::sin(M_PI / period * (u * std::cos(tilt) + v * std::sin(tilt)));
          const double across = isChecker ? std::sin(M_PI / period * (v * std::cos(tilt) - u * std::sin(tilt))) : 1.;
          return u >= border ? 127. : 127. + std::copysign(70., along * across);
        });
        const ImageNoise noise = estimateNoise(digitise(scene, sigma, random));
        EXPECT_GT(noise.sigma, 0.85 * withRounding(sigma)) << period << ' ' << isChecker;
        EXPECT_LT(noise.sigma, 1.6 * withRounding(sigma)) << period << ' ' << isChecker;
        EXPECT_EQ(noise.sharing, 1.);
      }
    }
  }
}

// Without noise, rounding makes waves of a slope.
TEST(ImageNoise, RoundingIsIndependent)
{
  Random random = randomOfTest();
  for (int k = 0; k < 20; ++k) {
    const vpImage<double> slope =
        greyPlane(640, 480, 127.3, uniform(random, -0.15, 0.15), uniform(random, -0.15, 0.15));
    EXPECT_EQ(estimateNoise(digitise(slope, 0.1, random)).sharing, 1.) << k;
  }
}

// Interpolated between the pixels of another picture, a few of them to the side and more so to the right, linearly: as
// an undistorted picture is. With noise of 1.5 grey levels, 0.8 of which are left, rounding's is a part of it.
TEST(ImageNoise, OfResampledPictures)
{
  Random random = randomOfTest();
  for (const double sigma : {1.5, 3., 8.}) {
    const vpImage<double> white = whiteNoise(680, 520, sigma, random);
    const double slope = uniform(random, 0.01, 0.04);
    vpImage<double> resampled(480, 640);
    for (unsigned int v = 0; v < 480; ++v) {
      for (unsigned int u = 0; u < 640; ++u) {
        const double x = 2. + (1. + slope) * u;
        const double y = 3. + (1. + slope) * v;
        const auto left = static_cast<unsigned int>(x);
        const auto top = static_cast<unsigned int>(y);
        const double p = x - left;
        const double q = y - top;
        resampled[v][u] = (1. - q) * ((1. - p) * white[top][left] + p * white[top][left + 1]) +
                          q * ((1. - p) * white[top + 1][left] + p * white[top + 1][left + 1]);
      }
    }
    const vpImage<double> scene = greyPlane(680, 520, 127., uniform(random, -0.05, 0.05), 0.02);
    EXPECT_TRUE(estimateNoise(pictureOf(scene, resampled, random)).isResampled) << sigma;
    EXPECT_FALSE(estimateNoise(pictureOf(scene, white, random)).isResampled) << sigma;
    // What is the same everywhere is no matter of the phase.
    EXPECT_FALSE(estimateNoise(pictureOf(scene, meansOfSquares(white, 2), random)).isResampled) << sigma;
    EXPECT_FALSE(estimateNoise(pictureOf(scene, meansOfSquares(white, 3), random)).isResampled) << sigma;
  }
}

// Independent noise is independent beside texture, as long as that leaves a sixth of the picture.
TEST(ImageNoise, IndependentIsNotResampled)
{
  Random random = randomOfTest();
  for (int k = 0; k < 40; ++k) {
    const double period = uniform(random, 5., 60.); // pixels
    const double border = uniform(random, 40., 540.);
    vpImage<double> scene = greyPlane(640, 480, 127., uniform(random, -0.1, 0.1), uniform(random, -0.1, 0.1));
    for (unsigned int v = 0; v < 480; ++v) {
      for (unsigned int u = 0; u < 640; ++u) {
        scene[v][u] += u < border ? 15. * std::sin(2. * M_PI * u / period) * std::sin(2. * M_PI * v / period) : 0.;
      }
    }
    EXPECT_FALSE(estimateNoise(digitise(scene, uniform(random, 0., 6.), random)).isResampled) << k;
  }
}
