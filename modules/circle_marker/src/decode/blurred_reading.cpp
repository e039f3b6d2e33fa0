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
 * Code and pose of a marker seen through a strong blur.
 */

#include "decode/blurred_reading.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "decode/blurred_looks.h"
#include "decode/blurred_words.h"
#include "decode/cyclic_code.h"
#include "pose/hypotheses.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Samples of the fit, the fewest that prove something, with some thirty unknowns (500 true markers had 200 and more, by
// a private count), and its steps.
constexpr std::size_t manySamples = 500;
constexpr std::size_t leastSamples = 125;
constexpr int finishedSteps = 10;
// Spins that are told apart, by the sector.
constexpr int phases = 8;
// A codeword that is seen through a blur leaves this share of the image's variance unexplained at most: those of true
// markers leave a hundredth.
constexpr double mostUnexplained = 0.05;
// A defocus beyond this radius, in semi-major axes, has wiped out the finest of a code: of sectors that are black and
// white in turn, 11.5 cycles around a track of mean radius 0.54, a disc shows nothing from 0.18 on (the first zero of
// its transfer function). Then a codeword, too, may leave no more than so many times what sectors of any grey leave:
// those of 25 true markers left up to 1.7, of codes of 19 sectors, which golay23 was read from, 2.3 and more (private
// counts).
constexpr double wideDisc = 0.2;
constexpr double mostOfAnySectors = 2.;
// No marker that moved farther than this is read, in semi-major axes: a quarter of its diameter, half of this axis, is
// promised. A motion three times as long as the axis made two dots of a grid look like a code.
constexpr double longestWay = 0.7;
// A ring has no code to prove it.
constexpr double mostUnexplainedOfRing = 0.02;
// A codeword that leaves less than this unexplained is not looked for elsewhere.
constexpr double sureUnexplained = 0.01;

// Whether a codeword explains what sectors of any grey do, in a blur as there is.
bool isCode(const BlurredFit &fit, double unexplained, const EllipseParameters &outline)
{
  const bool isFineSeen = fit.blur.disc < wideDisc * outline.a;
  return fit.blur.motion.norm() < longestWay * outline.a &&
         (isFineSeen || unexplained < mostOfAnySectors * fit.unexplained());
}

// Whether a fit saw enough of the image to say anything. Markers that are believed to move far see none of it: all of
// the motion has to lie within their quiet zone.
bool sawEnough(const BlurredFit &fit)
{
  return fit.squares < HUGE_VAL && fit.samples >= leastSamples;
}

// The other pose of the circle's image.
MarkerPlane twinOf(const MarkerPlane &plane, const CameraModel &camera)
{
  constexpr std::size_t count = 32;
  std::vector<EdgePoint> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2. * M_PI * static_cast<double>(i) / count;
    points[i].position = camera.toPixel(plane.project(Eigen::Vector2d(std::cos(angle), std::sin(angle))));
  }
  const auto poses = posesFromOutline(points, camera, plane.radius);
  if (!poses) {
    return plane;
  }
  const auto cosine = [&](std::size_t i) { return (*poses)[i].rotation.col(2).dot(plane.rotation.col(2)); };
  return (*poses)[cosine(0) < cosine(1) ? 0 : 1];
}

// Fits the twin as well, puts the better first, and tells how well both are known.
void fitBoth(BlurredMarker &marker, const CameraModel &camera, bool movesSpin, BlurredReading &reading)
{
  constexpr double samePose = 0.02; // rad between two normals: less is one pose
  BlurredFit &fit = reading.fit;
  marker.select(fit.plane, fit.blur, manySamples);
  marker.solve(fit);
  marker.improve(fit, finishedSteps, movesSpin);
  BlurredFit twin;
  twin.plane = twinOf(fit.plane, camera);
  copySpin(fit.plane, twin.plane);
  twin.blur = fit.blur;
  marker.solve(twin);
  marker.improve(twin, finishedSteps, movesSpin);
  if (twin.squares < fit.squares) {
    std::swap(fit, twin);
  }
  const auto freedom = static_cast<double>(fit.samples) - static_cast<double>(fit.linear.size()) - 8.; // pose, blur
  const double variance = fit.squares / std::max(freedom, 1.);
  reading.poses.covariance[0] = marker.covariance(fit);
  reading.poses.covariance[1] = reading.poses.covariance[0];
  reading.poses.cost[0] = fit.squares / (2. * variance * marker.coherence());
  reading.poses.noise = std::sqrt(variance);
  reading.poses.unexplained = fit.unexplained();
  reading.twin = fit.plane;
  const double cosine = twin.plane.rotation.col(2).dot(fit.plane.rotation.col(2));
  if (twin.squares < HUGE_VAL && cosine < std::cos(samePose)) {
    reading.twin = twin.plane;
    reading.poses.covariance[1] = marker.covariance(twin);
    reading.poses.cost[1] = twin.squares / (2. * variance * marker.coherence());
  }
}
} // namespace

std::optional<BlurredReading> readBlurred(const vpImage<unsigned char> &I, const CameraModel &camera,
                                          const EllipseParameters &outline, double radius,
                                          const vpCircleMarkerFamily &family, double leastMargin,
                                          const Deadline &deadline)
{
  BlurredMarker marker(I, camera, family, deadline);
  std::vector<BlurredFit> fits = bestLooks(marker, camera, outline, radius, deadline);
  std::optional<BlurredReading> best;
  const CyclicCode &code = codeOf(family);
  for (BlurredFit &fit : fits) {
    if (!(fit.squares < HUGE_VAL)) {
      continue;
    }
    // The spin that explains most, then all together.
    marker.select(fit.plane, fit.blur, manySamples);
    BlurredFit turned = fit;
    turned.squares = HUGE_VAL;
    for (int i = 0; i < phases; ++i) {
      BlurredFit other;
      other.plane = fit.plane;
      other.blur = fit.blur;
      other.plane.spin(2. * M_PI * i / (phases * family.getNbSectors()));
      marker.solve(other);
      if (other.squares < turned.squares) {
        turned = other;
      }
    }
    // A codeword leaves no less than sectors that may have any grey.
    if (!(turned.squares < HUGE_VAL) || turned.unexplained() > mostUnexplained) {
      continue;
    }
    marker.improve(turned, finishedSteps, true);
    if (turned.samples < leastSamples) {
      continue;
    }
    const BestWords words = bestWords(turned, code, deadline);
    const auto identity = code.identify(words.best);
    if (!identity) {
      continue;
    }
    BlurredReading reading;
    reading.fit = turned;
    reading.unexplained = words.squares / turned.plain;
    reading.code.id = identity->id;
    reading.code.margin = 1. - words.squares / words.next;
    reading.code.spin = 2. * M_PI * identity->rotation / family.getNbSectors();
    if (isCode(turned, reading.unexplained, outline) && (!best || reading.unexplained < best->unexplained)) {
      best = reading;
    }
    if (best && best->unexplained < sureUnexplained) {
      break;
    }
  }
  if (deadline.hasPassed() || !best || best->unexplained > mostUnexplained || best->code.margin < leastMargin) {
    return std::nullopt; // and no time is spent on its poses
  }
  fitBoth(marker, camera, true, *best);
  best->poses.disc = best->fit.blur.disc / outline.a;
  return deadline.hasPassed() || !sawEnough(best->fit) ? std::nullopt : best;
}

std::optional<BlurredReading> fitBlurredRing(const vpImage<unsigned char> &I, const CameraModel &camera,
                                             const EllipseParameters &outline, double radius,
                                             const vpCircleMarkerFamily &family, const Deadline &deadline)
{
  BlurredMarker marker(I, camera, family, deadline);
  BlurredReading best;
  for (BlurredFit &fit : bestLooks(marker, camera, outline, radius, deadline)) {
    if (!(fit.squares < HUGE_VAL)) {
      continue;
    }
    marker.select(fit.plane, fit.blur, manySamples);
    marker.solve(fit);
    marker.improve(fit, finishedSteps, false);
    if (sawEnough(fit) && fit.blur.motion.norm() < longestWay * outline.a && fit.unexplained() < best.unexplained) {
      best.fit = fit;
      best.unexplained = fit.unexplained();
    }
  }
  if (deadline.hasPassed() || best.unexplained > mostUnexplainedOfRing) {
    return std::nullopt;
  }
  fitBoth(marker, camera, false, best);
  best.poses.disc = best.fit.blur.disc / outline.a;
  best.code.margin = 1.;
  const bool isRing = sawEnough(best.fit) && best.poses.unexplained <= mostUnexplainedOfRing;
  return deadline.hasPassed() || !isRing ? std::nullopt : std::optional<BlurredReading>(best);
}
} // namespace circle_marker
END_VISP_NAMESPACE
