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
