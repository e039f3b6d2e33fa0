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
 * Pictures as drawing programs make them: a few samples a pixel, and no noise.
 */

#include "detector_scenes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include <opencv2/imgproc.hpp>

using namespace detector_test;

namespace {
constexpr int samples = 4; // along each side of a pixel: pixels of an edge are off by 2 grey levels, some by 10
constexpr double ink = 20.;
constexpr double paper = 210.;

//! Grey level of the print at a place, outer radii; the word's first sector is the most significant of so many bits.
double greyOfPrint(double x, double y, unsigned long word, int sectors)
{
  const double r = std::hypot(x, y);
  if (r >= 0.8 && r <= 1.) {
    return ink;
  }
  if (sectors == 0 || r < 0.4 || r > 0.68) {
    return paper;
  }
  const double turn = std::atan2(y, x) / (2. * M_PI);
  const int sector = std::min(static_cast<int>((turn - std::floor(turn)) * sectors), sectors - 1);
  return (word >> (sectors - 1 - sector)) & 1u ? ink : paper;
}

/*!
  A print on a square sheet, blurred by 0.6 pixels, sampled and rounded.
  \e cover: Grey level of what covers a sample at an image point, pixels; negative: nothing does.
*/
vpImage<unsigned char> drawn(const vpHomogeneousMatrix &cMo, unsigned long word, int sectors, double ground,
                             const std::function<double(double, double)> &cover)
{
  const vpCameraParameters cam = straightCamera();
  const Eigen::Matrix3d R = rotationOf(cMo);
  const Eigen::Vector3d t = translationOf(cMo);
  cv::Mat fine(static_cast<int>(height) * samples, static_cast<int>(width) * samples, CV_32F);
  for (int i = 0; i < fine.rows; ++i) {
    for (int j = 0; j < fine.cols; ++j) {
      const double u = (j + 0.5) / samples - 0.5;
      const double v = (i + 0.5) / samples - 0.5;
      const Eigen::Vector3d ray((u - cam.get_u0()) / cam.get_px(), (v - cam.get_v0()) / cam.get_py(), 1.);
      const Eigen::Vector3d point = R.col(2).dot(t) / R.col(2).dot(ray) * ray - t;
      const double x = R.col(0).dot(point) / (0.5 * size);
      const double y = R.col(1).dot(point) / (0.5 * size);
      const bool isSheet = std::max(std::abs(x), std::abs(y)) < 7. / 6.;
      const double covered = cover(u, v);
      fine.at<float>(i, j) = static_cast<float>(covered >= 0. ? covered
                                                : isSheet     ? greyOfPrint(x, y, word, sectors)
                                                              : ground);
    }
  }
  cv::GaussianBlur(fine, fine, cv::Size(), 0.6 * samples);
  cv::Mat coarse;
  cv::resize(fine, coarse, cv::Size(width, height), 0., 0., cv::INTER_AREA);
  vpImage<unsigned char> I(height, width);
  for (unsigned int i = 0; i < height; ++i) {
    for (unsigned int j = 0; j < width; ++j) {
      I[i][j] = static_cast<unsigned char>(std::lround(coarse.at<float>(static_cast<int>(i), static_cast<int>(j))));
    }
  }
  return I;
}

double nothing(double, double)
{
  return -1.;
}
} // namespace

namespace {
/*!
  Mean squared Mahalanobis distance of the truth from the poses of drawn golay23, over the degrees of freedom.
  \e noise: Standard deviation of what is added to each pixel, grey levels.
*/
double distanceInNoise(double noise, int count, Random &random)
{
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  vpDetectorCircleMarker detector(family);
  detector.setZAlignedWithCameraAxis(true);
  std::normal_distribution<double> normal;
  double sum = 0.;
  for (int i = 0; i < count; ++i) {
    const vpHomogeneousMatrix truth = randomPose(random, uniform(random, 50., 140.), uniform(random, 0.1, 1.05));
    const int id = randomId(random, family);
    vpImage<unsigned char> I = drawn(truth, family.getCodeword(id), 23, uniform(random, 0., 255.), nothing);
    for (unsigned int k = 0; noise > 0. && k < I.getSize(); ++k) {
      I.bitmap[k] = static_cast<unsigned char>(std::clamp(std::lround(I.bitmap[k] + noise * normal(random)), 0L, 255L));
    }
    std::vector<vpHomogeneousMatrix> cMo;
    const bool isFound = detector.detect(I, size, straightCamera(), cMo);
    EXPECT_TRUE(isFound && detector.getDetections()[0].id == id) << i;
    sum += isFound ? mahalanobis(truth, cMo[0], detector.getCovariance(0), 6) / 6. : HUGE_VAL;
  }
  return sum / count;
}
} // namespace

// What each pixel of an edge is off by is neither noise, which there is none of, nor an outlier.
TEST(DetectorDrawn, CovarianceWithoutNoise)
{
  Random random = randomOfTest();
  const double distance = distanceInNoise(0., 30, random);
  RecordProperty("distance", std::to_string(distance));
  // The errors of neighbours along an edge are alike, and the covariance knows that only roughly.
  EXPECT_LT(distance, 3.);
}

// In noise it is below what chance may do in half of the pictures, and counts in part.
TEST(DetectorDrawn, CovarianceInNoise)
{
  Random random = randomOfTest();
  const double distance = distanceInNoise(2., 30, random);
  RecordProperty("distance", std::to_string(distance));
  EXPECT_LT(distance, 2.2);
}

// Edges that are drawn by few samples are not what covers a ring.
TEST(DetectorDrawn, CoveredRingsWithoutNoise)
{
  Random random = randomOfTest();
  constexpr int count = 30;
  vpDetectorCircleMarker detector(vpCircleMarkerFamily::RING);
  int found = 0;
  for (int i = 0; i < count; ++i) {
    const double u = uniform(random, 250., 390.);
    const double v = uniform(random, 200., 280.);
    const double diameter = uniform(random, 50., 140.);
    const vpHomogeneousMatrix truth = randomPose(random, diameter, uniform(random, 0.1, 1.05), u, v);
    const double direction = uniform(random, 0., 2. * M_PI);
    const double grey = uniform(random, 0., 255.);
    const auto halfPlane = [&](double x, double y) { // beyond 0.4 radii: it covers a quarter of a disc
      const double along = (x - u) * std::cos(direction) + (y - v) * std::sin(direction);
      return along > 0.4 * 0.5 * diameter ? grey : -1.;
    };
    std::vector<vpHomogeneousMatrix> cMo;
    const vpImage<unsigned char> I = drawn(truth, 0, 0, uniform(random, 0., 255.), halfPlane);
    const bool isSeen = detector.detect(I, size, straightCamera(), cMo);
    found += isSeen && vpImagePoint::distance(detector.getDetections()[0].center, vpImagePoint(v, u)) < 1. ? 1 : 0;
  }
  RecordProperty("found", std::to_string(found));
  EXPECT_GE(found, count - 1);
}
