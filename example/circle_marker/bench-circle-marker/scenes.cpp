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
 * Images to measure detectors on: markers on plain and cluttered grounds, and images made to be hard.
 */

#include "scenes.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <opencv2/imgproc.hpp>

#include <visp3/circle_marker/vpCircleMarkerFamily.h>
#include <visp3/core/vpException.h>
#include <visp3/core/vpRotationMatrix.h>
#include <visp3/core/vpThetaUVector.h>
#include <visp3/core/vpTranslationVector.h>

namespace bench {
namespace {
using Random = std::mt19937_64;

double uniform(Random &random, double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

// A marker whose ring has an outer diameter in pixels, centred at a pixel, tilted about a random axis and spun.
vpHomogeneousMatrix drawPose(Random &random, const vpCameraParameters &camera, double diameter, double tilt, double u,
                             double v)
{
  const double depth = camera.get_px() * markerSize / diameter;
  const vpTranslationVector center(depth * (u - camera.get_u0()) / camera.get_px(),
                                   depth * (v - camera.get_v0()) / camera.get_py(), depth);
  const double azimuth = uniform(random, 0., 2. * M_PI);
  // The tilt is counted from the line of sight: about an axis across it and the optical axis, the marker is turned to
  // face the camera first.
  const double across = std::hypot(center[0], center[1]);
  const double sight = across > 0. ? std::atan2(across, depth) / across : 0.;
  const vpRotationMatrix facing(vpThetaUVector(-sight * center[1], sight * center[0], 0.));
  const vpRotationMatrix tilted(vpThetaUVector(tilt * std::cos(azimuth), tilt * std::sin(azimuth), 0.));
  const vpRotationMatrix spun(vpThetaUVector(0., 0., uniform(random, -M_PI, M_PI)));
  return vpHomogeneousMatrix(center, facing * tilted * spun);
}

// Any light that a camera may be used in: each fourth picture by a camera that is not linear.
vpScenePhotometry drawPhotometry(Random &random)
{
  vpScenePhotometry photometry;
  photometry.ink = uniform(random, 15., 60.);
  photometry.paper = photometry.ink + uniform(random, 60., 190.);
  photometry.blurSigma = uniform(random, 0.5, 1.2);
  photometry.noiseSigma = uniform(random, 0., 6.);
  photometry.gradientU = uniform(random, -0.4, 0.4);
  photometry.gradientV = uniform(random, -0.4, 0.4);
  const double gamma = uniform(random, 0.45, 2.2);
  photometry.gamma = random() % 4 == 0 ? gamma : 1.;
  return photometry;
}

vpImage<unsigned char> imageOf(const cv::Mat &pixels)
{
  vpImage<unsigned char> I(static_cast<unsigned int>(pixels.rows), static_cast<unsigned int>(pixels.cols));
  pixels.copyTo(cv::Mat(pixels.rows, pixels.cols, CV_8U, I.bitmap));
  return I;
}

void drawCircle(cv::Mat &pixels, double u, double v, double radius, int grey, int thickness)
{
  constexpr int shift = 4; // sixteenths of a pixel
  const auto fixed = [](double x) { return static_cast<int>(std::lround(16. * x)); };
  cv::circle(pixels, cv::Point(fixed(u), fixed(v)), fixed(radius), cv::Scalar(grey), thickness, cv::LINE_AA, shift);
}

cv::Mat checkerboard(int width, int height, int side)
{
  cv::Mat pixels(height, width, CV_8U);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      pixels.at<unsigned char>(y, x) = ((x / side + y / side) & 1) != 0 ? 30 : 220;
    }
  }
  return pixels;
}

// Rings inside rings, from the largest that the image holds to a few pixels.
cv::Mat nestedRings(int width, int height)
{
  constexpr double spacing = 5.; // pixels from black to black
  cv::Mat pixels(height, width, CV_8U, cv::Scalar(220));
  for (double radius = std::hypot(width, height) / 2.; radius > spacing; radius -= spacing) {
    drawCircle(pixels, 0.5 * width, 0.5 * height, radius, 30, 2);
  }
  return pixels;
}

// Targets of three nested rings side by side: thousands of ellipses, each of them dark inside.
cv::Mat smallTargets(int width, int height)
{
  constexpr int cell = 28; // pixels
  cv::Mat pixels(height, width, CV_8U, cv::Scalar(220));
  for (int y = cell / 2; y + cell / 2 <= height; y += cell) {
    for (int x = cell / 2; x + cell / 2 <= width; x += cell) {
      for (const double radius : {12., 8., 4.}) {
        drawCircle(pixels, x, y, radius, 30, 2);
      }
    }
  }
  return pixels;
}

// A page of small print, whose round letters are dark rings.
cv::Mat lettering(int width, int height, Random &random)
{
  constexpr int line = 20;      // pixels
  constexpr int letter = 13;    // pixels
  constexpr double scale = 0.6; // of OpenCV's font: letters of 14 pixels
  cv::Mat pixels(height, width, CV_8U, cv::Scalar(200));
  for (int y = line; y < height; y += line) {
    for (int x = letter / 2; x < width; x += letter) {
      const std::string text(1, static_cast<char>('a' + random() % 26));
      cv::putText(pixels, text, cv::Point(x, y), cv::FONT_HERSHEY_COMPLEX, scale, cv::Scalar(30), 1, cv::LINE_AA);
    }
  }
  return pixels;
}

// A page of large round letters, many of which may be a marker that something covers.
cv::Mat roundLetters(int width, int height, Random &random)
{
  constexpr int line = 52;   // pixels
  constexpr int letter = 40; // pixels
  constexpr int thickness = 5;
  constexpr double scale = 1.6; // of OpenCV's font: letters of 35 pixels
  const std::string letters = "OQ0869e@";
  cv::Mat pixels(height, width, CV_8U, cv::Scalar(220));
  for (int y = line; y < height; y += line) {
    for (int x = letter / 2; x < width; x += letter) {
      const std::string text(1, letters[random() % letters.size()]);
      cv::putText(pixels, text, cv::Point(x, y), cv::FONT_HERSHEY_COMPLEX, scale, cv::Scalar(30), thickness,
                  cv::LINE_AA);
    }
  }
  cv::GaussianBlur(pixels, pixels, cv::Size(), 0.7);
  return pixels;
}

// Circles of any size across one another.
cv::Mat crossingRings(int width, int height, Random &random)
{
  cv::Mat pixels(height, width, CV_8U, cv::Scalar(220));
  const int count = width * height / 800;
  for (int i = 0; i < count; ++i) {
    drawCircle(pixels, uniform(random, 0., width), uniform(random, 0., height), uniform(random, 6., 120.), 30, 2);
  }
  return pixels;
}

// Rings with as many sectors inside as no code has, black or white at random, far out of focus: each looks like a
// marker that has to be read through the blur, and none is one.
cv::Mat defocusedTracks(int width, int height, Random &random)
{
  constexpr int cell = 60;       // pixels
  constexpr double radius = 23.; // pixels
  constexpr int sectors = 19;
  constexpr int defocus = 7; // radius of a point's image, pixels: 15 % of the diameter
  cv::Mat pixels(height, width, CV_8U, cv::Scalar(220));
  for (int y = cell / 2; y + cell / 2 <= height; y += cell) {
    for (int x = cell / 2; x + cell / 2 <= width; x += cell) {
      drawCircle(pixels, x, y, radius, 30, cv::FILLED);
      drawCircle(pixels, x, y, 0.8 * radius, 220, cv::FILLED);
      for (int k = 0; k < sectors; ++k) {
        if (random() % 2 == 0) {
          const cv::Size track(static_cast<int>(0.68 * radius), static_cast<int>(0.68 * radius));
          cv::ellipse(pixels, cv::Point(x, y), track, 0., 360. * k / sectors, 360. * (k + 1) / sectors, cv::Scalar(30),
                      cv::FILLED);
        }
      }
      drawCircle(pixels, x, y, 0.4 * radius, 220, cv::FILLED);
    }
  }
  cv::Mat disc;
  cv::getStructuringElement(cv::MORPH_ELLIPSE, cv::Size(2 * defocus + 1, 2 * defocus + 1)).convertTo(disc, CV_32F);
  cv::filter2D(pixels, pixels, -1, disc / cv::sum(disc)[0]);
  return pixels;
}

cv::Mat noise(int width, int height, Random &random)
{
  cv::Mat pixels(height, width, CV_8U);
  std::uniform_int_distribution<int> grey(0, 255);
  std::generate(pixels.begin<unsigned char>(), pixels.end<unsigned char>(),
                [&]() { return static_cast<unsigned char>(grey(random)); });
  return pixels;
}

// Noise with the grain of a few pixels: every blob has a closed outline.
cv::Mat blobs(int width, int height, Random &random)
{
  cv::Mat pixels = noise(width, height, random);
  cv::GaussianBlur(pixels, pixels, cv::Size(), 3.);
  cv::normalize(pixels, pixels, 0, 255, cv::NORM_MINMAX);
  return pixels;
}
} // namespace

vpCameraParameters cameraOf(unsigned int width, unsigned int height)
{
  const double focal = 1.25 * width;
  return vpCameraParameters(focal, focal, 0.5 * (width - 1.), 0.5 * (height - 1.));
}

vpScenePhotometry anyPhotometry(std::uint64_t seed)
{
  Random random(seed);
  return drawPhotometry(random);
}

vpHomogeneousMatrix randomPose(std::uint64_t seed, const vpCameraParameters &camera, double diameter, double tilt,
                               double u, double v)
{
  Random random(seed);
  return drawPose(random, camera, diameter, tilt, u, v);
}

Scene makeScene(const SceneOptions &options)
{
  Random random(options.seed);
  Scene scene;
  scene.camera = cameraOf(options.width, options.height);
  vpMarkerSceneSimulator simulator(scene.camera, options.width, options.height);
  vpScenePhotometry photometry;
  photometry.noiseSigma = options.noise;
  double ground = 110.;
  if (options.anyLight) {
    photometry = drawPhotometry(random);
    ground = uniform(random, 60., 230.);
  }
  simulator.setPhotometry(photometry);
  if (options.clutter) {
    const double pixels = static_cast<double>(options.width) * options.height;
    const auto shapes = static_cast<unsigned int>(120. * pixels / (1280. * 960.));
    simulator.setBackground(vpSceneBackground::clutter(options.seed, shapes));
  }
  else {
    simulator.setBackground(vpSceneBackground::plain(ground));
  }
  // The grid with the squarest cells that has room for all.
  const double aspect = static_cast<double>(options.width) / options.height;
  const auto columns = static_cast<unsigned int>(std::ceil(std::sqrt(options.markers * aspect)));
  const unsigned int rows = (options.markers + columns - 1) / std::max(columns, 1U);
  const bool isCoded = vpCircleMarkerFamily::fromName(options.family).isCoded();
  const std::size_t ids = isCoded ? vpSimulatedMarker::codewords(options.family).size() : 1;
  for (unsigned int i = 0; i < options.markers; ++i) {
    const double cellWidth = static_cast<double>(options.width) / columns;
    const double cellHeight = static_cast<double>(options.height) / rows;
    // The sheet is 7/6 of the ring's diameter wide, its diagonal 1.65.
    const double largest = std::min(options.greatestDiameter, std::min(cellWidth, cellHeight) / 1.7);
    const double diameter = uniform(random, std::min(options.leastDiameter, largest), largest);
    const double reach = 0.83 * diameter;
    const double u = (i % columns) * cellWidth + uniform(random, reach, std::max(cellWidth - reach, reach));
    const double v = (i / columns) * cellHeight + uniform(random, reach, std::max(cellHeight - reach, reach));
    const double tilt = uniform(random, 0., options.mostTilt);
    const int id = static_cast<int>(random() % ids);
    vpSimulatedMarker marker = vpSimulatedMarker::circle(options.family, isCoded ? id : -1, markerSize);
    simulator.addMarker(marker.setPose(drawPose(random, scene.camera, diameter, tilt, u, v)));
  }
  scene.truth = simulator.render(scene.image, options.seed);
  return scene;
}

std::vector<std::string> hardImages()
{
  return {"checkerboard8",  "checkerboard2",    "noise",    "blobs", "nested-rings", "small-targets",
          "crossing-rings", "defocused-tracks", "lettering"};
}

std::vector<std::string> timedImages()
{
  std::vector<std::string> names = hardImages();
  names.emplace_back("round-letters");
  return names;
}

vpImage<unsigned char> makeHardImage(const std::string &name, unsigned int width, unsigned int height,
                                     std::uint64_t seed)
{
  Random random(seed);
  const int w = static_cast<int>(width);
  const int h = static_cast<int>(height);
  if (name == "checkerboard8") {
    return imageOf(checkerboard(w, h, 8));
  }
  if (name == "checkerboard2") {
    return imageOf(checkerboard(w, h, 2));
  }
  if (name == "noise") {
    return imageOf(noise(w, h, random));
  }
  if (name == "blobs") {
    return imageOf(blobs(w, h, random));
  }
  if (name == "nested-rings") {
    return imageOf(nestedRings(w, h));
  }
  if (name == "small-targets") {
    return imageOf(smallTargets(w, h));
  }
  if (name == "crossing-rings") {
    return imageOf(crossingRings(w, h, random));
  }
  if (name == "defocused-tracks") {
    return imageOf(defocusedTracks(w, h, random));
  }
  if (name == "lettering") {
    return imageOf(lettering(w, h, random));
  }
  if (name == "round-letters") {
    return imageOf(roundLetters(w, h, random));
  }
  throw vpException(vpException::badValue, "there is no hard image \"%s\"", name.c_str());
}
} // namespace bench
