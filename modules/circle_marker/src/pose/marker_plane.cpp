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
 * Pose of a marker's plane, and how its sheet is bent.
 */

#include "pose/marker_plane.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
// These are not inline: nearly every file of the detector reads the header, and each would compile their matrices anew.
double SheetBend::height(const Eigen::Vector2d &q) const
{
  return 0.5 * (q.dot(slope(q)) - bow);
}

Eigen::Vector2d SheetBend::slope(const Eigen::Vector2d &q) const
{
  return bow * q + Eigen::Vector2d(saddle.x() * q.x() + saddle.y() * q.y(), saddle.y() * q.x() - saddle.x() * q.y());
}

Eigen::Vector2d SheetBend::shift(const Eigen::Vector2d &q) const
{
  return -q.dot(slope(q)) / 6. * slope(q);
}

Eigen::Vector2d SheetBend::seenAt(const Eigen::Vector2d &flat, const Eigen::Vector2d &slant) const
{
  Eigen::Vector2d q = flat;
  for (int i = 0; i < steps; ++i) {
    q = flat + height(q) * slant - shift(q);
  }
  return q;
}

void SheetBend::spin(double angle)
{
  const double c = std::cos(2. * angle);
  const double s = std::sin(2. * angle);
  saddle = Eigen::Vector2d(c * saddle.x() + s * saddle.y(), c * saddle.y() - s * saddle.x());
}

Eigen::Vector2d MarkerPlane::project(const Eigen::Vector2d &q) const
{
  Eigen::Vector3d p = center + radius * (rotation.leftCols<2>() * q);
  if (bend.isAny()) {
    p += radius * (rotation.leftCols<2>() * bend.shift(q) + bend.height(q) * rotation.col(2));
  }
  return p.head<2>() / p.z();
}

Eigen::Vector2d MarkerPlane::intersect(const Eigen::Vector2d &meter) const
{
  const Eigen::Vector3d ray(meter.x(), meter.y(), 1.);
  const double depth = rotation.col(2).dot(center) / rotation.col(2).dot(ray);
  const Eigen::Vector2d flat = rotation.leftCols<2>().transpose() * (depth * ray - center) / radius;
  return bend.isAny() ? bend.seenAt(flat, slantAt(flat)) : flat;
}

Eigen::Vector2d MarkerPlane::slantAt(const Eigen::Vector2d &flat) const
{
  const Eigen::Vector3d camera = -rotation.transpose() * center / radius;
  return (flat - camera.head<2>()) / -camera.z();
}

bool MarkerPlane::showsFront() const
{
  return center.z() > 0.1 * radius && rotation.col(2).dot(center) > 0.;
}

double MarkerPlane::foreshortening() const
{
  return rotation.col(2).dot(center.normalized());
}

double MarkerPlane::semiMinor(double unit) const
{
  return std::abs(foreshortening()) * radius / (center.norm() * unit);
}

void MarkerPlane::spin(double angle)
{
  rotation = rotation * Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  bend.spin(angle);
}

Eigen::Matrix<double, 6, 6> turnedCovariance(const Eigen::Matrix<double, 6, 6> &covariance,
                                             const Eigen::Matrix3d &rotation, double unit)
{
  Eigen::Matrix<double, 6, 6> change = Eigen::Matrix<double, 6, 6>::Zero();
  change.topLeftCorner<3, 3>() = unit * rotation;
  change.bottomRightCorner<3, 3>() = rotation;
  return change * covariance * change.transpose();
}

void copySpin(const MarkerPlane &from, MarkerPlane &to)
{
  const Eigen::Vector2d onTo = to.intersect(from.project(Eigen::Vector2d(1., 0.)));
  to.spin(std::atan2(onTo.y(), onTo.x()));
}

double outlineMotion(const MarkerPlane &from, const MarkerPlane &to)
{
  double squared = 0.;
  for (const double x : {-1., 1.}) {
    for (const Eigen::Vector2d &q : {Eigen::Vector2d(x, 0.), Eigen::Vector2d(0., x)}) {
      // The spin moves no outline: the same points of space, about, are compared.
      const Eigen::Vector2d p = from.rotation.leftCols<2>().transpose() * to.rotation.leftCols<2>() * q;
      squared = std::max(squared, (to.project(q) - from.project(p.normalized())).squaredNorm());
    }
  }
  return std::sqrt(squared);
}

double printMotion(const MarkerPlane &from, const MarkerPlane &to)
{
  double squared = (to.project(Eigen::Vector2d::Zero()) - from.project(Eigen::Vector2d::Zero())).squaredNorm();
  for (const double x : {-1., 0., 1.}) {
    for (const double y : {-1., 0., 1.}) {
      if (x != 0. || y != 0.) {
        const Eigen::Vector2d q = Eigen::Vector2d(x, y).normalized();
        squared = std::max(squared, (to.project(q) - from.project(q)).squaredNorm());
      }
    }
  }
  return std::sqrt(squared);
}
} // namespace circle_marker
END_VISP_NAMESPACE
