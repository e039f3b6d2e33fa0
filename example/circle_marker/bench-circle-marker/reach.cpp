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
 * How many markers are found and rightly read, by their size in the image.
 */

#include "tables.h"

#include <array>
#include <cmath>
#include <iomanip>

#include <visp3/circle_marker/vpDetectorCircleMarker.h>
#include <visp3/io/vpImageIo.h>

#include "rate_bound.h"
#include "scenes.h"

namespace bench {
namespace {
// Minor axes of the ring's image, pixels, from which the lines of the table begin.
constexpr std::array<double, 7> bounds = {0., 8., 10., 13., 17., 25., 40.};

// What lies around the markers, and their outer diameters, pixels. In any light the ground is clutter every other
// frame.
struct Ground
{
  const char *name;
  bool clutter;
  bool anyLight;
  double leastDiameter;
  double greatestDiameter;
};
constexpr std::array<Ground, 3> grounds = {
    {{"plain", false, false, 17., 60.}, {"clutter", true, false, 17., 60.}, {"any-light", false, true, 10., 45.}}};

struct Line
{
  unsigned int markers = 0;
  unsigned int found = 0;
  unsigned int wrong = 0;
};

// A detection is of a marker if their centres agree to this share of the minor axis.
constexpr double near = 0.25;

std::size_t lineOf(double minorAxis)
{
  std::size_t line = 0;
  while (line + 1 < bounds.size() && minorAxis >= bounds[line + 1]) {
    ++line;
  }
  return line;
}
} // namespace

void tellReach(std::ostream &out, const std::string &family, unsigned int frames, std::uint64_t seed,
               const std::string &overlays)
{
  vpDetectorCircleMarker detector(vpCircleMarkerFamily::fromName(family));
  out << "| ground | minor axis from, pixels | markers | found and rightly read | wrong id | at most, at 95 % |\n"
      << "|---|---|---|---|---|---|\n";
  unsigned int phantoms = 0;
  for (const Ground &ground : grounds) {
    std::array<Line, bounds.size()> lines;
    Line all;
    for (unsigned int frame = 0; frame < (frames + 1) / 2; ++frame) {
      SceneOptions options;
      options.family = family;
      options.markers = 20;
      options.leastDiameter = ground.leastDiameter;
      options.greatestDiameter = ground.greatestDiameter;
      options.mostTilt = 75. * M_PI / 180.;
      options.clutter = ground.clutter || (ground.anyLight && frame % 2 == 1);
      options.anyLight = ground.anyLight;
      options.seed = 1000 + firstOfSeed(seed) + frame;
      const Scene scene = makeScene(options);
      std::vector<vpHomogeneousMatrix> poses;
      detector.detect(scene.image, markerSize, scene.camera, poses);
      std::size_t matched = 0;
      bool isWrong = false;
      for (const vpMarkerTruth &truth : scene.truth) {
        const double minorAxis = 2. * truth.ellipse->semiAxisB;
        Line &line = lines[lineOf(minorAxis)];
        ++line.markers;
        ++all.markers;
        for (const vpCircleMarkerDetection &detection : detector.getDetections()) {
          if (vpImagePoint::distance(detection.center, truth.center) < near * minorAxis) {
            ++matched;
            const bool right = detection.id == truth.id;
            (right ? line.found : line.wrong) += 1;
            (right ? all.found : all.wrong) += 1;
            isWrong = isWrong || !right;
            if (!right) {
              out << "Frame " << frame << ": " << family << " " << truth.id << " read as " << detection.id << " at "
                  << detection.center << ", minor axis " << minorAxis << "\n";
            }
          }
        }
      }
      phantoms += static_cast<unsigned int>(detector.getDetections().size() - matched);
      isWrong = isWrong || matched < detector.getDetections().size();
      if (isWrong && !overlays.empty()) {
        vpImageIo::write(scene.image, overlays + "/" + ground.name + "-" + std::to_string(frame) + ".png");
      }
    }
    const auto write = [&](const std::string &from, const Line &line) {
      out << "| " << ground.name << " | " << from << " | " << line.markers << " | " << std::fixed
          << std::setprecision(2) << 100. * line.found / std::max(line.markers, 1U) << " % | " << line.wrong << " | "
          << std::scientific << std::setprecision(1) << upperBound(line.wrong, line.markers) << " |\n";
    };
    for (std::size_t i = 0; i < bounds.size(); ++i) {
      write(std::to_string(static_cast<int>(bounds[i])), lines[i]);
    }
    write("all", all);
  }
  out << "Markers found where there is none: " << phantoms << std::endl;
}
} // namespace bench
