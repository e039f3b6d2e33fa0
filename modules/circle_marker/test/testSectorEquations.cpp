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
 * Grey levels of sectors from mixtures of them, against a dense least-squares solution.
 */

#include <cmath>

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "decode/sector_equations.h"
#include "testRandom.h"

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

using namespace circle_marker;
using namespace random_test;

namespace {
constexpr double noise = 0.01;   // of a sample, share of the contrast
constexpr double ridge = 0.0025; // what holds a sector to the mean of all, for each of its samples

/*! A track and what its samples are made of. */
struct MixedTrack
{
  CodeTrack track;
  Eigen::MatrixXd mixture; //!< Of the sectors, samples x sectors.
  SectorGreys greys;       //!< Of the sectors, black and white.
};

double cumulative(double x)
{
  return 0.5 * std::erfc(-x * M_SQRT1_2);
}

//! What a sample sees of all sectors, the whole circle around, three turns of it.
Eigen::VectorXd mixtureOf(double angle, double blur, unsigned int sectors, double phase)
{
  Eigen::VectorXd row = Eigen::VectorXd::Zero(sectors);
  const int n = static_cast<int>(sectors);
  for (int k = -n; k < 2 * n; ++k) {
    const double begin = phase + 2. * M_PI * k / n;
    const double end = begin + 2. * M_PI / n;
    row[(k + n) % n] += cumulative((end - angle) / blur) - cumulative((begin - angle) / blur);
  }
  return row;
}

//! \e blur : Along the track, of a sector.
MixedTrack mixedTrack(Random &random, unsigned int sectors, unsigned int samplesOfSector, double blur, double phase)
{
  MixedTrack mixed;
  mixed.track.samples = samplesOfSector * sectors;
  mixed.mixture.resize(mixed.track.samples, sectors);
  mixed.greys.resize(sectors);
  for (unsigned int k = 0; k < sectors; ++k) {
    mixed.greys[k] = random() % 2 == 0 ? 0. : 1.;
  }
  for (unsigned int i = 0; i < mixed.track.samples; ++i) {
    const double angle = 2. * M_PI * (i + 0.5) / mixed.track.samples;
    mixed.track.blur[i] = uniform(random, 0.8, 1.) * blur * 2. * M_PI / sectors;
    mixed.mixture.row(i) = mixtureOf(angle, mixed.track.blur[i], sectors, phase);
    mixed.track.grey[i] = mixed.mixture.row(i).dot(mixed.greys) + noise * uniform(random, -1.7, 1.7);
    mixed.track.weight[i] = 1.;
  }
  return mixed;
}

//! An eighth of a sector, as the phases that are tried.
double phaseOf(unsigned int eighths, unsigned int sectors)
{
  return 2. * M_PI * eighths / (8. * sectors);
}
} // namespace

// They leave out what is farther than two sectors away, the dense ones do not.
TEST(SectorEquations, AreThoseOfADenseLeastSquaresSolution)
{
  Random random = randomOfTest();
  for (const unsigned int sectors : {23U, 31U}) {
    for (const double blur : {0.15, 0.29, 0.31, 0.5, 0.7}) { // 0.3 is where the second neighbour begins to count
      for (unsigned int eighths = 0; eighths < 8; ++eighths) {
        const double phase = phaseOf(eighths, sectors);
        const MixedTrack mixed = mixedTrack(random, sectors, 4, blur, phase);
        SectorGreys greys;
        const double squares = solveSectors(mixed.track, sectors, phase, greys);

        const Eigen::Map<const Eigen::VectorXd> seen(mixed.track.grey.data(), mixed.track.samples);
        const Eigen::MatrixXd &mixture = mixed.mixture;
        Eigen::MatrixXd products = mixture.transpose() * mixture;
        products.diagonal().array() += ridge * mixed.track.samples / sectors;
        const Eigen::VectorXd aboutMean = seen.array() - seen.mean();
        const Eigen::VectorXd dense = products.llt().solve(mixture.transpose() * aboutMean).array() + seen.mean();
        EXPECT_LT((greys - dense).cwiseAbs().maxCoeff(), 0.01) << sectors << " " << blur << " " << eighths;
        const double denseSquares = (mixture * dense - seen).squaredNorm();
        EXPECT_NEAR(squares / denseSquares, 1., 0.05) << sectors << " " << blur << " " << eighths;
      }
    }
  }
}

TEST(SectorEquations, TheRightPhaseLeavesLeast)
{
  Random random = randomOfTest();
  const unsigned int sectors = 23;
  for (unsigned int eighths = 0; eighths < 8; ++eighths) {
    const MixedTrack mixed = mixedTrack(random, sectors, 4, 0.3, phaseOf(eighths, sectors));
    SectorGreys greys;
    const double right = solveSectors(mixed.track, sectors, phaseOf(eighths, sectors), greys);
    for (unsigned int other = 0; other < 8; ++other) {
      if (other != eighths) {
        EXPECT_GT(solveSectors(mixed.track, sectors, phaseOf(other, sectors), greys), 2. * right) << eighths << other;
      }
    }
  }
}

// Squares are told from the equations: what is left, sample by sample, has to be as much.
TEST(SectorEquations, ResidualsAreThoseOfTheSquares)
{
  Random random = randomOfTest();
  const unsigned int sectors = 31;
  for (const double blur : {0.2, 0.4}) {
    MixedTrack mixed = mixedTrack(random, sectors, 8, blur, 0.);
    for (unsigned int i = 40; i < 70; ++i) { // something covers a part
      mixed.track.weight[i] = i < 60 ? 0. : 0.6;
      mixed.track.grey[i] = i % 2 == 0 ? 0.1 : 0.9;
    }
    SectorGreys greys;
    const double squares = solveSectors(mixed.track, sectors, 0., greys);
    std::array<double, mostSamples> residuals;
    findResiduals(mixed.track, 0., greys, residuals);
    double sum = 0.;
    for (unsigned int i = 0; i < mixed.track.samples; ++i) {
      sum += mixed.track.weight[i] * residuals[i] * residuals[i];
      EXPECT_TRUE(mixed.track.weight[i] > 0. || residuals[i] == 0.) << i;
    }
    EXPECT_NEAR(squares, sum, 1e-12);
    EXPECT_GT(squares, 0.1); // there is something that no sectors explain
  }
}

// Alike at all samples: sectors of one grey leave nothing, whatever rounding does.
TEST(SectorEquations, AnEvenTrackLeavesNothing)
{
  CodeTrack track;
  track.samples = 4 * 23;
  track.grey.fill(0.37);
  track.blur.fill(0.1);
  track.weight.fill(1.);
  SectorGreys greys;
  EXPECT_NEAR(solveSectors(track, 23, 0.02, greys), 0., 1e-20);
  EXPECT_NEAR((greys.array() - 0.37).abs().maxCoeff(), 0., 1e-12);
}
