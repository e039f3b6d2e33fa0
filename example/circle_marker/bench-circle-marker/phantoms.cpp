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

#include <cmath>
#include <iomanip>
#include <map>
#include <string>

#include <visp3/circle_marker/vpDetectorCircleMarker.h>

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
  // Three of four images are clutter, with noise from 0 to 12 grey levels; the others take turns.
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
} // namespace

void tellPhantoms(std::ostream &out, unsigned int images)
{
  vpDetectorCircleMarker coded;
  coded.setFamilies({vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31R, vpCircleMarkerFamily::BCH31});
  vpDetectorCircleMarker ring(vpCircleMarkerFamily::RING);
  std::map<std::string, Count> counts;
  for (unsigned int i = 0; i < images; ++i) {
    const auto [kind, image] = imageWithoutMarkers(i);
    coded.detect(image);
    ring.detect(image);
    for (Count *count : {&counts[kind], &counts["all"]}) {
      ++count->images;
      count->coded += static_cast<unsigned int>(coded.getNbObjects());
      count->rings += static_cast<unsigned int>(ring.getNbObjects());
    }
  }
  out << "| images | number | coded markers found | upper bound per image at 95 % | rings found |\n"
      << "|---|---|---|---|---|\n";
  for (const auto &[kind, count] : counts) {
    out << "| " << kind << " | " << count.images << " | " << count.coded << " | " << std::scientific
        << std::setprecision(1) << upperBound(count.coded, count.images) << " | " << count.rings << " |\n";
  }
  out << std::flush;
}
} // namespace bench
