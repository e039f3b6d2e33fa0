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
 * Table of the markers found and rightly read where they are covered or the picture is bad.
 */

#include "tables.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <stdexcept>

#include <visp3/circle_marker/vpDetectorCircleMarker.h>
#include <visp3/io/vpImageIo.h>

#include "common/pose_distance.h"

namespace bench {
namespace {
// A detection is of the marker if their centres agree to this share of the major semi-axis.
constexpr double near = 0.25;
// What the visible share may be off.
constexpr double visibleSlack = 0.1;

// Cosine of the angle between the normals of two poses.
double cosineBetweenNormals(const vpHomogeneousMatrix &one, const vpHomogeneousMatrix &other)
{
  return one[0][2] * other[0][2] + one[1][2] * other[1][2] + one[2][2] * other[2][2];
}

// Whether the pose that was told to be the less likely one is the true one.
bool isMirrored(const vpHomogeneousMatrix &truth, const vpCircleMarkerDetection &detection)
{
  return detection.cost2 < HUGE_VAL &&
         cosineBetweenNormals(truth, detection.cMo2) > cosineBetweenNormals(truth, detection.cMo);
}

struct Line
{
  unsigned int frames = 0;
  unsigned int found = 0;
  unsigned int wrong = 0;        // read as another marker, or where there is none
  unsigned int misjudged = 0;    // visible share off by more than the slack
  unsigned int mirrored = 0;     // whose other pose is the true one
  double mirroredOdds = 0.;      // greatest log-odds by which one of these was preferred
  std::vector<double> distances; // of the others: squared Mahalanobis distances, by their degrees of freedom

  void add(const Line &other)
  {
    frames += other.frames;
    found += other.found;
    wrong += other.wrong;
    misjudged += other.misjudged;
    mirrored += other.mirrored;
    mirroredOdds = std::max(mirroredOdds, other.mirroredOdds);
    distances.insert(distances.end(), other.distances.begin(), other.distances.end());
  }
};

void write(std::ostream &out, const std::string &what, double level, Line line)
{
  double mean = 0.;
  for (const double distance : line.distances) {
    mean += distance / static_cast<double>(line.distances.size());
  }
  std::sort(line.distances.begin(), line.distances.end());
  out << "| " << what << " | " << std::defaultfloat << std::setprecision(3) << level << " | " << line.frames << " | "
      << std::fixed << std::setprecision(1) << 100. * line.found / line.frames << " % | " << line.wrong << " | "
      << std::setprecision(2);
  if (line.distances.empty()) {
    out << "- | - | -";
  }
  else {
    out << mean << " | " << line.distances[line.distances.size() / 2] << " | " << line.distances.back();
  }
  out << " | " << line.mirrored << " | " << line.mirroredOdds << " | " << line.misjudged << " |" << std::endl;
}

// A name that no hardship has would give an empty table.
void checkName(const std::string &only)
{
  std::string names;
  for (const Hardship &hardship : hardships()) {
    if (only.empty() || hardship.name == only) {
      return;
    }
    if (names.find('"' + hardship.name + '"') == std::string::npos) {
      names += (names.empty() ? "\"" : ", \"") + hardship.name + '"';
    }
  }
  throw std::invalid_argument("no hardship is named \"" + only + "\"; there are " + names);
}

// Whether the marker was found and rightly read.
bool judge(const Scene &scene, const vpDetectorCircleMarker &detector, Line &line)
{
  const vpMarkerTruth &truth = scene.truth.front();
  bool isFound = false;
  ++line.frames;
  for (const vpCircleMarkerDetection &detection : detector.getDetections()) {
    if (detection.id != truth.id ||
        vpImagePoint::distance(detection.center, truth.center) > near * truth.ellipse->semiAxisA) {
      ++line.wrong;
      continue;
    }
    isFound = true;
    ++line.found;
    if (isMirrored(truth.cMo, detection)) {
      ++line.mirrored;
      line.mirroredOdds = std::max(line.mirroredOdds, detection.logOdds);
    }
    else {
      line.distances.push_back(common::squaredMahalanobis(truth.cMo, detection) / detection.dof);
    }
    line.misjudged += std::abs(detection.visible - truth.visibleEdge) > visibleSlack ? 1 : 0;
  }
  return isFound;
}
} // namespace

void tellHardships(std::ostream &out, const HardshipOptions &options)
{
  checkName(options.only);
  vpDetectorCircleMarker detector(vpCircleMarkerFamily::fromName(options.family));
  detector.setZAlignedWithCameraAxis(true);
  detector.setRefinePose(options.refine);
  out << "| " << options.family
      << ": hardship | level | frames | found and rightly read | others | mean d^2/dof | median | "
      << "greatest | mirrored | by odds of e^ | visible off |\n|---|---|---|---|---|---|---|---|---|---|---|\n";
  Line all;
  const Hardship *previous = nullptr;
  const auto sum = [&](const Hardship *next) {
    if (previous != nullptr && previous->covers && (next == nullptr || next->level != previous->level)) {
      write(out, "all that covers", previous->level, all);
      all = Line();
    }
    previous = next;
  };
  for (const Hardship &hardship : hardships()) {
    if (!options.only.empty() && hardship.name != options.only) {
      continue;
    }
    sum(&hardship);
    Line line;
    for (unsigned int frame = 0; frame < options.frames; ++frame) {
      const Scene scene = makeHardScene(hardship, options.family, 1000003 * options.seed + frame, options.markers);
      std::vector<vpHomogeneousMatrix> poses;
      detector.detect(scene.image, markerSize, scene.camera, poses);
      const unsigned int wrong = line.wrong;
      const bool isFound = judge(scene, detector, line);
      const bool hasOthers = line.wrong > wrong;
      if ((!isFound || hasOthers) && !options.pictures.empty()) {
        std::ostringstream name;
        name << options.pictures << '/' << hardship.name << '-' << hardship.level << '-' << frame
             << (hasOthers ? "-other" : "") << ".png";
        vpImageIo::write(scene.image, name.str());
      }
    }
    write(out, hardship.name, hardship.level, line);
    if (hardship.covers) {
      all.add(line);
    }
  }
  sum(nullptr);
}
} // namespace bench
