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
 * Tests of the least error of a pose: published table, closed forms, laws of scale, conventions.
 */

#include <Eigen/Dense>

#include <visp3/core/vpExponentialMap.h>
#include <visp3/core/vpMath.h>

#include <visp3/circle_marker_simulator/vpMarkerPoseBound.h>

#include "test_support.h"

using namespace simulator_test;

namespace {

const vpCameraParameters cam(1600., 1600., 639.5, 479.5);

vpSimulatedMarker at(vpSimulatedMarker marker, double z, double tiltDegrees, double azimuth = 0., double spin = 0.)
{
  return marker.setPose(tiltedPose(0., 0., z, vpMath::rad(tiltDegrees), azimuth, spin));
}

vpSimulatedMarker coded()
{
  return vpSimulatedMarker::circle("golay23", 5, 0.2);
}

vpScenePhotometry photometry(double noise, double blur, double paper = 220., double ink = 30.)
{
  vpScenePhotometry result;
  result.noiseSigma = noise;
  result.blurSigma = blur;
  result.paper = paper;
  result.ink = ink;
  return result;
}

std::array<double, 5> figures(const vpPoseBound &bound)
{
  return {bound.x, bound.y, bound.z, bound.normal, bound.spin};
}

Eigen::VectorXd rendered(const vpSimulatedMarker &marker, const vpScenePhotometry &light)
{
  vpMarkerSceneSimulator simulator(cam, 1280, 960);
  simulator.setPhotometry(light);
  simulator.setBackground(vpSceneBackground::plain(light.paper));
  simulator.addMarker(marker);
  vpImage<float> I;
  simulator.renderNoiseFree(I);
  return Eigen::Map<const Eigen::VectorXf>(I.bitmap, I.getSize()).cast<double>();
}

} // namespace

// DESIGN.md, section 3: computed on its own, for a ring of 0.75-1 with a track of 24 sectors inside. Ours has a ring of
// 0.80-1, 23 sectors and a code that is not a regular comb: a few percent near, up to 12 % at 20 m.
TEST(MarkerPoseBound, AgreesWithThePublishedTable)
{
  struct Row
  {
    double z, tilt, lateral, depth, normal; // m, degrees, mm, mm, degrees
  };
  for (const Row &row : {Row{5., 30., 0.0034, 0.29, 0.013}, Row{10., 30., 0.010, 1.66, 0.038},
                         Row{10., 60., 0.014, 2.4, 0.022}, Row{20., 30., 0.040, 11.2, 0.135}}) {
    const vpPoseBound bound = vpMarkerPoseBound(cam).bound(at(coded(), row.z, row.tilt));
    const double tolerance = row.z > 10. ? 0.13 : 0.08;
    EXPECT_NEAR(1e3 * std::sqrt(0.5 * (bound.x * bound.x + bound.y * bound.y)) / row.lateral, 1., tolerance) << row.z;
    EXPECT_NEAR(1e3 * bound.z / row.depth, 1., tolerance) << row.z;
    EXPECT_NEAR(vpMath::deg(bound.normal) / row.normal, 1., tolerance) << row.z;
  }
  EXPECT_NEAR(1e3 * vpMarkerPoseBound(cam).bound(at(coded(), 10., 0.)).z, 0.90, 0.05);
}

// DESIGN.md, section 3, point 3: the plain ring is separated by 7, 19 and 3.5 standard deviations, with the code by 13,
// 33 and 4.3.
TEST(MarkerPoseBound, SeparationAgreesWithThePublishedFigures)
{
  const vpMarkerPoseBound limit(cam);
  const auto ring = vpSimulatedMarker::ring(0.2, 0.7);
  EXPECT_NEAR(limit.separation(at(ring, 10., 10.)).separation, 7., 0.5);
  EXPECT_NEAR(limit.separation(at(ring, 10., 30.)).separation, 19., 0.5);
  EXPECT_NEAR(limit.separation(at(ring, 20., 30.)).separation, 3.5, 0.1);
  EXPECT_NEAR(limit.separation(at(coded(), 10., 10.)).separation, 13., 1.);
  EXPECT_NEAR(limit.separation(at(coded(), 10., 30.)).separation, 33., 2.);
  EXPECT_NEAR(limit.separation(at(coded(), 20., 30.)).separation, 4.3, 0.5);
}

// A blur that is next to none tells the poses apart as well as none at all.
TEST(MarkerPoseBound, SeparationWithoutBlur)
{
  const auto ring = vpSimulatedMarker::ring(0.2, 0.7);
  vpScenePhotometry photometry;
  photometry.blurSigma = 0.;
  const vpMarkerPoseBound sharp(cam, photometry);
  photometry.blurSigma = 0.06;
  const vpMarkerPoseBound nearlySharp(cam, photometry);
  for (const double z : {10., 20.}) {
    const double expected = nearlySharp.separation(at(ring, z, 30.)).separation;
    EXPECT_NEAR(sharp.separation(at(ring, z, 30.)).separation / expected, 1., 0.2) << z;
  }
}

// The corners of a square are seen, too: the same print in the middle of a larger white picture has the same bound.
TEST(MarkerPoseBound, CornersOfASquareCount)
{
  const vpMarkerPoseBound limit(cam);
  vpImage<unsigned char> square(8, 8, 0);
  vpImage<unsigned char> onWhite(16, 16, 255);
  for (unsigned int i = 0; i < 8; ++i) {
    for (unsigned int j = 0; j < 8; ++j) {
      square[i][j] = (i + j) % 3 == 0 ? 255 : 0;
      onWhite[i + 4][j + 4] = square[i][j];
    }
  }
  const auto figuresOf = [&](const vpImage<unsigned char> &picture, double size) {
    return limit.bound(at(vpSimulatedMarker::bitmap(picture, size, size), 2., 30., 0., 0.25 * M_PI));
  };
  const auto alone = figuresOf(square, 0.2);
  const auto inWhite = figuresOf(onWhite, 0.4);
  EXPECT_NEAR(alone.z / inWhite.z, 1., 0.03);
  EXPECT_NEAR(alone.normal / inWhite.normal, 1., 0.03);
}

// Noise moves the difference of both poses' squares over noise^2 by a normal variable of twice the separation; the
// right pose has the separation squared less in the mean: it is beaten where a standard normal variable exceeds half
// the separation.
TEST(MarkerPoseBound, WrongChoiceIsThatOfTheSeparation)
{
  const vpMarkerPoseBound limit(cam);
  const auto ring = vpSimulatedMarker::ring(0.2, 0.7);
  for (const double z : {15., 20., 30.}) {
    const vpPoseSeparation separation = limit.separation(at(ring, z, 30.));
    EXPECT_GT(separation.separation, 0.1);
    EXPECT_NEAR(separation.wrongChoice, 0.5 * std::erfc(0.5 * separation.separation / M_SQRT2), 1e-12) << z;
  }
  EXPECT_NEAR(limit.separation(at(ring, 20., 30.)).wrongChoice, 0.040, 0.005) << "beyond half of 3.5";
}

/*
  Lateral position of a disc that faces the camera, all else known but levels and blur, which are as even about the
  centre as the lateral motion is odd. With r the disc's radius in pixels and C the contrast, an element of edge at the
  angle phi changes by C cos(phi) g(d) per pixel, g being the response across the edge: Gaussian * the pixel's square,
  seen from that direction. Summed over the pixels (Parseval),
    information = C^2 / noise^2 * r * integral over phi of cos^2(phi) integral of |G(f)|^2 df,
    G(f) = exp(-2 (pi blur f)^2) sinc(f cos(phi)) sinc(f sin(phi)).
*/
TEST(MarkerPoseBound, LateralInformationOfADiscIsTheClosedForm)
{
  const double blur = 0.9, noise = 2.5, contrast = 150., z = 4., size = 0.2, f = 1600.;
  const double radius = 0.5 * f * size / z;
  const auto sinc = [](double t) { return t == 0. ? 1. : std::sin(M_PI * t) / (M_PI * t); };
  double integral = 0.;
  constexpr int angles = 64;
  constexpr double df = 1e-3;
  for (int k = 0; k < angles; ++k) {
    const double phi = 2. * M_PI * (k + 0.5) / angles;
    double spectrum = 0.;
    for (double frequency = -1.5; frequency < 1.5; frequency += df) {
      const double G = std::exp(-2. * std::pow(M_PI * blur * frequency, 2)) * sinc(frequency * std::cos(phi)) *
                       sinc(frequency * std::sin(phi));
      spectrum += G * G * df;
    }
    integral += std::pow(std::cos(phi), 2) * spectrum * 2. * M_PI / angles;
  }
  const double perPixel = contrast * contrast / (noise * noise) * radius * integral;
  const double expected = perPixel * f * f / (z * z);

  const vpMarkerPoseBound limit(cam, photometry(noise, blur, 40. + contrast, 40.));
  const vpPoseBound bound = limit.bound(at(vpSimulatedMarker::disc(size), z, 0.));
  EXPECT_NEAR(bound.information[0][0] / expected, 1., 0.005);
  EXPECT_NEAR(bound.information[1][1] / expected, 1., 0.005);
  EXPECT_NEAR(bound.information[0][1] / expected, 0., 0.005);
}

TEST(MarkerPoseBound, IsInProportionToNoiseOverContrast)
{
  std::mt19937_64 random = seededFromTestName();
  for (int k = 0; k < 5; ++k) {
    const vpSimulatedMarker marker = at(coded(), uniform(random, 3., 15.), uniform(random, 5., 70.),
                                        uniform(random, 0., 6.), uniform(random, 0., 6.));
    const double blur = uniform(random, 0.5, 1.2);
    const auto reference = vpMarkerPoseBound(cam, photometry(2., blur, 220., 30.));
    const auto noisy = vpMarkerPoseBound(cam, photometry(5., blur, 220., 30.));
    const auto faint = vpMarkerPoseBound(cam, photometry(2., blur, 120., 44.));
    const auto a = figures(reference.bound(marker)), b = figures(noisy.bound(marker)), c = figures(faint.bound(marker));
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_NEAR(b[i] / a[i], 2.5, 0.01) << i;
      EXPECT_NEAR(c[i] / a[i], 2.5, 0.01) << i;
    }
    // The share of light beyond the sheet has no part in it, so the separation scales as well.
    EXPECT_NEAR(reference.separation(marker).separation / faint.separation(marker).separation, 2.5, 0.05);
  }
}

TEST(MarkerPoseBound, DoesNotDependOnTheStep)
{
  std::mt19937_64 random = seededFromTestName();
  for (const double tilt : {0., 3., 30., 60., 75.}) {
    const vpSimulatedMarker marker = at(coded(), uniform(random, 3., 15.), tilt, uniform(random, 0., 6.));
    vpMarkerPoseBound limit(cam);
    const auto usual = figures(limit.bound(marker));
    for (const double step : {0.02, 0.1}) {
      limit.setStep(step);
      const auto other = figures(limit.bound(marker));
      for (std::size_t i = 0; i < usual.size(); ++i) {
        // The tilt of a marker that faces the camera moves next to nothing: what there is, is nearest to rounding.
        EXPECT_NEAR(other[i] / usual[i], 1., tilt == 0. ? 0.01 : 0.005)
            << "tilt " << tilt << ", step " << step << ", figure " << i;
      }
    }
  }
}

// A small motion exp(delta) changes the image by a difference of which the part that no change of levels and blur can
// explain has the squared length delta^T information delta: checks frame, order, units and the treatment of nuisances.
TEST(MarkerPoseBound, InformationIsThatOfTheExponentialMap)
{
  std::mt19937_64 random = seededFromTestName();
  const vpScenePhotometry light = photometry(1., 0.8);
  for (int k = 0; k < 4; ++k) {
    vpSimulatedMarker marker = coded();
    marker.setPose(tiltedPose(uniform(random, -0.5, 0.5), uniform(random, -0.3, 0.3), uniform(random, 4., 6.),
                              uniform(random, 0.2, 1.), uniform(random, 0., 6.), uniform(random, 0., 6.)));
    const vpMatrix information = vpMarkerPoseBound(cam, light).bound(marker).information;
    vpColVector delta(6);
    for (unsigned int i = 0; i < 6; ++i) {
      delta[i] = uniform(random, -1., 1.) * (i < 3 ? 1e-4 : 1e-4 / 5.);
    }
    vpSimulatedMarker ahead = marker, behind = marker;
    ahead.setPose(vpExponentialMap::direct(delta) * marker.getPose());
    behind.setPose(vpExponentialMap::direct(-delta) * marker.getPose());
    const Eigen::VectorXd difference = 0.5 * (rendered(ahead, light) - rendered(behind, light));
    Eigen::MatrixXd nuisances(difference.size(), 3);
    nuisances.col(0) = rendered(marker, photometry(1., 0.8, 1., 0.));
    nuisances.col(1) = 1. - nuisances.col(0).array();
    nuisances.col(2) = rendered(marker, photometry(1., 0.81)) - rendered(marker, photometry(1., 0.79));
    const Eigen::VectorXd explained =
        nuisances * (nuisances.transpose() * nuisances).ldlt().solve(nuisances.transpose() * difference);
    const double predicted = delta.t() * (information * delta);
    EXPECT_NEAR((difference - explained).squaredNorm() / predicted, 1., 0.02);
  }
}

TEST(MarkerPoseBound, CovarianceIsTheInverseAndHoldsTheCentre)
{
  vpSimulatedMarker marker = coded();
  marker.setPose(tiltedPose(0.4, -0.3, 6., 0.5, 1., 2.));
  const vpPoseBound bound = vpMarkerPoseBound(cam).bound(marker);
  EXPECT_EQ(bound.dof, 6u);
  const vpMatrix one = bound.information * bound.covariance;
  for (unsigned int i = 0; i < 6; ++i) {
    for (unsigned int j = 0; j < 6; ++j) {
      EXPECT_NEAR(one[i][j], i == j ? 1. : 0., 1e-4);
    }
  }
  // The centre c moves by upsilon + omega x c.
  const vpTranslationVector c = marker.getPose().getTranslationVector();
  vpMatrix motion(3, 6, 0.);
  for (unsigned int i = 0; i < 3; ++i) {
    motion[i][i] = 1.;
  }
  motion.insert(-1. * c.skew(), 0, 3);
  const vpMatrix centre = motion * bound.covariance * motion.t();
  EXPECT_NEAR(std::sqrt(centre[0][0]) / bound.x, 1., 1e-6);
  EXPECT_NEAR(std::sqrt(centre[1][1]) / bound.y, 1., 1e-6);
  EXPECT_NEAR(std::sqrt(centre[2][2]) / bound.z, 1., 1e-6);
}

TEST(MarkerPoseBound, SpinOfAPlainRingIsAnyAngle)
{
  const vpSimulatedMarker marker = at(vpSimulatedMarker::ring(0.2, 0.7), 6., 40., 0.7);
  const vpPoseBound bound = vpMarkerPoseBound(cam).bound(marker);
  EXPECT_EQ(bound.dof, 5u);
  EXPECT_NEAR(bound.spin, M_PI / std::sqrt(3.), 1e-12);
  // The turn about the marker's own normal n through its centre c is delta = (c x n, n).
  const vpHomogeneousMatrix &cMo = marker.getPose();
  const vpColVector c(cMo.getTranslationVector());
  const vpColVector n = cMo.getRotationMatrix().getCol(2);
  const vpColVector moment = vpColVector::crossProd(c, n);
  vpColVector spin(6), turned(6);
  for (unsigned int i = 0; i < 3; ++i) {
    spin[i] = moment[i];
    spin[3 + i] = n[i];
  }
  const double information = spin.t() * (bound.information * spin);
  EXPECT_NEAR(information / bound.information[3][3], 0., 1e-9);
}

TEST(MarkerPoseBound, OfAnInverseMarkerIsTheSame)
{
  // Its image is the negative, so it says as much of the pose; and the end of its black sheet as little.
  for (const vpSimulatedMarker &marker : {coded(), vpSimulatedMarker::ring(0.2, 0.7)}) {
    vpSimulatedMarker inverse = marker;
    inverse.setInverse(true);
    vpMarkerPoseBound bound(cam, photometry(2., 0.7));
    const std::array<double, 5> expected = figures(bound.bound(at(marker, 5., 35.)));
    const std::array<double, 5> found = figures(bound.bound(at(inverse, 5., 35.)));
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_NEAR(found[i], expected[i], 0.01 * expected[i]) << i;
    }
  }
}

TEST(MarkerPoseBound, SheetOfUnknownSurroundCosts)
{
  vpMarkerPoseBound white(cam), unknown(cam);
  unknown.setSurround(vpMarkerPoseBound::UNKNOWN_SURROUND);
  const vpSimulatedMarker far = at(coded(), 18., 40.);
  EXPECT_GT(unknown.bound(far).z, 1.05 * white.bound(far).z);
  EXPECT_LT(unknown.separation(far).separation, 0.98 * white.separation(far).separation);
  const vpSimulatedMarker wide = at(coded().setQuietZone(2.), 18., 40.);
  EXPECT_NEAR(unknown.bound(wide).z / white.bound(wide).z, 1., 1e-6);
}

TEST(MarkerPoseBound, MirrorIsReflectedAndADiscCannotTell)
{
  vpSimulatedMarker marker = coded();
  marker.setPose(tiltedPose(0.6, 0.2, 8., 0.6, 2., 1.));
  const vpPoseSeparation separation = vpMarkerPoseBound(cam).separation(marker);
  EXPECT_TRUE(separation.isDistinct);
  const vpColVector sight = vpColVector(marker.getPose().getTranslationVector()).normalize();
  const vpColVector n = marker.getPose().getRotationMatrix().getCol(2);
  const vpColVector reflected = 2. * vpColVector::dotProd(n, sight) * sight - n;
  const vpColVector found = separation.mirror.getRotationMatrix().getCol(2);
  EXPECT_LT(std::acos(vpColVector::dotProd(found, reflected)), vpMath::rad(1.));

  // The image of a disc is an ellipse and belongs to two poses exactly.
  const vpPoseSeparation disc = vpMarkerPoseBound(cam).separation(at(vpSimulatedMarker::disc(0.2), 5., 30.));
  EXPECT_LT(disc.separation, 0.1);
  EXPECT_NEAR(disc.wrongChoice, 0.5, 0.02);
}

TEST(MarkerPoseBound, OfADistortedCameraIsThatOfTheSameLensNearTheAxis)
{
  // At the axis every model has the same focal length; at 0.25 rad off the axis a weak distortion changes little.
  vpCameraParameters distorted, fisheye;
  distorted.initPersProjWithDistortion(1600., 1600., 639.5, 479.5, -0.02, 0.02);
  fisheye.initProjWithKannalaBrandtDistortion(1600., 1600., 639.5, 479.5, {1. / 3. - 0.02, 2. / 15., 0., 0.});
  vpSimulatedMarker marker = coded();
  marker.setPose(tiltedPose(1.5, 1., 7., 0.5, 1., 2.));
  const auto plain = figures(vpMarkerPoseBound(cam).bound(marker));
  for (const vpCameraParameters &other : {distorted, fisheye}) {
    const auto bound = figures(vpMarkerPoseBound(other).bound(marker));
    for (std::size_t i = 0; i < plain.size(); ++i) {
      EXPECT_NEAR(bound[i] / plain[i], 1., 0.03) << i;
    }
  }
}

TEST(MarkerPoseBound, RefusesWhatHasNoBound)
{
  EXPECT_THROW(vpMarkerPoseBound(cam, photometry(0., 0.7)), vpException);
  EXPECT_THROW(vpMarkerPoseBound(cam, photometry(2., 0.7, 30., 220.)), vpException);
  vpScenePhotometry bent;
  bent.gamma = 2.2;
  EXPECT_THROW(vpMarkerPoseBound(cam, bent), vpException);
  EXPECT_THROW(vpMarkerPoseBound(cam).bound(at(coded(), 5., 120.)), vpException);
  EXPECT_THROW(vpMarkerPoseBound(cam).bound(at(coded(), -5., 0.)), vpException);
  EXPECT_THROW(vpMarkerPoseBound(cam).setStep(0.), vpException);
  // Without blur there is a bound all the same.
  const vpPoseBound sharp = vpMarkerPoseBound(cam, photometry(2., 0.)).bound(at(coded(), 5., 30.));
  EXPECT_GT(sharp.z, 0.);
  EXPECT_LT(sharp.z, vpMarkerPoseBound(cam, photometry(2., 0.7)).bound(at(coded(), 5., 30.)).z);
}
