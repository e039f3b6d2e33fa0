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
 * What the tests of the simulated camera share: seeds, random poses, and a referee that samples.
 */

#ifndef VP_SIMULATOR_TEST_SUPPORT_H
#define VP_SIMULATOR_TEST_SUPPORT_H

#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <random>

#include <gtest/gtest.h>

#include <visp3/core/vpPixelMeterConversion.h>

#include <visp3/circle_marker_simulator/vpMarkerSceneSimulator.h>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace simulator_test {

//! Generator seeded with the name of the running test (FNV-1a).
inline std::mt19937_64 seededFromTestName()
{
  std::uint64_t hash = 14695981039346656037u;
  for (const char *c = ::testing::UnitTest::GetInstance()->current_test_info()->name(); *c != '\0'; ++c) {
    hash = (hash ^ static_cast<unsigned char>(*c)) * 1099511628211u;
  }
  return std::mt19937_64(hash);
}

inline double uniform(std::mt19937_64 &random, double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

//! The reference camera's focal length and principal point, for an image of any size around its middle.
inline vpCameraParameters pinhole(unsigned int width, unsigned int height, double focal = 1600.)
{
  vpCameraParameters cam;
  cam.initPersProjWithoutDistortion(focal, focal, 0.5 * (width - 1.), 0.5 * (height - 1.));
  return cam;
}

//! No blur, no noise, paper 220, ink 30.
inline vpScenePhotometry idealSensor()
{
  vpScenePhotometry photometry;
  photometry.blurSigma = 0.;
  photometry.noiseSigma = 0.;
  return photometry;
}

//! Rotation about the spin axis z, then a tilt in the direction `azimuth`; position in metres, angles in radians.
inline vpHomogeneousMatrix tiltedPose(double x, double y, double z, double tilt, double azimuth, double spin)
{
  const vpRotationMatrix R = vpRotationMatrix(vpThetaUVector(tilt * std::cos(azimuth), tilt * std::sin(azimuth), 0.)) *
                             vpRotationMatrix(vpThetaUVector(0., 0., spin));
  return vpHomogeneousMatrix(vpTranslationVector(x, y, z), R);
}

//! Where the ray through a pixel meets a marker's plane, in metres, by ViSP's pixel to metre conversion.
inline std::pair<double, double> onMarker(const vpCameraParameters &cam, const vpHomogeneousMatrix &cMo, double u,
                                          double v)
{
  double x = 0.;
  double y = 0.;
  vpPixelMeterConversion::convertPoint(cam, u, v, x, y);
  // Depth at which the ray (x, y, 1) meets the plane through C with the normal n: s = n.C / n.(x, y, 1).
  const double s = (cMo[0][2] * cMo[0][3] + cMo[1][2] * cMo[1][3] + cMo[2][2] * cMo[2][3]) /
                   (cMo[0][2] * x + cMo[1][2] * y + cMo[2][2]);
  const double dx = s * x - cMo[0][3];
  const double dy = s * y - cMo[1][3];
  const double dz = s - cMo[2][3];
  return {cMo[0][0] * dx + cMo[1][0] * dy + cMo[2][0] * dz, cMo[0][1] * dx + cMo[1][1] * dy + cMo[2][1] * dz};
}

/*!
  Grey level at a point of the marker's plane, in metres; empty beyond the sheet. Stated here once more, from the
  description of the markers: outer radius 1, ring 0.80-1.00, code track 0.40-0.68.
*/
inline std::optional<double> shadeAt(const vpSimulatedMarker &marker, double x, double y, double paper, double ink)
{
  if (std::fabs(x) > 0.5 * marker.getSheetWidth() || std::fabs(y) > 0.5 * marker.getSheetHeight()) {
    return std::nullopt;
  }
  if (!marker.isCircle()) {
    const vpImage<unsigned char> &picture = marker.getPicture();
    const double column = std::floor((x / marker.getSize() + 0.5) * picture.getWidth());
    const double row = std::floor((y / marker.getHeight() + 0.5) * picture.getHeight());
    if (column < 0. || row < 0. || column >= picture.getWidth() || row >= picture.getHeight()) {
      return paper;
    }
    return ink + (paper - ink) * picture[static_cast<unsigned int>(row)][static_cast<unsigned int>(column)] / 255.;
  }
  const double r = std::hypot(x, y) / (0.5 * marker.getSize());
  if (r >= marker.getRingRatio()) {
    return r <= 1. ? ink : paper;
  }
  if (!marker.getCodeword() || r < 0.40 || r > 0.68) {
    return paper;
  }
  const double turn = std::atan2(y, x) / (2. * M_PI);
  const int n = static_cast<int>(marker.getNbSectors());
  const int sector = static_cast<int>(std::floor((turn - std::floor(turn)) * n)) % n;
  return (*marker.getCodeword() >> (n - 1 - sector)) & 1 ? ink : paper;
}

/*!
  Mean of a piecewise constant function over the pixel (u, v), by 64 x 64 cells, of which those that an edge crosses
  (their corners differ) are sampled: an edge is found to half of 1/1024 pixel, at the very worst 0.1 grey
  levels of a contrast of 190, for an edge that runs exactly along a row or column of the samples.
*/
inline double sampledPixel(const std::function<double(double, double)> &shade, double u, double v)
{
  constexpr int cells = 64;
  constexpr int samples = 256;
  // A pixel is of one shade when twice its width and height around it is, looked at in steps of an eighth: the corner
  // of a region that reaches into the pixel between two of these points is wider where it comes from.
  const double middle = shade(u, v);
  bool plain = true;
  for (int k = 0; k < 17 * 17 && plain; ++k) {
    plain = shade(u - 1. + 0.125 * (k % 17), v - 1. + 0.125 * (k / 17)) == middle;
  }
  if (plain) {
    return middle;
  }
  std::vector<double> nodes((cells + 1) * (cells + 1));
  for (int i = 0; i <= cells; ++i) {
    for (int j = 0; j <= cells; ++j) {
      nodes[i * (cells + 1) + j] =
          shade(u - 0.5 + static_cast<double>(j) / cells, v - 0.5 + static_cast<double>(i) / cells);
    }
  }
  const double goldenRatio = 0.5 * (1. + std::sqrt(5.));
  double sum = 0.;
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      const double *corner = &nodes[i * (cells + 1) + j];
      if (corner[0] == corner[1] && corner[0] == corner[cells + 1] && corner[0] == corner[cells + 2]) {
        sum += corner[0];
        continue;
      }
      double cell = 0.;
      for (int k = 0; k < samples; ++k) {
        const double down = k / goldenRatio;
        cell += shade(u - 0.5 + (j + (k + 0.5) / samples) / cells, v - 0.5 + (i + down - std::floor(down)) / cells);
      }
      sum += cell / samples;
    }
  }
  return sum / (cells * cells);
}

} // namespace simulator_test

#endif
