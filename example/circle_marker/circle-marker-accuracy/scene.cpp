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
 * What is photographed: a marker, its pose, the camera, the light.
 */

#include <algorithm>
#include <cmath>

#include <visp3/core/vpMath.h>
#include <visp3/core/vpPixelMeterConversion.h>

#include "circle_marker/common/moved_camera.h"
#include "scene.h"

namespace accuracy {
namespace {
constexpr unsigned int windowWidth = 640;
constexpr unsigned int windowHeight = 480;
// Between the ring and the border of window and image, pixels: blur and motion stay inside.
constexpr double border = 10.;
// Ink of the reference camera's pictures; no camera sees black.
constexpr double leastInk = 15., mostInk = 60.;

vpRotationMatrix turn(double angle, double x, double y, double z)
{
  return vpRotationMatrix(vpThetaUVector(angle * x, angle * y, angle * z));
}

/*! Rotation that takes the axis z to a line of sight by the shortest way. */
vpRotationMatrix toward(const vpColVector &sight)
{
  const double across = std::hypot(sight[0], sight[1]);
  return across == 0. ? vpRotationMatrix()
                      : turn(std::atan2(across, sight[2]), -sight[1] / across, sight[0] / across, 0.);
}

vpColVector sightThrough(const vpCameraParameters &camera, double u, double v)
{
  double x = 0.;
  double y = 0.;
  vpPixelMeterConversion::convertPoint(camera, u, v, x, y);
  vpColVector sight(3, 1.);
  sight[0] = x;
  sight[1] = y;
  return sight.normalize();
}

/*! Pixels of a small circle's image across the radius, for each radian it subtends. */
double magnification(const vpCameraParameters &camera, double u, double v)
{
  constexpr double step = 1.; // pixel
  const double du = v - camera.get_v0();
  const double dv = -(u - camera.get_u0());
  const double length = std::hypot(du, dv);
  const double su = length > 0. ? step * du / length : step;
  const double sv = length > 0. ? step * dv / length : 0.;
  const vpColVector a = sightThrough(camera, u - su, v - sv);
  const vpColVector b = sightThrough(camera, u + su, v + sv);
  return 2. * step / std::sqrt((b - a).sumSquare());
}

/*! Where along an axis of the window the ring's centre goes: anywhere it fits, else in the middle. */
double place(Draws &draws, double size, double diameter)
{
  const double slack = std::max(0., 0.5 * (size - diameter) - border);
  return 0.5 * (size - 1.) + draws.uniform(-slack, slack);
}
} // namespace

vpCircleMarkerFamily familyOf(const std::string &name)
{
  return name == "ring" ? vpCircleMarkerFamily::ring(ringRatio) : vpCircleMarkerFamily::fromName(name);
}

double Draws::scale(double low, double high)
{
  return std::exp(uniform(std::log(low), std::log(high)));
}

vpSimulatedMarker Scene::marker() const
{
  vpSimulatedMarker marker =
      family == "ring" ? vpSimulatedMarker::ring(size, ringRatio) : vpSimulatedMarker::circle(family, id, size);
  return marker.setPose(cMo);
}

vpSimulatedMarker Scene::tag() const
{
  const double sheet = sheetOfRing(size);
  return vpSimulatedMarker::aprilTag36h11(id % tagIds, tagOnSheet(sheet)).setSheetSide(sheet).setPose(cMo);
}

vpSimulatedMarker Scene::printed(vpSimulatedMarker marker) const
{
  return marker.setInkSpread(inkSpread).setBow(bow, bowAxis);
}

Ranges withReferenceLight(Ranges ranges)
{
  ranges.leastNoise = ranges.mostNoise = 2.;
  ranges.leastBlur = ranges.mostBlur = 0.7;
  ranges.leastContrast = ranges.mostContrast = 190.;
  return ranges;
}

Scene draw(const Ranges &ranges, const std::string &family, std::uint64_t seed)
{
  Draws draws(seed);
  Scene scene;
  scene.family = family;
  const auto code = familyOf(family);
  const int id = draws.index(1 << 20);
  scene.id = code.isCoded() ? id % static_cast<int>(code.getNbIds()) : -1;
  scene.size = ranges.size;

  const Camera &camera = ranges.camera;
  const double wanted = ranges.distance ? camera.parameters.get_px() * ranges.size / *ranges.distance
                                        : draws.scale(ranges.leastDiameter, ranges.mostDiameter);
  const double u = place(draws, camera.width, ranges.extent * wanted);
  const double v = place(draws, camera.height, ranges.extent * wanted);
  const double distance =
      ranges.distance ? *ranges.distance : magnification(camera.parameters, u, v) * ranges.size / wanted;
  const double tilt = vpMath::rad(draws.uniform(ranges.leastTilt, ranges.mostTilt));
  const double azimuth = draws.uniform(0., 2. * M_PI);
  const double spin = draws.uniform(0., 2. * M_PI);
  const vpColVector sight = sightThrough(camera.parameters, u, v);
  const vpRotationMatrix R =
      toward(sight) * turn(tilt, std::cos(azimuth), std::sin(azimuth), 0.) * turn(spin, 0., 0., 1.);
  // A range's distance is a depth, as in DESIGN's figures.
  const double along = ranges.distance ? distance / sight[2] : distance;
  scene.cMo = vpHomogeneousMatrix(vpTranslationVector(along * sight[0], along * sight[1], along * sight[2]), R);

  scene.width = ranges.wholeImage ? camera.width : windowWidth;
  scene.height = ranges.wholeImage ? camera.height : windowHeight;
  const double left = ranges.wholeImage ? 0. : std::round(u - place(draws, windowWidth, ranges.extent * wanted));
  const double top = ranges.wholeImage ? 0. : std::round(v - place(draws, windowHeight, ranges.extent * wanted));
  scene.camera = tutorial::movedPrincipalPoint(camera.parameters, -left, -top);
  scene.assumed = scene.camera;

  vpScenePhotometry &light = scene.photometry;
  light.noiseSigma = draws.uniform(ranges.leastNoise, ranges.mostNoise);
  light.blurSigma = draws.uniform(ranges.leastBlur, ranges.mostBlur);
  const double contrast = draws.uniform(ranges.leastContrast, ranges.mostContrast);
  light.ink = draws.uniform(leastInk, std::min(mostInk, ranges.mostPaper - contrast));
  light.paper = light.ink + contrast;
  scene.modelled = light;
  scene.ground = draws.uniform(10., 245.);
  scene.noiseSeed = draws.bits();
  return scene;
}
} // namespace accuracy
