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
 * What the servo's camera looks at: an object with one or two markers, and covers in front of them.
 */

#include "servo_scene.h"

#include <visp3/core/vpColVector.h>
#include <visp3/core/vpThetaUVector.h>
#include <visp3/core/vpTranslationVector.h>

#include "../camera_file.h"

namespace tutorial {
namespace {
constexpr int circleId = 5;
constexpr int tagId = 0;

/*! A marker whose white sheet has the width of the ring and its quiet zone: 7/6 of the ring's diameter. */
MountedMarker mountedCircle(double sheet, double x)
{
  return MountedMarker{circleId, sheet * 6. / 7., sheet,
                       vpHomogeneousMatrix(vpTranslationVector(x, 0., 0.), vpRotationMatrix())};
}

/*! A tag whose white sheet is one module wider on each side of its eight, turned about its normal. */
MountedMarker mountedTag(double sheet, double x, double spin)
{
  return MountedMarker{
      tagId, sheet * 8. / 10., sheet,
      vpHomogeneousMatrix(vpTranslationVector(x, 0., 0.), vpRotationMatrix(vpThetaUVector(0., 0., spin)))};
}

/*! Something dark that hides a marker and leaves a rim of its sheet to be seen. */
vpSceneOccluder coverOf(const vpMarkerSceneSimulator &simulator, const vpHomogeneousMatrix &cMm, double sheet)
{
  constexpr double grey = 70.; // neither ink nor paper
  const double half = 0.5 * 0.95 * sheet;
  std::vector<vpImagePoint> corners;
  for (const auto &[x, y] :
       {std::pair(-half, -half), std::pair(half, -half), std::pair(half, half), std::pair(-half, half)}) {
    const vpColVector P = cMm * vpColVector(std::vector<double>{x, y, 0., 1.});
    corners.push_back(simulator.project(P[0], P[1], P[2]));
  }
  return vpSceneOccluder::polygon(corners, grey);
}
} // namespace

std::vector<MountedMarker> ServoObject::markers() const
{
  std::vector<MountedMarker> all;
  for (const auto &marker : {circle, aprilTag}) {
    if (marker) {
      all.push_back(*marker);
    }
  }
  return all;
}

ServoObject makeObject(MarkerChoice choice)
{
  // At the desired distance of 0.5 m the camera sees 0.4 m by 0.3 m. What turns about the optical axis there must fit
  // into the 0.3 m: a sheet's diagonal is then 0.2 m, that of two sheets beside one another 0.24 m.
  constexpr double singleSheet = 0.14;
  constexpr double doubleSheet = 0.105;
  constexpr double gap = 0.005;
  constexpr double offset = 0.5 * (doubleSheet + gap);
  // AprilTag's corners are off by up to 0.2 pixels, and its normal at 0.5 m by 0.4 degrees, where its edges run along
  // the rows and columns of the pixels, as they would at the goal; at 20 degrees from them it is 0.02 pixels and 0.01
  // degrees. Beside a circular marker the tag is only used on the way.
  constexpr double tagSpin = 20. * M_PI / 180.;
  switch (choice) {
  case MarkerChoice::Circle:
    return ServoObject{mountedCircle(singleSheet, 0.), std::nullopt};
  case MarkerChoice::AprilTag:
    return ServoObject{std::nullopt, mountedTag(singleSheet, 0., tagSpin)};
  default:
    return ServoObject{mountedCircle(doubleSheet, -offset), mountedTag(doubleSheet, offset, 0.)};
  }
}

std::vector<vpColVector> sheetCorners(const MountedMarker &marker)
{
  const double half = 0.5 * marker.sheet;
  std::vector<vpColVector> corners;
  for (const double x : {-half, half}) {
    for (const double y : {-half, half}) {
      corners.push_back(marker.oMm * vpColVector(std::vector<double>{x, y, 0., 1.}));
    }
  }
  return corners;
}

ServoCamera servoCamera(const std::string &file, const std::string &name)
{
  if (file.empty()) {
    return ServoCamera{vpCameraParameters(1600., 1600., 639.5, 479.5), 1280, 960};
  }
  const NamedCamera camera = readCamera(file, name, 0, 0);
  if (camera.width == 0 || camera.height == 0) {
    throw CameraError("\"" + file + "\" does not say the size of the images; add image_width and image_height");
  }
  return ServoCamera{camera.parameters, camera.width, camera.height};
}

vpImage<unsigned char> renderScene(const ServoCamera &camera, const ServoObject &object, const vpHomogeneousMatrix &cMo,
                                   const Covers &covers, std::uint64_t seed)
{
  vpScenePhotometry photometry;
  photometry.noiseSigma = 2.;
  photometry.blurSigma = 0.7;
  vpMarkerSceneSimulator simulator(camera.parameters, camera.width, camera.height);
  simulator.setPhotometry(photometry);
  simulator.setBackground(vpSceneBackground::plain(110.));
  if (const auto &circle = object.circle) {
    const vpHomogeneousMatrix cMm = cMo * circle->oMm;
    simulator.addMarker(
        vpSimulatedMarker::circle("golay23", circle->id, circle->size).setSheetSide(circle->sheet).setPose(cMm));
    if (covers.circle) {
      simulator.addOccluder(coverOf(simulator, cMm, circle->sheet));
    }
  }
  if (const auto &tag = object.aprilTag) {
    const vpHomogeneousMatrix cMm = cMo * tag->oMm;
    simulator.addMarker(vpSimulatedMarker::aprilTag36h11(tag->id, tag->size).setSheetSide(tag->sheet).setPose(cMm));
    if (covers.aprilTag) {
      simulator.addOccluder(coverOf(simulator, cMm, tag->sheet));
    }
  }
  vpImage<unsigned char> I;
  simulator.render(I, seed);
  return I;
}
} // namespace tutorial
