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
 * Light, sensor, motion and compression of the simulated camera.
 */

#include <opencv2/imgcodecs.hpp>

#include <visp3/core/vpExponentialMap.h>

#include "jpeg_loss.h"
#include "test_support.h"

using namespace simulator_test;

namespace {

vpMarkerSceneSimulator emptyScene(double grey, const vpScenePhotometry &photometry, unsigned int width = 640,
                                  unsigned int height = 480)
{
  vpMarkerSceneSimulator simulator(pinhole(width, height), width, height);
  simulator.setPhotometry(photometry);
  simulator.setBackground(vpSceneBackground::plain(grey));
  return simulator;
}

vpImage<float> noiseFree(const vpMarkerSceneSimulator &simulator)
{
  vpImage<float> I;
  simulator.renderNoiseFree(I);
  return I;
}

} // namespace

TEST(Sensor, LightGradientChangesByTheStatedShareOverTheImage)
{
  vpScenePhotometry photometry = idealSensor();
  photometry.gradientU = 0.3;
  photometry.gradientV = -0.2;
  const vpImage<float> I = noiseFree(emptyScene(100., photometry));
  for (unsigned int i = 0; i < 480; i += 7) {
    for (unsigned int j = 0; j < 640; j += 7) {
      EXPECT_NEAR(I[i][j], 100. * (1. + 0.3 * (j - 319.5) / 640. - 0.2 * (i - 239.5) / 480.), 1e-4);
    }
  }
  photometry.lightCenter = vpImagePoint(10., 600.);
  const vpImage<float> J = noiseFree(emptyScene(100., photometry));
  EXPECT_NEAR(J[10][600], 100., 1e-4);
  EXPECT_NEAR(J[10][600] - J[10][0], 100. * 0.3 * 600. / 640., 1e-3);
}

TEST(Sensor, ShadowHasItsEdgeAndDepth)
{
  vpScenePhotometry photometry = idealSensor();
  photometry.shadow = vpSceneShadow{vpImagePoint(200., 300.), M_PI / 2., 0.6, 3.};
  const vpImage<float> I = noiseFree(emptyScene(150., photometry));
  EXPECT_NEAR(I[100][17], 150., 1e-3);
  EXPECT_NEAR(I[300][17], 90., 1e-3);
  EXPECT_NEAR(I[200][17], 120., 1e-3);
  // Phi(1) = 0.8413447; less a pixel's mean: half of 1/12 times the second derivative, -0.2419707 / 3^2.
  EXPECT_NEAR(I[203][17], 150. * (1. - 0.4 * (0.8413447 - 0.0011202)), 1e-3);
}

// Two ways to cast it meet where its penumbra is as wide as ten pixels of blur and more.
TEST(Sensor, WideShadowsMultiplyPixels)
{
  const auto image = [](double penumbra) {
    vpMarkerSceneSimulator simulator(pinhole(120, 100, 400.), 120, 100);
    vpScenePhotometry photometry = idealSensor();
    photometry.blurSigma = 0.7;
    photometry.shadow = vpSceneShadow{vpImagePoint(50., 60.), 0.4, 0.5, penumbra};
    simulator.setPhotometry(photometry);
    simulator.addMarker(vpSimulatedMarker::circle("bch31", 7, 0.18).setPose(tiltedPose(0., 0., 1., 0.5, 2., 0.)));
    return noiseFree(simulator);
  };
  const vpImage<float> narrow = image(29.99);
  const vpImage<float> wide = image(30.01);
  double worst = 0.;
  for (unsigned int k = 0; k < wide.getSize(); ++k) {
    worst = std::max(worst, std::fabs(static_cast<double>(narrow.bitmap[k]) - wide.bitmap[k]));
  }
  EXPECT_LT(worst, 0.5); // grey levels
  EXPECT_NO_THROW(image(1e6));
}

// A defocus blurs the shadow behind a sheet as that on it: else what lies behind would show through.
TEST(Sensor, ShadowsOutOfFocusAreTheSameOnSheetAndBackground)
{
  for (const double radius : {0., 3., 8.}) {
    const auto image = [radius](double background) {
      vpMarkerSceneSimulator simulator(pinhole(160, 120, 400.), 160, 120);
      vpScenePhotometry photometry = idealSensor();
      photometry.blurSigma = 0.7;
      photometry.defocusRadius = radius;
      photometry.shadow = vpSceneShadow{vpImagePoint(60., 83.), 0.4, 0.4, 1.};
      simulator.setPhotometry(photometry);
      simulator.setBackground(vpSceneBackground::plain(background));
      simulator.addMarker(vpSimulatedMarker::circle("bch31", 7, 0.18).setPose(tiltedPose(0., 0., 1., 0., 0., 0.)));
      return noiseFree(simulator);
    };
    const vpImage<float> onBlack = image(0.);
    const vpImage<float> onGrey = image(200.);
    double worst = 0.;
    for (unsigned int i = 45; i < 75; ++i) { // well inside of the sheet
      for (unsigned int j = 60; j < 100; ++j) {
        worst = std::max(worst, std::fabs(static_cast<double>(onBlack[i][j]) - onGrey[i][j]));
      }
    }
    EXPECT_LT(worst, 0.1) << "radius " << radius;
  }
}

TEST(Sensor, ReflectionAddsToLightAndDark)
{
  vpScenePhotometry photometry = idealSensor();
  photometry.gradientU = 0.5;
  const vpImage<float> without[] = {noiseFree(emptyScene(150., photometry)), noiseFree(emptyScene(20., photometry))};
  photometry.reflection = vpSceneReflection{vpImagePoint(200., 300.), 40., 60.};
  const vpImage<float> with[] = {noiseFree(emptyScene(150., photometry)), noiseFree(emptyScene(20., photometry))};
  for (int k = 0; k < 2; ++k) {
    EXPECT_NEAR(with[k][200][300] - without[k][200][300], 60., 1e-3);
    EXPECT_NEAR(with[k][240][300] - without[k][240][300], 60. * 0.6065307, 1e-3); // exp(-1 / 2)
    EXPECT_NEAR(with[k][200][220] - without[k][200][220], 60. * 0.1353353, 1e-3); // exp(-2)
  }
  photometry.reflection->radius = 0.;
  EXPECT_THROW(emptyScene(150., photometry), vpException);
}

TEST(Sensor, GammaBendsTheScaleBetweenBlackAndWhite)
{
  vpScenePhotometry photometry = idealSensor();
  photometry.gamma = 0.5;
  EXPECT_NEAR(noiseFree(emptyScene(63.75, photometry))[5][5], 127.5, 1e-3);
  EXPECT_NEAR(noiseFree(emptyScene(255., photometry))[5][5], 255., 1e-3);
  EXPECT_NEAR(noiseFree(emptyScene(400., photometry))[5][5], 255., 1e-3);
}

TEST(Sensor, RoundsAndClamps)
{
  const vpScenePhotometry photometry = idealSensor();
  vpImage<unsigned char> I;
  for (const auto &[grey, byte] :
       {std::pair(99.4, 99), std::pair(99.6, 100), std::pair(-20., 0), std::pair(300., 255)}) {
    emptyScene(grey, photometry).render(I, 0);
    EXPECT_EQ(I[3][3], byte);
  }
}

TEST(Sensor, NoiseIsNormalAndIndependent)
{
  vpScenePhotometry photometry = idealSensor();
  photometry.noiseSigma = 8.;
  const vpMarkerSceneSimulator simulator = emptyScene(127.3, photometry, 1280, 960);
  vpImage<unsigned char> I, J;
  simulator.render(I, 1);
  simulator.render(J, 2);
  const unsigned int n = I.getSize();
  double mean = 0.;
  for (unsigned int k = 0; k < n; ++k) {
    mean += I.bitmap[k];
  }
  mean /= n;
  double second = 0., fourth = 0., beside = 0., below = 0., other = 0.;
  unsigned int beyond = 0;
  const unsigned int width = I.getWidth();
  for (unsigned int k = 0; k + width < n; ++k) {
    const double d = I.bitmap[k] - mean;
    second += d * d;
    fourth += d * d * d * d;
    beside += d * (I.bitmap[k + 1] - mean);
    below += d * (I.bitmap[k + width] - mean);
    other += d * (J.bitmap[k] - mean);
    beyond += std::fabs(d) > 24.5; // 3.06 sigma
  }
  const double m = n - width;
  // Bounds: 5 standard deviations of each statistic. Rounding adds 1/12 to the variance.
  const double variance = 64. + 1. / 12.;
  EXPECT_NEAR(mean, 127.3, 5. * std::sqrt(variance / n));
  EXPECT_NEAR(second / m, variance, 5. * variance * std::sqrt(2. / m));
  EXPECT_NEAR(fourth / m / (variance * variance), 3., 5. * std::sqrt(96. / m));
  for (const double covariance : {beside, below, other}) {
    EXPECT_NEAR(covariance / m / variance, 0., 5. / std::sqrt(m));
  }
  // Levels 103 ... 151 lie within 24.5 of the mean: tails below 102.5 and above 151.5, in standard deviations 3.1
  // and 3.025.
  const double tails = 0.5 * std::erfc(24.8 / 8. / M_SQRT2) + 0.5 * std::erfc(24.2 / 8. / M_SQRT2);
  EXPECT_NEAR(beyond / m, tails, 5. * std::sqrt(tails / m));
}

TEST(Sensor, SameSeedSameBytes)
{
  vpMarkerSceneSimulator simulator(pinhole(320, 240, 500.), 320, 240);
  simulator.setBackground(vpSceneBackground::clutter(11));
  simulator.addMarker(vpSimulatedMarker::circle("golay23", 5, 0.18).setPose(tiltedPose(0., 0., 1., 0.5, 1., 2.)));
  vpImage<unsigned char> I, J, K;
  simulator.render(I, 7);
  vpMarkerSceneSimulator again = simulator;
  again.setBackground(vpSceneBackground::clutter(11));
  again.render(J, 7);
  simulator.render(K, 8);
  EXPECT_TRUE(I == J);
  EXPECT_FALSE(I == K);
  again.setBackground(vpSceneBackground::clutter(12));
  again.render(K, 7);
  EXPECT_FALSE(I == K);
}

TEST(Sensor, ClutterFillsTheImageWithContrast)
{
  vpMarkerSceneSimulator simulator(pinhole(640, 480), 640, 480);
  simulator.setPhotometry(idealSensor());
  simulator.setBackground(vpSceneBackground::clutter(5, 300));
  const vpImage<float> I = noiseFree(simulator);
  for (unsigned int block = 0; block < 12; ++block) { // blocks of 160 x 160
    float least = 1e9f, most = -1e9f;
    for (unsigned int k = 0; k < 160 * 160; ++k) {
      const float grey = I[block / 4 * 160 + k / 160][block % 4 * 160 + k % 160];
      least = std::min(least, grey);
      most = std::max(most, grey);
    }
    EXPECT_GT(most - least, 80.f) << "block " << block;
    EXPECT_GE(least, 0.f);
    EXPECT_LE(most, 255.f);
  }
}

TEST(Sensor, PhotoIsStretchedOverTheImage)
{
  vpImage<unsigned char> photo(24, 32);
  for (unsigned int i = 0; i < 24; ++i) {
    for (unsigned int j = 0; j < 32; ++j) {
      photo[i][j] = static_cast<unsigned char>(4 * j + 3 * i);
    }
  }
  vpMarkerSceneSimulator same(pinhole(32, 24), 32, 24);
  same.setPhotometry(idealSensor());
  same.setBackground(vpSceneBackground::photo(photo));
  vpImage<unsigned char> I;
  same.render(I, 0);
  EXPECT_TRUE(I == photo);
  vpMarkerSceneSimulator twice(pinhole(64, 48), 64, 48);
  twice.setPhotometry(idealSensor());
  twice.setBackground(vpSceneBackground::photo(photo));
  const vpImage<float> J = noiseFree(twice);
  EXPECT_NEAR(J[20][30], 4. * (30.5 / 2. - 0.5) + 3. * (20.5 / 2. - 0.5), 1e-4);
}

TEST(Sensor, MotionIsTheMeanOverTheExposure)
{
  // Three pixels to the right, camera against the marker: the marker's image moves to the left.
  vpMarkerSceneSimulator simulator(pinhole(160, 120, 400.), 160, 120);
  vpScenePhotometry photometry = idealSensor();
  photometry.blurSigma = 0.7;
  simulator.setPhotometry(photometry);
  const vpHomogeneousMatrix cMo = tiltedPose(0., 0., 1., 0.4, 1., 0.3);
  simulator.addMarker(vpSimulatedMarker::circle("golay23", 5, 0.18).setPose(cMo));
  vpSceneMotion motion;
  motion.twist[0] = 3. / 400.;
  motion.twist[4] = 0.002;
  motion.steps = 2;
  simulator.setMotion(motion);
  const vpImage<float> mean = noiseFree(simulator);
  EXPECT_LT((vpHomogeneousMatrix(simulator.getTruth()[0].cMo.inverse() * cMo).getTranslationVector().sumSquare()),
            1e-20); // the middle of the exposure
  vpImage<float> expected(120, 160, 0.f);
  simulator.setMotion(vpSceneMotion());
  for (const double instant : {-0.25, 0.25}) {
    // The camera's displacement, small: translation along x, rotation about y.
    const vpHomogeneousMatrix displacement = vpExponentialMap::direct(instant * motion.twist);
    EXPECT_NEAR(displacement[0][3], instant * 3. / 400., 1e-5);
    simulator.setMarkerPose(0, displacement.inverse() * cMo);
    const vpImage<float> I = noiseFree(simulator);
    for (unsigned int k = 0; k < I.getSize(); ++k) {
      expected.bitmap[k] += 0.5f * I.bitmap[k];
    }
  }
  for (unsigned int k = 0; k < mean.getSize(); ++k) {
    ASSERT_NEAR(mean.bitmap[k], expected.bitmap[k], 1e-3);
  }
}

TEST(Sensor, MotionBlurOfAnEdgeIsARamp)
{
  vpMarkerSceneSimulator simulator(pinhole(80, 60, 1000.), 80, 60);
  vpScenePhotometry photometry = idealSensor();
  photometry.blurSigma = 0.7;
  simulator.setPhotometry(photometry);
  simulator.setBackground(vpSceneBackground::plain(220.));
  const double edge = 38.3, length = 6.;
  simulator.addMarker(vpSimulatedMarker::bitmap(vpImage<unsigned char>(1, 1, 0), 1., 1.)
                          .setPose(tiltedPose((edge - 39.5) / 1000. + 0.5, 0., 1., 0., 0., 0.)));
  vpSceneMotion motion;
  motion.twist[0] = length / 1000.;
  simulator.setMotion(motion);
  const vpImage<float> I = noiseFree(simulator);
  for (unsigned int j = 25; j < 52; ++j) {
    double mean = 0.;
    const int n = 4000; // over the pixel's width and the exposure: 63 x 63 and more would do
    for (int k = 0; k < n; ++k) {
      const double golden = k * 0.6180339887498949;
      const double x = j - 0.5 + (k + 0.5) / n;
      const double moved = edge + length * (golden - std::floor(golden) - 0.5);
      mean += 220. - 190. * 0.5 * std::erfc(-(x - moved) / (0.7 * M_SQRT2));
    }
    EXPECT_NEAR(I[30][j], mean / n, 0.1) << "column " << j;
  }
}

TEST(Sensor, JpegQualitiesThatAreNoneAreRefusedWhereTheyAreSet)
{
  vpMarkerSceneSimulator simulator(pinhole(20, 20, 300.), 20, 20);
  vpScenePhotometry photometry;
  for (const int quality : {0, 101}) {
    photometry.jpegQuality = quality;
    EXPECT_THROW(simulator.setPhotometry(photometry), vpException) << quality;
  }
}

TEST(Sensor, JpegLosesWhatTheLibraryLoses)
{
  vpMarkerSceneSimulator simulator(pinhole(203, 157, 300.), 203, 157); // no multiples of 8
  simulator.addMarker(vpSimulatedMarker::circle("golay23", 5, 0.18).setPose(tiltedPose(0., 0., 1., 0.5, 1., 2.)));
  vpImage<unsigned char> I;
  simulator.render(I, 3);
  for (const int quality : {30, 75, 95}) {
    const cv::Mat image(157, 203, CV_8UC1, I.bitmap);
    std::vector<unsigned char> file;
    ASSERT_TRUE(cv::imencode(".jpg", image, file, {cv::IMWRITE_JPEG_QUALITY, quality}));
    const cv::Mat expected = cv::imdecode(file, cv::IMREAD_GRAYSCALE);
    vpImage<unsigned char> J = I;
    marker_simulator::loseToJpeg(quality, J);
    double squares = 0.;
    unsigned int equal = 0;
    unsigned int lost = 0;
    for (int i = 0; i < 157; ++i) {
      for (int j = 0; j < 203; ++j) {
        const double difference = static_cast<double>(J[i][j]) - expected.at<unsigned char>(i, j);
        squares += difference * difference;
        equal += difference == 0.;
        lost += J[i][j] != I[i][j];
      }
    }
    // The library computes in whole numbers and rounds a coefficient that lies halfway the other way now and then,
    // which shows most at a high quality, with its small steps of 1 to 3: 0.2 to 0.8 grey levels root-mean-square.
    EXPECT_LT(std::sqrt(squares / (157. * 203.)), 1.) << "quality " << quality;
    EXPECT_GT(equal, 0.7 * 157. * 203.) << "quality " << quality;
    EXPECT_GT(lost, 0.5 * 157. * 203.) << "quality " << quality;
  }
  vpImage<unsigned char> J = I;
  EXPECT_THROW(marker_simulator::loseToJpeg(0, J), vpException);
}
