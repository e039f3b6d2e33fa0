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
 * Markers found in images that have none.
 */

#include "tables.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <visp3/circle_marker/vpDetectorCircleMarker.h>
#include <visp3/core/vpException.h>
#include <visp3/core/vpMath.h>
#include <visp3/io/vpImageIo.h>

#include "other_systems.h"
#include "rate_bound.h"
#include "scenes.h"

namespace bench {
namespace {
constexpr unsigned int width = 640;  // pixels
constexpr unsigned int height = 480; // pixels

struct Count
{
  unsigned int images = 0;
  unsigned int coded = 0;
  unsigned int rings = 0;
};

// Of the hard images these are drawn, always the same; each time they are seen from somewhere else, or a thousand looks
// at one image would count as a thousand images.
bool isDrawn(const std::string &hard)
{
  return hard != "noise" && hard != "blobs" && hard != "crossing-rings";
}

vpImage<unsigned char> seenFromSomewhere(const vpImage<unsigned char> &drawing, std::uint64_t seed)
{
  std::mt19937_64 random(seed);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  // The corners of what is seen of the drawing: turned, from nearer, and somewhat askew.
  const double turn = uniform(0., 2. * M_PI);
  const double share = uniform(0.3, 0.55);
  std::vector<cv::Point2f> from;
  for (const auto &[x, y] : {std::pair(-1., -1.), std::pair(1., -1.), std::pair(1., 1.), std::pair(-1., 1.)}) {
    const double u = share * width * x * uniform(0.7, 1.);
    const double v = share * height * y * uniform(0.7, 1.);
    from.emplace_back(static_cast<float>(0.5 * drawing.getWidth() + std::cos(turn) * u - std::sin(turn) * v),
                      static_cast<float>(0.5 * drawing.getHeight() + std::sin(turn) * u + std::cos(turn) * v));
  }
  const std::vector<cv::Point2f> to = {{0.F, 0.F},
                                       {static_cast<float>(width), 0.F},
                                       {static_cast<float>(width), static_cast<float>(height)},
                                       {0.F, static_cast<float>(height)}};
  const cv::Mat drawn(static_cast<int>(drawing.getHeight()), static_cast<int>(drawing.getWidth()), CV_8U,
                      drawing.bitmap);
  vpImage<unsigned char> I(height, width);
  cv::Mat pixels(static_cast<int>(height), static_cast<int>(width), CV_8U, I.bitmap);
  cv::warpPerspective(drawn, pixels, cv::getPerspectiveTransform(from, to), pixels.size(), cv::INTER_LINEAR,
                      cv::BORDER_REFLECT);
  cv::GaussianBlur(pixels, pixels, cv::Size(), uniform(0.4, 1.5));
  std::normal_distribution<double> normal(0., uniform(0., 6.));
  for (unsigned int i = 0; i < I.getSize(); ++i) {
    I.bitmap[i] = cv::saturate_cast<unsigned char>(I.bitmap[i] + normal(random));
  }
  return I;
}

// Half of the images are clutter; a quarter has other systems' signs, a quarter is hard; in turn. The last kind of hard
// ones takes seconds for each, so that it is one image in so many.
std::string kindOf(unsigned int index)
{
  constexpr unsigned int seldom = 400;
  static const std::vector<std::string> systems = otherSystems();
  static const std::vector<std::string> hard = hardImages();
  if (index % 4 == 2) {
    return systems[(index / 4) % systems.size()];
  }
  if (index % 4 == 3) {
    return index % seldom == seldom - 1 ? hard.back() : hard[(index / 4) % (hard.size() - 1)];
  }
  return "clutter";
}

vpImage<unsigned char> imageWithoutMarkers(const std::string &kind, unsigned int index, std::uint64_t seed)
{
  const std::uint64_t number = seed + index;
  if (index % 4 == 2) {
    return otherSystemsImage(kind, width, height, 70000 + number);
  }
  if (index % 4 == 3) {
    return isDrawn(kind) ? seenFromSomewhere(makeHardImage(kind, 2 * width, 2 * height, number), number)
                         : makeHardImage(kind, width, height, number);
  }
  SceneOptions options;
  options.width = width;
  options.height = height;
  options.markers = 0;
  options.clutter = true;
  options.noise = 2. * (index % 7); // 0 to 12 grey levels
  options.seed = 50000 + number;
  return makeScene(options).image;
}

void write(std::ostream &out, const std::map<std::string, Count> &counts)
{
  out << "| images | number | coded markers found | upper bound per image at 95 % | rings found |\n"
      << "|---|---|---|---|---|\n";
  for (const auto &[kind, count] : counts) {
    out << "| " << kind << " | " << count.images << " | " << count.coded << " | " << std::scientific
        << std::setprecision(1) << upperBound(count.coded, count.images) << " | " << count.rings << " |\n";
  }
  out << std::flush;
}

/*! The detectors at their default settings: for all codes, and for rings without one. */
struct Detectors
{
  vpDetectorCircleMarker coded;
  vpDetectorCircleMarker ring{vpCircleMarkerFamily::RING};

  Detectors()
  {
    coded.setFamilies({vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31R, vpCircleMarkerFamily::BCH31});
  }

  void look(const vpImage<unsigned char> &I)
  {
    coded.detect(I);
    ring.detect(I);
  }

  void addTo(Count &count) const
  {
    ++count.images;
    count.coded += static_cast<unsigned int>(coded.getNbObjects());
    count.rings += static_cast<unsigned int>(ring.getNbObjects());
  }
};

void writeOverlay(const vpImage<unsigned char> &I, const std::vector<vpCircleMarkerDetection> &found,
                  const std::string &file)
{
  cv::Mat grey(static_cast<int>(I.getHeight()), static_cast<int>(I.getWidth()), CV_8U, I.bitmap);
  cv::Mat picture;
  cv::cvtColor(grey, picture, cv::COLOR_GRAY2BGR);
  for (const vpCircleMarkerDetection &marker : found) {
    const vpImageEllipse &ellipse = marker.ellipse;
    cv::ellipse(picture,
                cv::RotatedRect(cv::Point2d(ellipse.center.get_u(), ellipse.center.get_v()),
                                cv::Size2d(2. * ellipse.a, 2. * ellipse.b),
                                static_cast<float>(vpMath::deg(ellipse.angle))),
                cv::Scalar(0, 0, 255), 1, cv::LINE_AA);
  }
  cv::imwrite(file, picture);
}

// A line for each marker found, to be looked at.
void tellFound(std::ostream &out, const std::string &picture, const std::vector<vpCircleMarkerDetection> &detections)
{
  for (const vpCircleMarkerDetection &found : detections) {
    out << picture << ": " << found.family.getName() << " " << found.id << " at " << found.ellipse.center
        << ", semi-axes " << found.ellipse.a << ", " << found.ellipse.b << "\n";
  }
}
} // namespace

void tellPhantoms(std::ostream &out, unsigned int images, std::uint64_t seed, const std::string &only,
                  const std::string &overlays)
{
  Detectors detectors;
  std::map<std::string, Count> counts;
  for (unsigned int i = 0; i < images; ++i) {
    const std::string kind = kindOf(i);
    if (kind.find(only) == std::string::npos) {
      continue;
    }
    const vpImage<unsigned char> image = imageWithoutMarkers(kind, i, firstOfSeed(seed));
    detectors.look(image);
    for (Count *count : {&counts[kind], &counts["all"]}) {
      detectors.addTo(*count);
    }
    const std::vector<vpCircleMarkerDetection> &found = detectors.coded.getDetections();
    tellFound(out, kind + " " + std::to_string(i), found);
    if (!overlays.empty() && !found.empty()) {
      writeOverlay(image, found, overlays + "/" + kind + "-" + std::to_string(i) + ".png");
      cv::imwrite(overlays + "/" + kind + "-" + std::to_string(i) + "-plain.png",
                  cv::Mat(static_cast<int>(height), static_cast<int>(width), CV_8U, image.bitmap));
    }
  }
  if (counts.empty()) {
    throw std::invalid_argument("of " + std::to_string(images) + " images none is of a kind with \"" + only +
                                "\" in its name");
  }
  write(out, counts);
}

void tellPhotographs(std::ostream &out, const std::string &folder, const std::string &overlays)
{
  const std::vector<std::string> kinds = {".pgm", ".ppm", ".png", ".jpg", ".jpeg"};
  Detectors detectors;
  std::map<std::string, Count> counts;
  std::vector<std::filesystem::path> pictures;
  for (const auto &entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (std::find(kinds.begin(), kinds.end(), entry.path().extension().string()) != kinds.end()) {
      pictures.push_back(entry.path());
    }
  }
  std::sort(pictures.begin(), pictures.end());
  for (const std::filesystem::path &picture : pictures) {
    vpImage<unsigned char> I;
    try {
      vpImageIo::read(I, picture.string());
      detectors.look(I);
    }
    catch (const vpException &e) { // no picture that ViSP reads, or one of a few pixels
      out << picture.string() << " is left out: " << e.what() << "\n";
      continue;
    }
    detectors.addTo(counts["photographs"]);
    for (const vpDetectorCircleMarker *detector : {&detectors.coded, &detectors.ring}) {
      tellFound(out, picture.string(), detector->getDetections());
    }
    if (!overlays.empty() && detectors.ring.getNbObjects() > 0) {
      writeOverlay(I, detectors.ring.getDetections(),
                   overlays + "/" + std::to_string(counts["photographs"].images) + ".png");
    }
  }
  write(out, counts);
}
} // namespace bench
