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
 * Test of the covariance where neighbouring pixels pull together.
 */

#include "testFitTools.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include "refine/fit_step.h"
#include "refine/likelihood.h"

using namespace fit_test;

namespace {
//! Least and largest ratio of the variances that a fit reports to those of a fit to the whole print.
struct Widening
{
  double least = 0.;
  double largest = 0.;
};

/*!
  Mean over prints in two halves, of which one lies a little beside where it should.
  \param moved : Where the second half lies, on the print, in radii.
*/
Widening wideningOf(const Eigen::Vector2d &moved, Random &random)
{
  constexpr int count = 20;
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  const vpImage<unsigned char> I(side, side, 0);
  Widening mean;
  for (int i = 0; i < count; ++i) {
    const int id = randomId(random, family);
    Case made = makeCase(markerScene(random, family, id, 80., 0.3, side), id, I);
    const MarkerPlane plane = made.scene.plane();
    Case beside = made;
    beside.scene.center += plane.radius * plane.rotation.leftCols<2>() * moved;
    fillFromModel(made, Light(), BlurParameters(), 2., random);
    fillFromModel(beside, Light(), BlurParameters(), 2., random);
    const auto whole = fitAll(made.pixels, plane, made.pattern, settingsOf(family));
    for (std::size_t k = 0; k < made.pixels.size(); ++k) {
      if (made.pixels[k].offset.x() > 0.f) {
        made.pixels[k].grey = beside.pixels[k].grey;
      }
    }
    const auto torn = fitAll(made.pixels, plane, made.pattern, settingsOf(family));
    EXPECT_TRUE(whole && torn);
    if (whole && torn) {
      const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> ratios(torn->covariance,
                                                                                         whole->covariance);
      mean.least += ratios.eigenvalues().minCoeff() / count;
      mean.largest += ratios.eigenvalues().maxCoeff() / count;
    }
  }
  return mean;
}
} // namespace

TEST(Coherence, AWholePrintIsKnownAsWellWhateverItsNoise)
{
  Random random = randomOfTest();
  const Widening widening = wideningOf(Eigen::Vector2d::Zero(), random);
  EXPECT_GT(widening.least, 0.8);
  EXPECT_LT(widening.largest, 1.3);
}

// The halves disagree about some directions of the pose much more than about others.
TEST(Coherence, ATornPrintIsLessSureOfWhatItsHalvesDisagreeAbout)
{
  Random random = randomOfTest();
  for (const double angle : {0., 0.7, 1.5}) {
    const Widening widening = wideningOf(0.01 * Eigen::Vector2d(std::cos(angle), std::sin(angle)), random);
    EXPECT_GT(widening.least, 5.) << angle;
    EXPECT_GT(widening.largest, 2. * widening.least) << angle;
  }
}

namespace {
/*!
  Noise of standard deviation 1 that neighbours share, as that of compressed or sharpened pictures, at every pixel.
  \param passes : Of the mean of a pixel and its neighbours, 1 : 2 : 1, in both directions; 0: independent noise.
*/
vpImage<double> sharedNoise(int passes, Random &random)
{
  std::normal_distribution<double> normal(0., 1.);
  vpImage<double> noise(side, side);
  for (unsigned int i = 0; i < noise.getSize(); ++i) {
    noise.bitmap[i] = normal(random);
  }
  for (int pass = 0; pass < passes; ++pass) {
    vpImage<double> smooth(side, side);
    for (unsigned int v = 0; v < side; ++v) {
      for (unsigned int u = 0; u < side; ++u) { // over the border of the image to its other side
        const unsigned int left = (u + side - 1) % side, right = (u + 1) % side;
        const unsigned int up = (v + side - 1) % side, down = (v + 1) % side;
        const auto row = [&](unsigned int line) {
          return noise[line][left] + 2. * noise[line][u] + noise[line][right];
        };
        smooth[v][u] = (row(up) + 2. * row(v) + row(down)) / 16.;
      }
    }
    noise = smooth;
  }
  double squares = 0.;
  for (unsigned int i = 0; i < noise.getSize(); ++i) {
    squares += noise.bitmap[i] * noise.bitmap[i] / noise.getSize();
  }
  for (unsigned int i = 0; i < noise.getSize(); ++i) {
    noise.bitmap[i] /= std::sqrt(squares);
  }
  return noise;
}

//! A marker of 80 pixels in noise of 2 grey levels that neighbours share, by the model, without bends. share: of the
//! noise's variance that they share; the rest is each pixel's own.
Case markerInNoise(int passes, Random &random, double share = 1.)
{
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  const int id = randomId(random, family);
  Case made = makeCase(markerScene(random, family, id, 80., uniform(random, 0.3, 0.8), side), id,
                       vpImage<unsigned char>(side, side, 0));
  fillFromModel(made, Light(), BlurParameters(), 0., random);
  vpImage<double> noise = sharedNoise(passes, random);
  if (share < 1.) {
    const vpImage<double> own = sharedNoise(0, random);
    for (unsigned int i = 0; i < noise.getSize(); ++i) {
      noise.bitmap[i] = std::sqrt(share) * noise.bitmap[i] + std::sqrt(1. - share) * own.bitmap[i];
    }
  }
  const ImageFrame frame = made.scene.frame();
  for (FitPixel &pixel : made.pixels) {
    const Eigen::Vector2d place = frame.center + frame.size * pixel.offset.cast<double>();
    pixel.grey += static_cast<float>(
        2. *
        noise[static_cast<unsigned int>(std::lround(place.y()))][static_cast<unsigned int>(std::lround(place.x()))]);
  }
  return made;
}

//! Fits in noise that neighbours share.
struct NoisyFits
{
  double distance = 0.; // mean squared Mahalanobis distance of the truth
  int coherent = 0;     // number of those whose neighbours pull together
};

NoisyFits fitsInNoise(int passes, int count, Random &random)
{
  NoisyFits mean;
  for (int i = 0; i < count; ++i) {
    Case made = markerInNoise(passes, random);
    const auto fit =
        fitAll(made.pixels, disturbed(made.scene.plane(), random, 0.01), made.pattern, settingsOf(made.scene.family));
    EXPECT_TRUE(fit);
    if (fit) {
      mean.distance += mahalanobis(*fit, made.scene.plane(), true) / count;
      mean.coherent += fit->coherence > 1. ? 1 : 0;
    }
  }
  return mean;
}
} // namespace

// What is within chance is not told: once in 740 of each of the sizes of parts that are compared.
TEST(Coherence, IndependentNoiseIsSeldomCoherent)
{
  Random random = randomOfTest();
  constexpr int count = 200;
  const NoisyFits fits = fitsInNoise(0, count, random);
  EXPECT_LE(fits.coherent, 5); // of 1000 others, seven
}

// What neighbours share a little is mostly within chance, and yet a part of it is in the covariance: more than of
// independent noise, of which nearly nothing is.
TEST(Coherence, WhatMayBeChanceCountsInPart)
{
  Random random = randomOfTest();
  constexpr int count = 200;
  const auto meanWidening = [&](double share) {
    double widening = 0.;
    int withinChance = 0;
    for (int i = 0; i < count; ++i) {
      Case made = markerInNoise(1, random, share);
      FitSettings settings = settingsOf(made.scene.family);
      const auto told = fitAll(made.pixels, made.scene.plane(), made.pattern, settings);
      settings.exactBends = false;
      const auto asIfAlone = fitAll(made.pixels, made.scene.plane(), made.pattern, settings);
      if (told && asIfAlone && told->coherence == 1.) {
        widening += told->covariance.trace() / (asIfAlone->covariance.trace() * told->edgeNoise);
        ++withinChance;
      }
    }
    EXPECT_GT(withinChance, count / 2);
    return widening / withinChance;
  };
  const double independent = meanWidening(0.), shared = meanWidening(0.1);
  RecordProperty("independent", std::to_string(independent)); // 1.03 and 1.10 seen; it was 1 for both
  RecordProperty("shared", std::to_string(shared));
  EXPECT_GT(independent, 0.98);
  EXPECT_LT(independent, 1.06);
  EXPECT_GT(shared, independent + 0.04);
}

// What neighbours share moves the pose more than as many independent pixels would, by variances up to seven times as
// large; the covariance knows, in each direction of the pose.
TEST(Coherence, NoiseThatNeighboursShareIsInTheCovariance)
{
  Random random = randomOfTest();
  constexpr int count = 150;
  double distance = 0.;
  for (const int passes : {1, 2}) {
    const NoisyFits fits = fitsInNoise(passes, count, random);
    EXPECT_GE(fits.coherent, 0.98 * count) << passes;
    distance += fits.distance / 2.;
  }
  RecordProperty("distance", std::to_string(distance));
  // Of 300 chi-square variables with 6 degrees of freedom the mean is known to 0.2; four of that.
  EXPECT_NEAR(distance, 6., 0.8);
}

// The sums are those of the place where the last step began: what pulled the whole pose along was no disagreement.
TEST(Coherence, TheLastStepIsNoPull)
{
  Random random = randomOfTest();
  constexpr double noise = 2.;
  constexpr int count = 20;
  int withStep = 0;
  int withoutStep = 0;
  for (int i = 0; i < count; ++i) {
    Case made = markerInNoise(0, random);
    const FitSettings settings = settingsOf(made.scene.family);
    const auto fit = fitAll(made.pixels, made.scene.plane(), made.pattern, settings);
    ASSERT_TRUE(fit);
    MarkerPlane beside = fit->plane;
    beside.center.x() +=
        12. * std::sqrt(fit->covariance(0, 0)); // a step that is long, but not for the noise of a pixel
    FitMemory memory;
    Likelihood likelihood(made.pattern, settings, memory);
    likelihood.setPixels(made.pixels, beside, fit->photometry, noise);
    const Equations equations = likelihood.linearise(beside, fit->photometry, noise);
    likelihood.keepResiduals();
    const PoseInfluence influence =
        Eigen::MatrixXd(usedPart(equations.matrix, equations.used)).inverse().topRows<poseSize>();
    const UsedVector step = usedPart(solveEquations(equations.matrix, equations.right, equations.used), equations.used);
    const UsedVector none = UsedVector::Zero(step.size());
    withStep += likelihood.coherentCovariance(influence, step, noise).ratio > 1. ? 1 : 0;
    withoutStep += likelihood.coherentCovariance(influence, none, noise).ratio > 1. ? 1 : 0;
  }
  EXPECT_LE(withStep, 2);
  EXPECT_EQ(withoutStep, count);
}

// Half of a print is too little to tell what its parts pull: they are too few.
TEST(Coherence, FewPartsTellNothing)
{
  Random random = randomOfTest();
  for (int i = 0; i < 5; ++i) {
    Case made = markerInNoise(2, random);
    const double share = i < 4 ? 0.5 : 1.; // and once all of it, which does tell
    std::vector<FitPixel> seen;
    for (const FitPixel &pixel : made.pixels) {
      const double turns = std::atan2(pixel.offset.y(), pixel.offset.x()) / (2. * M_PI) + 0.25 * i;
      if (turns - std::floor(turns) < share) {
        seen.push_back(pixel);
      }
    }
    const auto fit = fitAll(seen, made.scene.plane(), made.pattern, settingsOf(made.scene.family));
    ASSERT_TRUE(fit);
    EXPECT_EQ(fit->coherence > 1., share == 1.) << i;
  }
}
