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
 * The print of a marker as it is seen through a blur.
 */

#include "decode/blurred_print.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Blur of a sharp picture, lens 0.75 and pixel area 0.29, pixels.
constexpr double commonBlur = 0.8;
// Points of a line of motion; rings of points of a disc, beside its centre, with 6 and 12 points.
constexpr int linePoints = 9;
constexpr int discRings = 2;
constexpr double discPoints = 19.;
// A ramp of this width has a standard deviation of 1.
constexpr double rampPerSigma = 3.46;
// Nearer to the centre there is nothing, and no direction; radii.
constexpr double leastRadius = 1e-3;

// Share of what lies below an edge at \e distance (positive: inside), in units of the width of its ramp.
double ramp(double distance)
{
  return std::clamp(distance + 0.5, 0., 1.);
}

// Its derivative.
double slopeOfRamp(double distance)
{
  return std::abs(distance) < 0.5 ? 1. : 0.;
}
} // namespace

void BlurredPrint::set(const MarkerPlane &plane, const ImageBlur &blur, const Eigen::Matrix2d &meterPerPixel,
                       double block)
{
  m_meterPerPixel = meterPerPixel;
  const Eigen::Vector3d normal = plane.rotation.col(2);
  const double depth = normal.dot(plane.center);
  for (int row = 0; row < 2; ++row) {
    const Eigen::Vector3d axis = plane.rotation.col(row);
    m_toPlane.row(row) = (depth * axis - axis.dot(plane.center) * normal).transpose() / plane.radius;
  }
  m_toPlane.row(2) = normal.transpose();
  m_eye = -plane.rotation.transpose() * plane.center / plane.radius;
  std::vector<Eigen::Vector2d> kernel;
  m_byBlur.clear();
  m_isDisc = blur.disc > leastKernel;
  double variance = commonBlur * commonBlur + (block * block - 1.) / 12.;
  if (m_isDisc) {
    m_byBlur.emplace_back(0., 0.);
    int count = 1;
    for (int ring = 1; ring <= discRings; ++ring) {
      const int points = 6 * ring;
      // Each ring of points stands for a ring of the disc with its share of the area.
      const double inner = count / discPoints;
      const double outer = (count + points) / discPoints;
      const double radius = std::sqrt(0.5 * (inner + outer));
      for (int i = 0; i < points; ++i) {
        const double angle = 2. * M_PI * (i + 0.5 * ring) / points;
        m_byBlur.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
      }
      count += points;
    }
    for (const Eigen::Vector2d &point : m_byBlur) {
      kernel.emplace_back(blur.disc * point);
    }
    variance += blur.disc * blur.disc / (4. * discPoints);
    m_sigmaByBlur = Eigen::Vector2d(blur.disc / (4. * discPoints), 0.);
  }
  else {
    const bool isMoved = blur.motion.norm() > leastKernel;
    const int points = isMoved ? linePoints : 1;
    for (int i = 0; i < points; ++i) {
      const double share = (i + 0.5) / points - 0.5;
      m_byBlur.emplace_back(Eigen::Vector2d::Constant(share));
      kernel.emplace_back(share * blur.motion);
    }
    const double perWay = isMoved ? 1. / (24. * linePoints * linePoints) : 0.;
    variance += perWay * blur.motion.squaredNorm();
    m_sigmaByBlur = perWay * blur.motion;
  }
  m_steps.clear();
  for (const Eigen::Vector2d &point : kernel) {
    m_steps.emplace_back(m_toPlane.leftCols<2>() * (m_meterPerPixel * point));
  }
  m_sigma = std::sqrt(variance);
  m_sigmaByBlur /= variance;
}

bool BlurredPrint::isWithin(const Eigen::Vector2d &meter, double radius) const
{
  const Eigen::Vector3d h = m_toPlane * meter.homogeneous();
  return std::all_of(m_steps.begin(), m_steps.end(), [&](const Eigen::Vector3d &step) {
    const Eigen::Vector3d k = h + step;
    return k.head<2>().squaredNorm() < radius * radius * k.z() * k.z();
  });
}

// Derivative of the place on the plane by the pixel; h: that place, homogeneous.
Eigen::Matrix2d BlurredPrint::byPixelAt(const Eigen::Vector3d &h) const
{
  const Eigen::Vector2d center = h.head<2>() / h.z();
  return (m_toPlane.topLeftCorner<2, 2>() - center * m_toPlane.bottomLeftCorner<1, 2>()) / h.z() * m_meterPerPixel;
}

// Squared width of a ramp on the print, in each direction.
Eigen::Matrix2d BlurredPrint::metricOf(const Eigen::Matrix2d &byPixel) const
{
  const double width = rampPerSigma * m_sigma; // pixels
  return width * width * byPixel * byPixel.transpose();
}

BlurredPrint::Spot BlurredPrint::spotAt(double x, double y, const Eigen::Matrix2d &metric) const
{
  Spot spot;
  spot.x = std::abs(x) + std::abs(y) < leastRadius ? leastRadius : x;
  spot.y = y;
  const double squared = spot.x * spot.x + y * y;
  spot.r = std::sqrt(squared);
  // Width of a ramp across the radius: that of the blur on the print in the direction (x, y) / r.
  const double along = metric(0, 0) * spot.x * spot.x + 2. * metric(0, 1) * spot.x * y + metric(1, 1) * y * y;
  spot.perWidth = spot.r / std::sqrt(along);
  spot.outer = (1. - spot.r) * spot.perWidth;
  spot.edge = (m_layout.ringInner - spot.r) * spot.perWidth;
  spot.rim = (m_layout.codeOuter - spot.r) * spot.perWidth;
  spot.hub = (m_layout.codeInner - spot.r) * spot.perWidth;
  spot.track = m_sectors > 0 ? ramp(spot.rim) - ramp(spot.hub) : 0.;
  if (spot.track <= 0.) {
    return spot;
  }
  const double perSector = m_sectors / (2. * M_PI);
  const double across = metric(0, 0) * y * y - 2. * metric(0, 1) * spot.x * y + metric(1, 1) * spot.x * spot.x;
  spot.angular = std::min(std::sqrt(across) / squared * perSector, 1.);
  double place = std::atan2(y, spot.x) * perSector;
  place += place < 0. ? m_sectors : 0.;
  spot.sector = std::min(static_cast<int>(place), m_sectors - 1);
  spot.inside = place - spot.sector;
  spot.before = 1. - ramp(spot.inside / spot.angular);
  spot.after = 1. - ramp((1. - spot.inside) / spot.angular);
  return spot;
}

void BlurredPrint::see(const Eigen::Vector2d &meter, PrintParts &shares) const
{
  const Eigen::Vector3d h = m_toPlane * meter.homogeneous();
  const Eigen::Matrix2d metric = metricOf(byPixelAt(h));
  shares.ring = 0.;
  std::fill_n(shares.sector.begin(), m_sectors, 0.);
  const auto sectorAt = [&shares](int sector) -> double & { return shares.sector[static_cast<std::size_t>(sector)]; };
  const double share = 1. / static_cast<double>(m_steps.size());
  for (const Eigen::Vector3d &step : m_steps) {
    const double perZ = 1. / (h.z() + step.z());
    const Spot spot = spotAt((h.x() + step.x()) * perZ, (h.y() + step.y()) * perZ, metric);
    shares.ring += share * (ramp(spot.outer) - ramp(spot.edge));
    if (spot.track > 0.) {
      const double part = share * spot.track;
      sectorAt(spot.sector) += part * (1. - spot.before - spot.after);
      sectorAt(before(spot.sector)) += part * spot.before;
      sectorAt(after(spot.sector)) += part * spot.after;
    }
  }
}

// Velocity of the print's point q under each part of the pose's twist.
BlurredPrint::Velocities BlurredPrint::velocitiesAt(const Eigen::Vector2d &q) const
{
  const Eigen::Vector2d slant = (q - m_eye.head<2>()) / -m_eye.z();
  Velocities velocities;
  velocities << -1., 0., slant.x(), q.y() * slant.x(), -q.x() * slant.x(), q.y(), //
      0., -1., slant.y(), q.y() * slant.y(), -q.x() * slant.y(), -q.x();
  return velocities;
}

// By what these change what the print's metric makes of a direction d there, G' d, G the derivative of the velocity by
// q.
BlurredPrint::Velocities BlurredPrint::strainsAt(const Eigen::Vector2d &q, const Eigen::Vector2d &d) const
{
  const double perDepth = 1. / -m_eye.z();
  const double along = perDepth * (q - m_eye.head<2>()).dot(d);
  Velocities strains = Velocities::Zero();
  strains.col(2) = perDepth * d;
  strains.col(3) = perDepth * q.y() * d + Eigen::Vector2d(0., along);
  strains.col(4) = -perDepth * q.x() * d - Eigen::Vector2d(along, 0.);
  strains.col(5) << -d.y(), d.x();
  return strains;
}

// How what a spot sees changes as it moves and as ramps become wider.
BlurredPrint::SpotSlopes BlurredPrint::slopesOf(const Spot &spot, const PrintParts &darkness) const
{
  SpotSlopes slopes;
  const auto across = [&](double inner, double outer, double black) { // between two circles, where it is so dark
    slopes.byRadius += black * spot.perWidth * (slopeOfRamp(inner) - slopeOfRamp(outer));
    slopes.byWidth += black * (slopeOfRamp(inner) * inner - slopeOfRamp(outer) * outer);
  };
  across(spot.edge, spot.outer, darkness.ring);
  if (spot.track > 0.) {
    const auto darknessOf = [&darkness](int sector) { return darkness.sector[static_cast<std::size_t>(sector)]; };
    const double here = darknessOf(spot.sector);
    const double toBefore = darknessOf(before(spot.sector)) - here;
    const double toAfter = darknessOf(after(spot.sector)) - here;
    across(spot.hub, spot.rim, here + toBefore * spot.before + toAfter * spot.after);
    const double since = spot.inside / spot.angular;
    const double until = (1. - spot.inside) / spot.angular;
    const double fromBefore = spot.track * toBefore * slopeOfRamp(since);
    const double fromAfter = spot.track * toAfter * slopeOfRamp(until);
    slopes.byAngle = m_sectors / (2. * M_PI) / spot.angular * (fromAfter - fromBefore);
    slopes.byAngularWidth = spot.angular < 1. ? fromBefore * since + fromAfter * until : 0.;
  }
  return slopes;
}

DarknessSlopes BlurredPrint::slopesAt(const Eigen::Vector2d &meter, const PrintParts &darkness) const
{
  const Eigen::Vector3d h = m_toPlane * meter.homogeneous();
  const Eigen::Vector2d center = h.head<2>() / h.z();
  const Eigen::Matrix2d metric = metricOf(byPixelAt(h));
  DarknessSlopes slopes;
  for (std::size_t k = 0; k < m_steps.size(); ++k) {
    const Eigen::Vector3d there = h + m_steps[k];
    const Spot spot = spotAt(there.x() / there.z(), there.y() / there.z(), metric);
    const SpotSlopes bySpot = slopesOf(spot, darkness);
    if (bySpot.isFlat()) {
      continue;
    }
    const Eigen::Vector2d q(spot.x, spot.y);
    const Eigen::Vector2d turned(-spot.y, spot.x);
    const double perSquare = 1. / (spot.r * spot.r);
    // The logarithm of a ramp's width across the radius is that of sqrt(q' M q) / r, M the metric; along the circle, as
    // an angle, of sqrt(t' M t) / r^2, t = q turned by a right angle.
    const Eigen::Vector2d radial = metric * q / q.dot(metric * q);
    const Eigen::Vector2d tangential = metric * turned / turned.dot(metric * turned);
    const Eigen::Vector2d byPlace =
        bySpot.byRadius / spot.r * q + bySpot.byAngle * perSquare * turned + bySpot.byWidth * (radial - perSquare * q) +
        bySpot.byAngularWidth * (Eigen::Vector2d(tangential.y(), -tangential.x()) - 2. * perSquare * q);
    slopes.byTwist += velocitiesAt(q).transpose() * byPlace;
    slopes.byTwist += bySpot.byWidth * strainsAt(center, q).transpose() * radial;
    slopes.byTwist += bySpot.byAngularWidth * strainsAt(center, turned).transpose() * tangential;
    const Eigen::Vector2d inPixels = byPixelAt(there).transpose() * byPlace;
    const double bySigma = bySpot.byWidth + bySpot.byAngularWidth; // by its logarithm
    if (m_isDisc) {
      slopes.byDisc += inPixels.dot(m_byBlur[k]) + bySigma * m_sigmaByBlur.x();
    }
    else {
      slopes.byMotion += m_byBlur[k].cwiseProduct(inPixels) + bySigma * m_sigmaByBlur;
    }
  }
  const double share = 1. / static_cast<double>(m_steps.size());
  slopes.byTwist *= share;
  slopes.byMotion *= share;
  slopes.byDisc *= share;
  return slopes;
}
} // namespace circle_marker
END_VISP_NAMESPACE
