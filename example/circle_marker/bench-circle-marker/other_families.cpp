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
 * Markers of one family that are found as another's.
 */

#include "tables.h"

#include <array>
#include <iomanip>
#include <vector>

#include <visp3/circle_marker/vpDetectorCircleMarker.h>

#include "rate_bound.h"
#include "scenes.h"

namespace bench {
namespace {
// A codeword of bch31r is one of bch31, too: these two are not told apart by what is printed.
struct Pair
{
  const char *printed;
  const char *sought;
};
constexpr std::array<Pair, 4> pairs = {
    {{"golay23", "bch31"}, {"golay23", "bch31r"}, {"bch31", "golay23"}, {"bch31r", "golay23"}}};
} // namespace

void tellOtherFamilies(std::ostream &out, unsigned int frames, std::uint64_t seed)
{
  out << "| printed | sought | markers | found | at most, at 95 % |\n|---|---|---|---|---|\n";
  for (const Pair &pair : pairs) {
    vpDetectorCircleMarker detector(vpCircleMarkerFamily::fromName(pair.sought));
    unsigned int markers = 0;
    unsigned int found = 0;
    for (unsigned int frame = 0; frame < frames; ++frame) {
      SceneOptions options;
      options.family = pair.printed;
      options.markers = 20;
      options.leastDiameter = 30.;
      options.anyLight = frame % 2 == 1;
      options.seed = 90000 + firstOfSeed(seed) + frame;
      const Scene scene = makeScene(options);
      std::vector<vpHomogeneousMatrix> poses;
      detector.detect(scene.image, markerSize, scene.camera, poses);
      markers += static_cast<unsigned int>(scene.truth.size());
      found += static_cast<unsigned int>(detector.getNbObjects());
      for (const vpCircleMarkerDetection &detection : detector.getDetections()) {
        out << "Frame " << frame << ": " << pair.printed << " read as " << pair.sought << " " << detection.id << " at "
            << detection.center << ", semi-minor axis " << detection.ellipse.b << "\n";
      }
    }
    out << "| " << pair.printed << " | " << pair.sought << " | " << markers << " | " << found << " | "
        << std::scientific << std::setprecision(1) << upperBound(found, markers) << std::defaultfloat
        << std::setprecision(6) << " |" << std::endl;
  }
}
} // namespace bench
