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
#include <string>
#include <vector>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <visp3/circle_marker/vpDetectorCircleMarker.h>
#include <visp3/core/vpException.h>
#include <visp3/core/vpMath.h>
#include <visp3/io/vpImageIo.h>

#include "other_systems.h"
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

// Rate p at which so many events or fewer in n trials have a chance of 5 %: sum_k C(n,k) p^k (1-p)^(n-k) = 0.05.
double upperBound(unsigned int events, unsigned int trials)
{
  double low = 0.;
  double high = 1.;
  for (int i = 0; i < 60; ++i) {
    const double p = 0.5 * (low + high);
    double chance = 0.;
    double term = trials * std::log1p(-p); // logarithm of the binomial term
    for (unsigned int k = 0; k <= events && k <= trials; ++k) {
      chance += std::exp(term);
      term += std::log((trials - k) / (k + 1.)) + std::log(p / (1. - p));
    }
    (chance > 0.05 ? low : high) = p;
  }
  return high;
}

std::pair<std::string, vpImage<unsigned char>> imageWithoutMarkers(unsigned int index)
{
  const std::vector<std::string> hard = hardImages();
  // Half of the images are clutter, with noise from 0 to 12 grey levels; a quarter has other systems' signs, a quarter
  // is hard; in turn.
  if (index % 4 == 2) {
    static const std::vector<std::string> systems = otherSystems();
    const std::string &name = systems[(index / 4) % systems.size()];
    return {name, otherSystemsImage(name, width, height, 70000 + index)};
  }
  if (index % 4 != 3) {
    SceneOptions options;
    options.width = width;
    options.height = height;
    options.markers = 0;
    options.clutter = true;
    options.noise = 2. * (index % 7);
    options.seed = 50000 + index;
    return {"clutter", makeScene(options).image};
  }
  const std::string &name = hard[(index / 4) % hard.size()];
  return {name, makeHardImage(name, width, height, index)};
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
} // namespace

void tellPhantoms(std::ostream &out, unsigned int images)
{
  Detectors detectors;
  std::map<std::string, Count> counts;
  for (unsigned int i = 0; i < images; ++i) {
    const auto [kind, image] = imageWithoutMarkers(i);
    detectors.look(image);
    for (Count *count : {&counts[kind], &counts["all"]}) {
      detectors.addTo(*count);
    }
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
    }
    catch (const vpException &) {
      continue; // no picture that ViSP reads
    }
    detectors.look(I);
    detectors.addTo(counts["photographs"]);
    for (const vpDetectorCircleMarker *detector : {&detectors.coded, &detectors.ring}) {
      for (const vpCircleMarkerDetection &found : detector->getDetections()) {
        out << picture.string() << ": " << found.family.getName() << " " << found.id << " at " << found.ellipse.center
            << ", semi-axes " << found.ellipse.a << ", " << found.ellipse.b << "\n";
      }
    }
    if (!overlays.empty() && detectors.ring.getNbObjects() > 0) {
      writeOverlay(I, detectors.ring.getDetections(),
                   overlays + "/" + std::to_string(counts["photographs"].images) + ".png");
    }
  }
  write(out, counts);
}
} // namespace bench
