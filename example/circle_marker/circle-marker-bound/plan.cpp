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
 * What the planner computes: bounds over distances, the farthest distance, the least size.
 */

#include <cmath>

#include <visp3/core/vpException.h>
#include <visp3/core/vpMath.h>
#include <visp3/core/vpPixelMeterConversion.h>

#include <visp3/circle_marker_simulator/vpMarkerSceneSimulator.h>

#include "plan.h"

namespace planner {
namespace {
// Least angle at which there are two poses to be told apart, degrees.
constexpr double facing = 0.5;
// Smallest image of a marker that is looked at, pixels: no code and no second edge can be seen in less.
constexpr double leastPixels = 5.;
// Halvings of the interval, of the logarithm of distance or size, in a search: to 0.1 %.
constexpr int halvings = 12;

vpSimulatedMarker markerOf(const Settings &settings, double size)
{
  return settings.family == "ring" ? vpSimulatedMarker::ring(size, settings.ratio)
                                   : vpSimulatedMarker::circle(settings.family, settings.id, size);
}

/*! In the middle of the image, on the line of sight through it. */
vpHomogeneousMatrix poseOf(const Settings &settings, double distance, double angle)
{
  double x = 0.;
  double y = 0.;
  vpPixelMeterConversion::convertPoint(settings.camera, 0.5 * (settings.width - 1.), 0.5 * (settings.height - 1.), x,
                                       y);
  vpColVector sight(3);
  sight[0] = x;
  sight[1] = y;
  sight[2] = 1.;
  sight.normalize();
  // From the z axis to the line of sight by the shortest way, after the tilt about x.
  const double across = std::hypot(sight[0], sight[1]);
  const double turn = std::atan2(across, sight[2]);
  const vpThetaUVector toSight(across > 0. ? -turn * sight[1] / across : 0.,
                               across > 0. ? turn * sight[0] / across : 0., 0.);
  const vpRotationMatrix R = vpRotationMatrix(toSight) * vpRotationMatrix(vpThetaUVector(vpMath::rad(angle), 0., 0.));
  return vpHomogeneousMatrix(vpTranslationVector(distance * sight[0], distance * sight[1], distance * sight[2]), R);
}

vpMarkerPoseBound limitOf(const Settings &settings)
{
  vpScenePhotometry photometry = settings.photometry;
  photometry.noiseSigma = noiseWithRounding(photometry.noiseSigma);
  vpMarkerPoseBound limit(settings.camera, photometry);
  limit.setSurround(settings.surround);
  return limit;
}

/*! Whether the sheet lies within the image: the corners of its least quiet zone. */
bool fits(const Settings &settings, const vpSimulatedMarker &marker)
{
  const vpMarkerSceneSimulator simulator(settings.camera, settings.width, settings.height);
  const vpHomogeneousMatrix &cMo = marker.getPose();
  for (const double sx : {-0.5, 0.5}) {
    for (const double sy : {-0.5, 0.5}) {
      const double x = sx * marker.getSheetWidth();
      const double y = sy * marker.getSheetHeight();
      const vpImagePoint p =
          simulator.project(cMo[0][0] * x + cMo[0][1] * y + cMo[0][3], cMo[1][0] * x + cMo[1][1] * y + cMo[1][3],
                            cMo[2][0] * x + cMo[2][1] * y + cMo[2][3]);
      if (p.get_u() < -0.5 || p.get_v() < -0.5 || p.get_u() > settings.width - 0.5 ||
          p.get_v() > settings.height - 0.5) {
        return false;
      }
    }
  }
  return true;
}

Row rowOf(const Settings &settings, double size, double distance, double angle, bool withSeparation)
{
  vpSimulatedMarker marker = markerOf(settings, size);
  marker.setPose(poseOf(settings, distance, angle));
  vpMarkerSceneSimulator simulator(settings.camera, settings.width, settings.height);
  simulator.addMarker(marker);
  const vpEllipseTruth ellipse = simulator.getTruth()[0].ellipse.value();

  Row row;
  row.angle = angle;
  row.distance = distance;
  row.diameter = 2. * ellipse.semiAxisA;
  row.minor = 2. * ellipse.semiAxisB;
  row.isInImage = fits(settings, marker);
  const vpMarkerPoseBound limit = limitOf(settings);
  row.bound = limit.bound(marker);
  if (withSeparation && angle >= facing) {
    row.separation = limit.separation(marker);
  }
  return row;
}

double focal(const Settings &settings)
{
  return 0.5 * (settings.camera.get_px() + settings.camera.get_py());
}

/*!
  Where a property that holds at `good` and not at `bad` ends; nothing if it does not hold at `good`, `bad` if it holds
  there as well. Both are positive; the interval's logarithm is halved.
*/
template <typename Property> std::optional<double> endOf(double good, double bad, const Property &holds)
{
  if (!holds(good)) {
    return std::nullopt;
  }
  if (holds(bad)) {
    return bad;
  }
  for (int i = 0; i < halvings; ++i) {
    const double middle = std::sqrt(good * bad);
    (holds(middle) ? good : bad) = middle;
  }
  return good;
}

Reach reachOf(const Settings &settings, double angle)
{
  const auto rowAt = [&](double size, double distance) {
    return rowOf(settings, size, distance, angle, settings.wanted.wrong.has_value());
  };
  Reach reach;
  reach.angle = angle;
  const double farthest = focal(settings) * settings.size / leastPixels;
  const double nearest = std::min(settings.minDistance, 0.5 * farthest);
  reach.distance = endOf(nearest, farthest, [&](double d) { return isEnough(rowAt(settings.size, d), settings); });
  if (reach.distance) {
    reach.pixels = rowAt(settings.size, *reach.distance).diameter;
  }
  const double distance = settings.sizeFor.value_or(settings.maxDistance);
  // A marker as wide as half the image: more is hard to keep in sight. Before a wide lens one side of such a sheet may
  // be behind the camera; half of the distance is left to it.
  const double sheet = markerOf(settings, 1.).getSheetHeight();
  const double largest = distance * std::min(0.5 * settings.width / focal(settings),
                                             1. / std::max(sheet * std::sin(vpMath::rad(angle)), 1e-9));
  const double smallest = distance * leastPixels / focal(settings);
  reach.size = endOf(largest, smallest, [&](double size) { return isEnough(rowAt(size, distance), settings); });
  return reach;
}
} // namespace

double noiseWithRounding(double noise)
{
  constexpr double rounding = 1. / 12.; // Variance of an error that is even over one grey level.
  return std::sqrt(noise * noise + rounding);
}

std::vector<Row> rowsOf(const Settings &settings, const Progress &progress)
{
  std::vector<Row> rows(settings.angles.size() * settings.rows);
  const double step = settings.rows > 1 ? (settings.maxDistance - settings.minDistance) / (settings.rows - 1.) : 0.;
  forEachItem(
      rows.size(), settings.jobs,
      [&]() {
        return [&](std::size_t i) {
          const double distance = settings.minDistance + step * static_cast<double>(i % settings.rows);
          rows[i] = rowOf(settings, settings.size, distance, settings.angles[i / settings.rows], true);
        };
      },
      progress);
  return rows;
}

bool isEnough(const Row &row, const Settings &settings)
{
  const Wanted &wanted = settings.wanted;
  const auto keeps = [&](double value, const std::optional<double> &limit) {
    return !limit || settings.reserve * value <= *limit;
  };
  return keeps(std::max(row.bound.x, row.bound.y), wanted.xy) && keeps(row.bound.z, wanted.z) &&
         keeps(row.bound.normal, wanted.normal) &&
         (!wanted.wrong || !row.separation || row.separation->wrongChoice <= *wanted.wrong);
}

std::vector<Reach> reachesOf(const Settings &settings, const Progress &progress)
{
  std::vector<Reach> reaches(settings.angles.size());
  forEachItem(
      reaches.size(), settings.jobs,
      [&]() { return [&](std::size_t i) { reaches[i] = reachOf(settings, settings.angles[i]); }; }, progress);
  return reaches;
}
} // namespace planner
