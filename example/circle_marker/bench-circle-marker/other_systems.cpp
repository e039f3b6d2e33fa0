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
 * Images full of the signs of other systems.
 */

#include "other_systems.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <random>

#include <opencv2/imgproc.hpp>
#if defined(CIRCLE_MARKER_HAVE_ARUCO)
#include <opencv2/aruco.hpp>
#endif

#include <visp3/core/vpException.h>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace bench {
namespace {
using Random = std::mt19937_64;

constexpr int side = 240;        // of the picture of a sign, pixels
constexpr int half = side / 2;   // its middle
constexpr int supersampling = 3; // in each direction

double uniform(Random &random, double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

int whole(Random &random, int least, int most)
{
  return std::uniform_int_distribution<int>(least, most)(random);
}

const cv::Scalar black(0);
const cv::Scalar white(255);

cv::Mat paper()
{
  return cv::Mat(side, side, CV_8U, white);
}

void fillCircle(cv::Mat &sign, double u, double v, double radius, const cv::Scalar &grey)
{
  constexpr int shift = 4; // sixteenths of a pixel
  const auto fixed = [](double x) { return static_cast<int>(std::lround(16. * x)); };
  cv::circle(sign, cv::Point(fixed(u), fixed(v)), fixed(radius), grey, cv::FILLED, cv::LINE_AA, shift);
}

// Black and white in turn, from the outermost radius inward.
cv::Mat rings(const std::vector<double> &radii)
{
  cv::Mat sign = paper();
  for (std::size_t i = 0; i < radii.size(); ++i) {
    fillCircle(sign, half, half, radii[i], i % 2 == 0 ? black : white);
  }
  return sign;
}

// Three or four crowns, whose widths are the code.
cv::Mat concentric(Random &random)
{
  const int crowns = whole(random, 2, 4);
  std::vector<double> radii = {0.9 * half};
  for (int i = 1; i < 2 * crowns; ++i) {
    radii.push_back(radii.back() - half * uniform(random, 0.06, 0.75 / (2 * crowns)));
  }
  return rings(radii);
}

cv::Mat discWithHole(Random &random)
{
  const double outer = 0.9 * half;
  return rings({outer, outer * uniform(random, 0.3, 0.85)});
}

// The code in teeth on the inner edge: as many half sectors black as white.
cv::Mat toothed(Random &random)
{
  const double outer = 0.9 * half;
  const double inner = outer * uniform(random, 0.45, 0.65);
  const double teeth = inner * uniform(random, 0.7, 0.85);
  cv::Mat sign = rings({outer, inner});
  const int bits = whole(random, 4, 16);
  for (int i = 0; i < bits; ++i) {
    const double begin = 360. * (i + (random() % 2 == 0 ? 0. : 0.5)) / bits;
    cv::ellipse(sign, cv::Point(half, half), cv::Size(static_cast<int>(inner) + 1, static_cast<int>(inner) + 1), 0.,
                begin, begin + 180. / bits, black, cv::FILLED, cv::LINE_AA);
  }
  fillCircle(sign, half, half, teeth, white);
  return sign;
}

// Dots on circles around the middle.
cv::Mat dotRings(Random &random)
{
  cv::Mat sign = paper();
  const int layers = whole(random, 1, 3);
  const int places = whole(random, 12, 43);
  for (int layer = 0; layer < layers; ++layer) {
    const double radius = half * (0.85 - 0.17 * layer);
    const double dot = std::min(0.075 * half, 0.35 * 2. * M_PI * radius / places);
    for (int i = 0; i < places; ++i) {
      if (random() % 3 != 0) {
        const double angle = 2. * M_PI * i / places;
        fillCircle(sign, half + radius * std::cos(angle), half + radius * std::sin(angle), dot, black);
      }
    }
  }
  return sign;
}

cv::Mat dotGrid(Random &random)
{
  cv::Mat sign = paper();
  const int count = whole(random, 3, 8);
  const double pitch = static_cast<double>(side) / count;
  const double radius = pitch * uniform(random, 0.15, 0.45);
  for (int i = 0; i < count * count; ++i) {
    fillCircle(sign, (i % count + 0.5) * pitch, (i / count + 0.5) * pitch, radius, black);
  }
  return sign;
}

void fillCells(cv::Mat &sign, int cells, const std::function<bool(int, int)> &isBlack)
{
  const double size = static_cast<double>(side) / (cells + 2); // a margin of one cell
  for (int y = 0; y < cells; ++y) {
    for (int x = 0; x < cells; ++x) {
      if (isBlack(x, y)) {
        cv::rectangle(sign, cv::Point2d(std::round((x + 1) * size), std::round((y + 1) * size)),
                      cv::Point2d(std::round((x + 2) * size) - 1., std::round((y + 2) * size) - 1.), black, cv::FILLED);
      }
    }
  }
}

cv::Mat checkerboard(Random &random)
{
  cv::Mat sign = paper();
  fillCells(sign, whole(random, 3, 12), [](int x, int y) { return (x + y) % 2 == 0; });
  return sign;
}

// Three finders in the corners, the rest at random.
cv::Mat squareCode(Random &random)
{
  cv::Mat sign = paper();
  const int cells = 4 * whole(random, 1, 4) + 17;
  const auto finder = [](int x, int y) {
    const int far = std::max(std::abs(x - 3), std::abs(y - 3));
    return far <= 1 || far == 3;
  };
  fillCells(sign, cells, [&](int x, int y) {
    const bool left = x < 8;
    const bool top = y < 8;
    if ((left && top) || (left && y >= cells - 8) || (x >= cells - 8 && top)) {
      const int fx = left ? x : x - cells + 7;
      const int fy = top ? y : y - cells + 7;
      return fx >= 0 && fy >= 0 && fx < 7 && fy < 7 && finder(fx, fy);
    }
    return random() % 2 == 0;
  });
  return sign;
}

cv::Mat letters(Random &random)
{
  const std::string round = "OQD0689BGCPRabdegopq@%&";
  cv::Mat sign = paper();
  const double scale = uniform(random, 0.8, 5.);
  const int thickness = 1 + whole(random, 1, 5) * static_cast<int>(scale + 0.5);
  const int line = static_cast<int>(32. * scale);
  for (int y = line; y < side + line / 2; y += line + 4) {
    std::string text;
    for (int i = 0; i < 12; ++i) {
      text += round[random() % round.size()];
    }
    const int font = random() % 2 == 0 ? cv::FONT_HERSHEY_SIMPLEX : cv::FONT_HERSHEY_COMPLEX;
    cv::putText(sign, text, cv::Point(2, y), font, scale, black, thickness, cv::LINE_AA);
  }
  return sign;
}

#if defined(CIRCLE_MARKER_HAVE_ARUCO)
cv::Mat squareTag(Random &random, const std::vector<int> &dictionaries)
{
  const auto dictionary = cv::aruco::getPredefinedDictionary(dictionaries[random() % dictionaries.size()]);
  cv::Mat tag;
  constexpr int margin = side / 10;
  cv::aruco::drawMarker(dictionary, whole(random, 0, dictionary->bytesList.rows - 1), side - 2 * margin, tag);
  cv::Mat sign = paper();
  tag.copyTo(sign(cv::Rect(margin, margin, tag.cols, tag.rows)));
  return sign;
}
#endif

using DrawSign = std::function<cv::Mat(Random &)>;

const std::map<std::string, DrawSign> &signs()
{
  static const std::map<std::string, DrawSign> all = {
#if defined(CIRCLE_MARKER_HAVE_ARUCO)
    {"apriltag",
     [](Random &random) {
       return squareTag(random, {cv::aruco::DICT_APRILTAG_16h5, cv::aruco::DICT_APRILTAG_25h9,
                                 cv::aruco::DICT_APRILTAG_36h10, cv::aruco::DICT_APRILTAG_36h11});
     }},
    {"aruco",
     [](Random &random) {
       return squareTag(random, {cv::aruco::DICT_4X4_50, cv::aruco::DICT_5X5_100, cv::aruco::DICT_6X6_250,
                                 cv::aruco::DICT_7X7_1000, cv::aruco::DICT_ARUCO_ORIGINAL});
     }},
#endif
    {"checkerboards", checkerboard},
    {"concentric-rings", concentric},
    {"discs-with-hole", discWithHole},
    {"toothed-rings", toothed},
    {"rings-of-dots", dotRings},
    {"grids-of-dots", dotGrid},
    {"square-codes", squareCode},
    {"letters", letters}
  };
  return all;
}

// The corners of a sign somewhere in the image, as a camera sees a tilted square; pixels of the large picture.
std::vector<cv::Point2f> randomCorners(Random &random, double width, double height)
{
  const double size = supersampling * std::exp(uniform(random, std::log(18.), std::log(220.))); // of its side
  const double tilt = uniform(random, 0., 1.2);
  const double azimuth = uniform(random, 0., 2. * M_PI);
  const double turn = uniform(random, 0., 2. * M_PI);
  const double focal = uniform(random, 2., 8.); // distance in units of its side: how strong the perspective is
  const double u = uniform(random, 0.02, 0.98) * width;
  const double v = uniform(random, 0.02, 0.98) * height;
  std::vector<cv::Point2f> corners;
  for (const auto &[x, y] : {std::pair(-0.5, -0.5), std::pair(0.5, -0.5), std::pair(0.5, 0.5), std::pair(-0.5, 0.5)}) {
    const double turnedX = std::cos(turn) * x - std::sin(turn) * y;
    const double turnedY = std::sin(turn) * x + std::cos(turn) * y;
    const double along = turnedX * std::cos(tilt);
    const double depth = 1. + turnedX * std::sin(tilt) / focal;
    const double px = (std::cos(azimuth) * along - std::sin(azimuth) * turnedY) / depth;
    const double py = (std::sin(azimuth) * along + std::cos(azimuth) * turnedY) / depth;
    corners.emplace_back(static_cast<float>(u + size * px), static_cast<float>(v + size * py));
  }
  return corners;
}

// Puts a sign into the large picture, with its own white and black.
void place(Random &random, const cv::Mat &sign, cv::Mat &large)
{
  const double ink = uniform(random, 10., 80.);
  const double paperGrey = uniform(random, ink + 50., 240.);
  cv::Mat printed;
  sign.convertTo(printed, CV_8U, (paperGrey - ink) / 255., ink);
  const std::vector<cv::Point2f> from = {{0.F, 0.F}, {side, 0.F}, {side, side}, {0.F, side}};
  const std::vector<cv::Point2f> to = randomCorners(random, large.cols, large.rows);
  const cv::Rect box = cv::boundingRect(to) & cv::Rect(0, 0, large.cols, large.rows);
  if (box.empty()) {
    return;
  }
  std::vector<cv::Point2f> inBox;
  for (const cv::Point2f &corner : to) {
    inBox.emplace_back(corner.x - static_cast<float>(box.x), corner.y - static_cast<float>(box.y));
  }
  // What is small in the image is drawn from a smaller picture, or it would be sampled too seldom.
  const double scale = std::sqrt(cv::contourArea(to)) / side;
  if (scale < 0.7) {
    cv::GaussianBlur(printed, printed, cv::Size(), 0.35 / scale);
  }
  const cv::Mat map = cv::getPerspectiveTransform(from, inBox);
  cv::Mat seen, mask;
  cv::warpPerspective(printed, seen, map, box.size(), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  cv::warpPerspective(cv::Mat(side, side, CV_8U, white), mask, map, box.size(), cv::INTER_NEAREST);
  seen.copyTo(large(box), mask);
}
} // namespace

std::vector<std::string> otherSystems()
{
  std::vector<std::string> names;
  for (const auto &[name, draw] : signs()) {
    names.push_back(name);
  }
  return names;
}

vpImage<unsigned char> otherSystemsImage(const std::string &system, unsigned int width, unsigned int height,
                                         std::uint64_t seed)
{
  const auto known = signs().find(system);
  if (known == signs().end()) {
    throw vpException(vpException::badValue, "there is no system \"%s\"", system.c_str());
  }
  Random random(seed);
  cv::Mat large(static_cast<int>(supersampling * height), static_cast<int>(supersampling * width), CV_8U,
                cv::Scalar(uniform(random, 20., 230.)));
  constexpr int count = 12;
  for (int i = 0; i < count; ++i) {
    place(random, known->second(random), large);
  }
  vpImage<unsigned char> I(height, width);
  cv::Mat pixels(static_cast<int>(height), static_cast<int>(width), CV_8U, I.bitmap);
  cv::resize(large, pixels, pixels.size(), 0., 0., cv::INTER_AREA);
  cv::GaussianBlur(pixels, pixels, cv::Size(), uniform(random, 0.4, 1.5));
  std::normal_distribution<double> normal(0., uniform(random, 0., 6.));
  for (unsigned int i = 0; i < I.getSize(); ++i) {
    I.bitmap[i] = cv::saturate_cast<unsigned char>(I.bitmap[i] + normal(random));
  }
  return I;
}
} // namespace bench
