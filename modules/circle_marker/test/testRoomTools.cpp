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
 * What the tests of the detector's rooms share.
 */

#include "testRoomTools.h"

#include <Eigen/Geometry>

namespace room_test {
Eigen::Vector2d MarkerScene::onMarker(double u, double v) const
{
  const Eigen::Vector3d ray((u - principal.x()) / focal, (v - principal.y()) / focal, 1.);
  const double depth = rotation.col(2).dot(center) / rotation.col(2).dot(ray);
  return rotation.leftCols<2>().transpose() * (depth * ray - center) / radius;
}

bool MarkerScene::isBlack(const Eigen::Vector2d &q) const
{
  const vpCircleMarkerLayout &layout = family.getLayout();
  const double r = q.norm();
  if (r < 1. && r >= layout.ringInner) {
    return true;
  }
  if (!family.isCoded() || r >= layout.codeOuter || r < layout.codeInner) {
    return false;
  }
  const unsigned int n = family.getNbSectors();
  const double turns = std::atan2(q.y(), q.x()) / (2. * M_PI);
  const unsigned int sector = static_cast<unsigned int>(std::floor((turns - std::floor(turns)) * n)) % n;
  return circle_marker::isSectorBlack(word, sector, n);
}

double MarkerScene::operator()(double u, double v) const
{
  const Eigen::Vector2d q = onMarker(u, v);
  if (std::fabs(q.x()) > sheet || std::fabs(q.y()) > sheet) {
    return surround;
  }
  return isBlack(q) ? black : white;
}

circle_marker::ImageFrame MarkerScene::frame() const
{
  return {focal * center.head<2>() / center.z() + principal, focal * radius / center.z()};
}

circle_marker::MarkerPlane MarkerScene::plane() const
{
  circle_marker::MarkerPlane plane;
  plane.center = center;
  plane.rotation = rotation;
  plane.radius = radius;
  return plane;
}

vpImage<double> greyPlane(unsigned int width, unsigned int height, double grey, double byU, double byV)
{
  vpImage<double> I(height, width);
  for (unsigned int v = 0; v < height; ++v) {
    for (unsigned int u = 0; u < width; ++u) {
      I[v][u] = grey + byU * (u - 0.5 * width) + byV * (v - 0.5 * height);
    }
  }
  return I;
}

vpImage<unsigned char> digitise(const vpImage<double> &exposed, double noise, Random &random)
{
  std::normal_distribution<double> normal(0., 1.);
  vpImage<unsigned char> I(exposed.getHeight(), exposed.getWidth());
  for (unsigned int i = 0; i < I.getSize(); ++i) {
    const double grey = exposed.bitmap[i] + (noise > 0. ? noise * normal(random) : 0.);
    I.bitmap[i] = static_cast<unsigned char>(std::lround(std::min(std::max(grey, 0.), 255.)));
  }
  return I;
}

Eigen::Matrix3d turn(double angle, const Eigen::Vector3d &axis)
{
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

double tiltOf(const circle_marker::MarkerPlane &plane)
{
  return std::acos(std::min(1., plane.rotation.col(2).dot(plane.center.normalized())));
}

circle_marker::MarkerPlane twinOf(const circle_marker::MarkerPlane &plane)
{
  circle_marker::MarkerPlane twin = plane;
  const Eigen::Vector3d sight = plane.center.normalized();
  twin.rotation = turn(-2. * tiltOf(plane), sight.cross(plane.rotation.col(2))) * plane.rotation;
  return twin;
}

MarkerScene markerScene(Random &random, const vpCircleMarkerFamily &family, int id, double diameter, double tilt,
                        unsigned int side)
{
  MarkerScene scene;
  scene.family = family;
  scene.word = family.isCoded() ? family.getCodeword(id) : 0;
  scene.principal = Eigen::Vector2d(0.5 * side + uniform(random, -30., 30.), 0.5 * side + uniform(random, -30., 30.));
  const double depth = 2. * scene.radius * scene.focal / diameter;
  // Its centre anywhere within a pixel of the image's middle.
  const Eigen::Vector2d seen(0.5 * side + uniform(random, -0.5, 0.5), 0.5 * side + uniform(random, -0.5, 0.5));
  const Eigen::Vector2d meter = (seen - scene.principal) / scene.focal;
  scene.center = depth * Eigen::Vector3d(meter.x(), meter.y(), 1.);
  const double azimuth = uniform(random, 0., 2. * M_PI);
  scene.rotation = turn(tilt, Eigen::Vector3d(std::cos(azimuth), std::sin(azimuth), 0.)) *
                   turn(uniform(random, -M_PI, M_PI), Eigen::Vector3d::UnitZ());
  return scene;
}

vpImage<double> moved(const vpImage<double> &sharp, int way)
{
  vpImage<double> I(sharp.getHeight(), sharp.getWidth(), 0.);
  const int last = static_cast<int>(sharp.getWidth()) - 1;
  for (unsigned int v = 0; v < sharp.getHeight(); ++v) {
    for (int u = 0; u <= last; ++u) {
      for (int k = -way / 2; k <= way / 2; ++k) {
        I[v][static_cast<unsigned int>(u)] += sharp[v][static_cast<unsigned int>(std::clamp(u + k, 0, last))] / way;
      }
    }
  }
  return I;
}
} // namespace room_test
