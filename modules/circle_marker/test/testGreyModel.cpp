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
 * Test of the grey levels of the model and of their derivatives.
 */

#include "testFitTools.h"

#include "refine/fit_step.h"
#include "refine/grey_model.h"

using namespace fit_test;

namespace {
//! Grey level that the model has without surround, at a place of the image.
double greyAt(const Photometry &photometry, const Eigen::Vector2d &offset, double darkness)
{
  PixelBlock block;
  block.grey.setConstant(1000.f); // so bright that no residual is cut off by what the sensor tells
  block.offsetU.setConstant(static_cast<float>(offset.x()));
  block.offsetV.setConstant(static_cast<float>(offset.y()));
  const GreyLanes grey = greyOf(block, nullptr, photometry, Lanes::Constant(static_cast<float>(darkness)));
  return 1000. - static_cast<double>(grey.residual[0]);
}

Photometry randomLight(Random &random)
{
  Photometry photometry;
  photometry.white = uniform(random, 60., 130.); // and below 255 at the brighter end
  photometry.lightGradient = Eigen::Vector2d(uniform(random, -0.4, 0.4), uniform(random, -0.4, 0.4));
  photometry.absorption = uniform(random, 0.3, 0.95);
  photometry.gamma = std::exp(uniform(random, -0.8, 0.8));
  return photometry;
}
} // namespace

TEST(GreyModel, GammaIsOfAllTheLight)
{
  // 200 (1.2 * 0.5 * (1 - 0.8 * 0.5))^2.2 far inside a shadow that leaves half of the light.
  Photometry photometry;
  photometry.white = 200.;
  photometry.lightGradient = Eigen::Vector2d(0.4, 0.);
  photometry.absorption = 0.8;
  photometry.gamma = 2.2;
  photometry.shadow = Shadow{0.5, 0., -1., 0.01};
  EXPECT_NEAR(greyAt(photometry, Eigen::Vector2d(0.5, 0.3), 0.5), 200. * std::pow(1.2 * 0.5 * 0.6, 2.2), 1e-3);
  photometry.shadow = std::nullopt;
  EXPECT_NEAR(greyAt(photometry, Eigen::Vector2d(0.5, 0.3), 0.5), 200. * std::pow(1.2 * 0.6, 2.2), 1e-3);
  photometry.gamma = 1.;
  EXPECT_NEAR(greyAt(photometry, Eigen::Vector2d(0.5, 0.3), 0.5), 200. * 1.2 * 0.6, 1e-3);
}

// Ink and paper are what they were; half-way between them it is as well, and a quarter above ink less by
// 0.5 * 0.25 * 0.75 * 0.5 of the step between both.
TEST(GreyModel, ToneCurveIsAnSBetweenInkAndPaper)
{
  Photometry photometry;
  photometry.white = 200.;
  photometry.absorption = 0.75; // grey levels 50 to 200
  const Eigen::Vector2d center = Eigen::Vector2d::Zero();
  photometry.toneCurve = -0.5;
  EXPECT_NEAR(greyAt(photometry, center, 0.), 200., 1e-3);
  EXPECT_NEAR(greyAt(photometry, center, 1.), 50., 1e-3);
  EXPECT_NEAR(greyAt(photometry, center, 0.5), 125., 1e-3);
  EXPECT_NEAR(greyAt(photometry, center, 0.75), 87.5 - 0.5 * 150. * 0.25 * 0.75 * 0.5, 1e-3);
  EXPECT_NEAR(greyAt(photometry, center, 0.25), 162.5 + 0.5 * 150. * 0.25 * 0.75 * 0.5, 1e-3);
}

// 1 + 0.2 * 0.5 - 0.1 * 0.25 + 0.3 * 0.5 * (-0.4) - 0.2 * 0.16 of the light, by the power of 2.2; so does whiteAt().
TEST(GreyModel, LightThatBends)
{
  Photometry photometry;
  photometry.white = 150.;
  photometry.lightGradient = Eigen::Vector2d(0.2, 0.);
  photometry.lightCurvature = Eigen::Vector3d(-0.1, 0.3, -0.2);
  photometry.gamma = 2.2;
  photometry.absorption = 0.8;
  const Eigen::Vector2d place(0.5, -0.4);
  EXPECT_NEAR(greyAt(photometry, place, 0.), 150. * std::pow(0.983, 2.2), 1e-3);
  EXPECT_NEAR(photometry.whiteAt(place), 150. * std::pow(0.983, 2.2), 1e-6);
  EXPECT_NEAR(greyAt(photometry, place, 0.5), 150. * std::pow(0.983 * 0.6, 2.2), 1e-3);
}

// Light, its gradient and curvature, ink, gamma, tone curve and a shadow, each against central differences along a step
// of the fit.
TEST(GreyModel, DerivativesByTheLightAgreeWithDifferences)
{
  Random random = randomOfTest();
  for (int i = 0; i < 300; ++i) {
    Photometry photometry = randomLight(random);
    if (i % 2 == 1) {
      photometry.shadow = Shadow{uniform(random, 0.3, 0.8), uniform(random, -M_PI, M_PI), uniform(random, -0.5, 0.5),
                                 uniform(random, 0.1, 0.4)};
    }
    if (i % 3 == 0) {
      photometry.toneCurve = uniform(random, -0.6, 0.6);
    }
    if (i % 5 == 0) {
      photometry.lightCurvature =
          Eigen::Vector3d(uniform(random, -0.1, 0.1), uniform(random, -0.1, 0.1), uniform(random, -0.1, 0.1));
    }
    const Eigen::Vector2d offset(uniform(random, -1., 1.), uniform(random, -1., 1.));
    const double black = uniform(random, 0., 1.);
    PixelBlock block;
    block.grey.setZero();
    block.offsetU.setConstant(static_cast<float>(offset.x()));
    block.offsetV.setConstant(static_cast<float>(offset.y()));
    DarknessLanes darkness;
    darkness.value.setConstant(static_cast<float>(black));
    for (Lanes &lanes : darkness.byTwist) {
      lanes.setOnes();
    }
    darkness.bySigma.setOnes();
    darkness.byElongation[0].setOnes();
    darkness.byElongation[1].setOnes();
    darkness.bySpread.setOnes();
    for (Lanes &lanes : darkness.byBend) {
      lanes.setOnes();
    }
    RowLanes row;
    rowOf(block, nullptr, photometry, darkness, greyOf(block, nullptr, photometry, darkness.value), row);
    constexpr double h = 1e-3;
    std::vector<int> sought = {lightAt, gradientAt, gradientAt + 1, absorptionAt, gammaAt};
    for (int k = 0; photometry.shadow && k < shadowSize; ++k) {
      sought.push_back(shadowAt + k);
    }
    if (photometry.toneCurve) {
      sought.push_back(toneAt);
    }
    for (int k = 0; photometry.lightCurvature && k < curvatureSize; ++k) {
      sought.push_back(curvatureAt + k);
    }
    const auto after = [&](int parameter, double step) {
      ParameterVector steps = ParameterVector::Zero();
      steps[parameter] = step;
      MarkerPlane plane;
      Photometry changed = photometry;
      applyStep(steps, plane, changed);
      return greyAt(changed, offset, black);
    };
    for (const int parameter : sought) {
      const double step = parameter == lightAt ? 100. * h : h;
      const double numeric = (after(parameter, step) - after(parameter, -step)) / (2. * step);
      const double analytic = static_cast<double>(row[static_cast<std::size_t>(parameter)][0]);
      EXPECT_NEAR(analytic, numeric, 0.01 * std::abs(numeric) + 0.2 / (step / h)) << "parameter " << parameter;
    }
    // And by the share of black, as all that moves edges does.
    const double numeric = (greyAt(photometry, offset, black + h) - greyAt(photometry, offset, black - h)) / (2. * h);
    for (const int parameter : {0, 5, sigmaAt, elongationAt, elongationAt + 1, spreadAt, bendAt, bendAt + 2}) {
      EXPECT_NEAR(static_cast<double>(row[static_cast<std::size_t>(parameter)][0]), numeric,
                  0.01 * std::abs(numeric) + 0.2)
          << "parameter " << parameter;
    }
  }
}
