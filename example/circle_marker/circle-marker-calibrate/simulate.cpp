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
 * Pictures of the target as a known camera sees it.
 */

#include "simulate.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include <visp3/circle_marker_simulator/vpMarkerSceneSimulator.h>

namespace calibrate {
namespace {
vpHomogeneousMatrix poseAt(const TargetPose &pose, const Eigen::Vector2d &place)
{
  vpHomogeneousMatrix cMo;
  const Eigen::Vector3d center = pose * place;
  for (unsigned int i = 0; i < 3; ++i) {
    cMo[i][3] = center[i];
    for (unsigned int j = 0; j < 3; ++j) {
      cMo[i][j] = pose.rotation(i, j);
    }
  }
  return cMo;
}

/*! The corners of the white sheet that a target is printed on, and its size. */
struct Paper
{
  Eigen::Vector2d middle;
  double width, height;
};

Paper paperOf(const Target &target)
{
  Eigen::Vector2d least = target.points.front().place, most = least;
  for (const TargetPoint &p : target.points) {
    least = least.cwiseMin(p.place);
    most = most.cwiseMax(p.place);
  }
  const double side = (target.points[1].place - target.points[0].place).norm();
  const double margin = target.hasCircles() ? 2. * target.points.front().radius : 2. * side;
  return Paper{0.5 * (least + most), most.x() - least.x() + 2. * margin, most.y() - least.y() + 2. * margin};
}

double radiusOf(const Target &target)
{
  double radius = 0.;
  for (const TargetPoint &p : target.points) {
    radius = std::max(radius, (p.place - paperOf(target).middle).norm() + p.radius);
  }
  return radius;
}

/*! Whether the whole sheet is in front of the camera, and not too near. */
bool isBefore(const Target &target, const TargetPose &pose)
{
  const Paper paper = paperOf(target);
  bool isGood = true;
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      const Eigen::Vector2d corner = paper.middle + Eigen::Vector2d(x * paper.width, y * paper.height);
      isGood = isGood && (pose * corner).z() > 0.2 * (pose * paper.middle).z();
    }
  }
  return isGood;
}

/*! Angle between the plane's normal and the line of sight to its middle, radians. */
double obliqueness(const Target &target, const TargetPose &pose)
{
  const Eigen::Vector3d middle = pose * paperOf(target).middle;
  return std::acos(std::min(1., std::abs(pose.rotation.col(2).dot(middle.normalized()))));
}

/*! Number of points whose circles are seen whole; corners need a square's side around them. */
std::size_t seenWhole(const Target &target, const Lens &lens, unsigned int width, unsigned int height,
                      const TargetPose &pose)
{
  constexpr double margin = 4.; // pixels
  const double side = (target.points[1].place - target.points[0].place).norm();
  std::size_t count = 0;
  for (const TargetPoint &p : target.points) {
    const double reach = p.radius > 0. ? 1.2 * p.radius : 1.2 * side;
    bool isSeen = true;
    for (int i = 0; i < 8; ++i) {
      const Eigen::Vector2d way(std::cos(i * M_PI / 4.), std::sin(i * M_PI / 4.));
      const auto image = lens.project(pose * (p.place + reach * way));
      isSeen = isSeen && image && image->x() > margin && image->y() > margin && image->x() < width - 1. - margin &&
               image->y() < height - 1. - margin;
    }
    count += isSeen ? 1 : 0;
  }
  return count;
}

vpSimulatedMarker chessboard(const Target &target, const TargetPose &pose)
{
  const double side = (target.points[1].place - target.points[0].place).norm();
  const auto columns = static_cast<unsigned int>(target.columns + 1), rows = static_cast<unsigned int>(target.rows + 1);
  vpImage<unsigned char> picture(rows, columns);
  for (unsigned int row = 0; row < rows; ++row) {
    for (unsigned int column = 0; column < columns; ++column) {
      picture[row][column] = (row + column) % 2 == 0 ? 0 : 255;
    }
  }
  return vpSimulatedMarker::bitmap(picture, columns * side, rows * side)
      .setPose(poseAt(pose, paperOf(target).middle))
      .setSheetSide(std::max(columns, rows) * side + 2. * side); // a field of paper around it
}
} // namespace

Lens lensOf(const vpCameraParameters &cam)
{
  const auto model = cam.get_projModel();
  const bool isPlain = model == vpCameraParameters::perspectiveProjWithoutDistortion;
  const bool isDistorted = model == vpCameraParameters::perspectiveProjWithDistortion;
  Lens lens = Lens::of(isPlain ? LensModel::Plain : (isDistorted ? LensModel::Distortion : LensModel::KannalaBrandt),
                       cam.get_px(), cam.get_py(), cam.get_u0(), cam.get_v0());
  if (isDistorted) {
    lens.numbers[4] = cam.get_kdu();
  }
  else if (!isPlain) {
    const std::vector<double> k = cam.getKannalaBrandtDistortionCoefficients();
    for (int i = 0; i < std::min(4, static_cast<int>(k.size())); ++i) {
      lens.numbers[4 + i] = k[static_cast<std::size_t>(i)];
    }
  }
  return lens;
}

TargetPose randomPose(const Target &target, const Lens &lens, unsigned int width, unsigned int height,
                      const HoldRange &range, std::uint64_t seed)
{
  std::mt19937_64 random(seed);
  const auto uniform = [&random](double low, double high) {
    return low + (high - low) * (static_cast<double>(random() >> 11) / 9007199254740992.);
  };
  const Eigen::Vector2d middle = paperOf(target).middle;
  // Where the target is as large as the image is high.
  const double nearest = radiusOf(target) * lens.numbers[1] / (0.5 * height);
  // A grid must be seen whole, six markers of a sheet are enough.
  const std::size_t wanted =
      target.kind == TargetKind::Markers ? std::min<std::size_t>(6, target.points.size()) : target.points.size();
  constexpr int mostTries = 100000;
  for (int i = 0; i < mostTries; ++i) {
    const double tilt = uniform(range.leastTilt, range.mostTilt) * M_PI / 180.;
    const double direction = uniform(-M_PI, M_PI);
    const Eigen::Vector3d axis(std::cos(direction), std::sin(direction), 0.);
    TargetPose pose;
    pose.rotation = (Eigen::AngleAxisd(tilt, axis) * Eigen::AngleAxisd(uniform(-M_PI, M_PI), Eigen::Vector3d::UnitZ()))
                        .toRotationMatrix();
    const auto ray = lens.normalised(Eigen::Vector2d(uniform(0., width), uniform(0., height)));
    if (!ray) {
      continue;
    }
    const double depth = nearest * uniform(0.7, 1.5);
    pose.translation =
        depth * Eigen::Vector3d(ray->x(), ray->y(), 1.) - pose.rotation * Eigen::Vector3d(middle.x(), middle.y(), 0.);
    constexpr double steepest = 60. * M_PI / 180.; // circles are found beyond, but nobody holds a target like that
    if (!isBefore(target, pose) || obliqueness(target, pose) > steepest) {
      continue;
    }
    if (seenWhole(target, lens, width, height, pose) >= wanted) {
      return pose;
    }
  }
  throw std::runtime_error("no pose shows the target whole in this camera's image; give another camera or target");
}

vpImage<unsigned char> renderTarget(const Target &target, const vpCameraParameters &cam, unsigned int width,
                                    unsigned int height, const TargetPose &pose, std::uint64_t seed)
{
  vpMarkerSceneSimulator simulator(cam, width, height);
  if (target.kind == TargetKind::Chessboard) {
    simulator.addMarker(chessboard(target, pose));
  }
  else {
    const Paper paper = paperOf(target);
    simulator.addMarker(vpSimulatedMarker::bitmap(vpImage<unsigned char>(1, 1, 255), paper.width, paper.height)
                            .setPose(poseAt(pose, paper.middle)));
    for (const TargetPoint &p : target.points) {
      const std::string family = target.family.getName();
      vpSimulatedMarker marker = family == "disc" ? vpSimulatedMarker::disc(2. * p.radius)
                                                  : vpSimulatedMarker::circle(family, p.id, 2. * p.radius);
      simulator.addMarker(marker.setPose(poseAt(pose, p.place)).setSheetSide(2.1 * p.radius));
    }
  }
  vpImage<unsigned char> I;
  simulator.render(I, seed);
  return I;
}
} // namespace calibrate
