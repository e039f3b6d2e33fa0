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
 * A coded marker seen through a strong blur: its pose, the blur and its code together.
 */

#include "decode/blurred_marker.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/LU>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Blur of a sharp picture, lens 0.75 and pixel area 0.29, pixels.
constexpr double commonBlur = 0.8;
// Points of a line of motion; rings of points of a disc, beside its centre, with 6 and 12 points.
constexpr int linePoints = 9;
constexpr int discRings = 2;
// Below this radius of the disc, or length of the way, pixels, the kernel is a point.
constexpr double leastKernel = 0.3;
// Weight, in samples, that holds a sector to the middle between black and white: less than a tenth of a sample's own.
constexpr double sectorPrior = 0.05;
// Share of the quiet zone that samples may see.
constexpr double seenQuietZone = 0.9;
// Steps by which derivatives are taken: radii and rad, and pixels. Small: the depth is a difference of things that are
// known a hundred times better, and the second derivative's share of a step of 1e-3 hides its slope.
constexpr double poseStep = 1e-5;
constexpr double blurStep = 5e-4;
// What is left between model and image is the model's error more than noise, and much the same in neighbouring samples:
// the information of about so many counts once, of a plain ring, which the model's errors shift as a whole, of more.
// The numbers are guesses; bench-circle-marker --hardships has what they are worth.
constexpr double coherenceOfCode = 4.;
constexpr double coherenceOfRing = 16.;

// Share of what lies below an edge at \e distance (positive: inside), in units of the width of its ramp.
double ramp(double distance)
{
  return std::clamp(distance + 0.5, 0., 1.);
}

void move(const Eigen::Matrix<double, 6, 1> &twist, MarkerPlane &plane)
{
  plane.center += plane.radius * (plane.rotation * twist.head<3>());
  const double angle = twist.tail<3>().norm();
  if (angle > 0.) {
    plane.rotation = plane.rotation * Eigen::AngleAxisd(angle, twist.tail<3>() / angle).toRotationMatrix();
  }
}
} // namespace

void BlurredMarker::setPose(const MarkerPlane &plane, const ImageBlur &blur)
{
  const Eigen::Vector3d normal = plane.rotation.col(2);
  const double depth = normal.dot(plane.center);
  for (int row = 0; row < 2; ++row) {
    const Eigen::Vector3d axis = plane.rotation.col(row);
    m_toPlane.row(row) = (depth * axis - axis.dot(plane.center) * normal).transpose() / plane.radius;
  }
  m_toPlane.row(2) = normal.transpose();
  m_kernel.clear();
  double variance = commonBlur * commonBlur + (m_block * m_block - 1.) / 12.;
  if (blur.disc > leastKernel) {
    m_kernel.emplace_back(0., 0.);
    int count = 1;
    for (int ring = 1; ring <= discRings; ++ring) {
      const int points = 6 * ring;
      // Each ring of points stands for a ring of the disc with its share of the area.
      const double inner = static_cast<double>(count) / 19.;
      const double outer = static_cast<double>(count + points) / 19.;
      const double radius = blur.disc * std::sqrt(0.5 * (inner + outer));
      for (int i = 0; i < points; ++i) {
        const double angle = 2. * M_PI * (i + 0.5 * ring) / points;
        m_kernel.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
      }
      count += points;
    }
    variance += blur.disc * blur.disc / (4. * 19.);
  }
  else if (blur.motion.norm() > leastKernel) {
    for (int i = 0; i < linePoints; ++i) {
      m_kernel.push_back(((i + 0.5) / linePoints - 0.5) * blur.motion);
    }
    variance += blur.motion.squaredNorm() / (24. * linePoints * linePoints);
  }
  else {
    m_kernel.emplace_back(0., 0.);
  }
  m_steps.clear();
  for (Eigen::Vector2d &point : m_kernel) {
    point = m_meterPerPixel * point;
    m_steps.emplace_back(m_toPlane.leftCols<2>() * point);
  }
  m_sigma = std::sqrt(variance);
}

void BlurredMarker::see(const BlurredSample &sample, Point &point) const
{
  constexpr double rampPerSigma = 3.46; // a ramp of this width has a standard deviation of 1
  constexpr double leastRadius = 1e-3;  // nearer to the centre there is nothing, and no direction
  const Eigen::Vector3d h = m_toPlane * sample.meter.homogeneous();
  const Eigen::Vector2d center = h.head<2>() / h.z();
  const Eigen::Matrix2d byPixel =
      (m_toPlane.topLeftCorner<2, 2>() - center * m_toPlane.bottomLeftCorner<1, 2>()) / h.z() * m_meterPerPixel;
  const double width = rampPerSigma * m_sigma; // pixels
  const Eigen::Matrix2d metric = width * width * byPixel * byPixel.transpose();
  point.ring = 0.;
  std::fill_n(point.sector.begin(), m_sectors, 0.);
  const double share = 1. / static_cast<double>(m_kernel.size());
  const double perSector = m_sectors / (2. * M_PI);
  for (const Eigen::Vector3d &step : m_steps) {
    const double perZ = 1. / (h.z() + step.z());
    double x = (h.x() + step.x()) * perZ;
    const double y = (h.y() + step.y()) * perZ;
    x = std::abs(x) + std::abs(y) < leastRadius ? leastRadius : x;
    const double squared = x * x + y * y;
    const double r = std::sqrt(squared);
    // Width of a ramp across the radius: that of the blur on the print in the direction (x, y) / r.
    const double along = metric(0, 0) * x * x + 2. * metric(0, 1) * x * y + metric(1, 1) * y * y;
    const double perWidth = r / std::sqrt(along);
    point.ring += share * (ramp((1. - r) * perWidth) - ramp((m_layout.ringInner - r) * perWidth));
    const double track = ramp((m_layout.codeOuter - r) * perWidth) - ramp((m_layout.codeInner - r) * perWidth);
    if (track <= 0.) {
      continue;
    }
    const double across = metric(0, 0) * y * y - 2. * metric(0, 1) * x * y + metric(1, 1) * x * x;
    const double angular = std::min(std::sqrt(across) / squared * perSector, 1.); // of a sector
    double place = std::atan2(y, x) * perSector;
    place += place < 0. ? m_sectors : 0.;
    const int sector = std::min(static_cast<int>(place), m_sectors - 1);
    const double inside = place - sector;
    const double before = 1. - ramp(inside / angular);
    const double after = 1. - ramp((1. - inside) / angular);
    point.sector[static_cast<std::size_t>(sector)] += share * track * (1. - before - after);
    point.sector[static_cast<std::size_t>((sector + m_sectors - 1) % m_sectors)] += share * track * before;
    point.sector[static_cast<std::size_t>((sector + 1) % m_sectors)] += share * track * after;
  }
}

// Whether the deadline has passed, asked every few samples: each is 9 or 19 points of the print, some microseconds.
bool BlurredMarker::isOver(Eigen::Index sample) const
{
  constexpr Eigen::Index samplesAtOnce = 64;
  return sample % samplesAtOnce == 0 && m_deadline.hasPassed();
}

double BlurredMarker::darkness(const BlurredSample &sample, const Eigen::VectorXd &linear) const
{
  Point point;
  see(sample, point);
  double sum = linear[BlurredFit::ringAt] * point.ring;
  for (int k = 0; k < m_sectors; ++k) {
    sum += linear[BlurredFit::firstSector + k] * point.sector[static_cast<std::size_t>(k)];
  }
  return sum;
}

void BlurredMarker::select(const MarkerPlane &plane, const ImageBlur &blur, std::size_t count)
{
  m_samples.clear();
  m_center = m_camera.toPixel(plane.project(Eigen::Vector2d::Zero()));
  m_meterPerPixel = m_camera.meterPerPixel(m_center);
  Eigen::Vector2d least = m_center;
  Eigen::Vector2d most = m_center;
  const double radius = 1. + seenQuietZone * m_layout.quietZone;
  for (int i = 0; i < 16; ++i) {
    const double angle = 2. * M_PI * i / 16.;
    const Eigen::Vector2d p =
        m_camera.toPixel(plane.project(radius * Eigen::Vector2d(std::cos(angle), std::sin(angle))));
    least = least.cwiseMin(p);
    most = most.cwiseMax(p);
  }
  m_extent = 0.5 * (most - least).maxCoeff();
  const Eigen::Vector2d size = most - least;
  const double area = 0.785 * size.x() * size.y();
  const int block = std::max(1, static_cast<int>(std::lround(std::sqrt(area / static_cast<double>(count)))));
  m_block = block;
  setPose(plane, blur);
  const int left = std::max(0, static_cast<int>(std::ceil(least.x())));
  const int top = std::max(0, static_cast<int>(std::ceil(least.y())));
  const int right = std::min(static_cast<int>(m_image.getWidth()), static_cast<int>(most.x()) + 1);
  const int bottom = std::min(static_cast<int>(m_image.getHeight()), static_cast<int>(most.y()) + 1);
  for (int y = top; y + block <= bottom && !m_deadline.hasPassed(); y += block) {
    for (int x = left; x + block <= right; x += block) {
      BlurredSample sample;
      sample.pixel = Eigen::Vector2d(x + 0.5 * (block - 1), y + 0.5 * (block - 1));
      sample.meter = m_camera.toMeter(sample.pixel);
      const bool isInside = std::all_of(m_kernel.begin(), m_kernel.end(), [&](const Eigen::Vector2d &offset) {
        const Eigen::Vector3d k = m_toPlane * (sample.meter + offset).homogeneous();
        return k.head<2>().squaredNorm() < radius * radius * k.z() * k.z();
      });
      if (!isInside) {
        continue;
      }
      int sum = 0;
      for (int v = y; v < y + block; ++v) {
        for (int u = x; u < x + block; ++u) {
          sum += m_image[static_cast<unsigned int>(v)][static_cast<unsigned int>(u)];
        }
      }
      sample.grey = static_cast<double>(sum) / (block * block);
      m_samples.push_back(sample);
    }
  }
}

void BlurredMarker::solve(BlurredFit &fit)
{
  setPose(fit.plane, fit.blur);
  const int columns = BlurredFit::firstSector + m_sectors;
  const auto rows = static_cast<Eigen::Index>(m_samples.size());
  Eigen::MatrixXd design(rows, columns);
  Eigen::VectorXd greys(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    if (isOver(i)) {
      fit.squares = HUGE_VAL;
      return;
    }
    const BlurredSample &sample = m_samples[static_cast<std::size_t>(i)];
    Point point;
    see(sample, point);
    const Eigen::Vector2d offset = (sample.pixel - m_center) / m_extent;
    design(i, 0) = 1.;
    design(i, 1) = offset.x();
    design(i, 2) = offset.y();
    design(i, BlurredFit::ringAt) = -point.ring;
    for (int k = 0; k < m_sectors; ++k) {
      design(i, BlurredFit::firstSector + k) = -point.sector[static_cast<std::size_t>(k)];
    }
    greys[i] = sample.grey;
  }
  fit.matrix = Eigen::MatrixXd::Zero(columns, columns);
  fit.matrix.selfadjointView<Eigen::Lower>().rankUpdate(design.transpose());
  fit.matrix = Eigen::MatrixXd(fit.matrix.selfadjointView<Eigen::Lower>());
  fit.right = design.transpose() * greys;
  fit.total = greys.squaredNorm();
  fit.samples = m_samples.size();
  Eigen::MatrixXd held = fit.matrix;
  for (int k = BlurredFit::firstSector; k < columns; ++k) { // sector = ring / 2
    held(k, k) += sectorPrior;
    held(k, BlurredFit::ringAt) -= 0.5 * sectorPrior;
    held(BlurredFit::ringAt, k) -= 0.5 * sectorPrior;
    held(BlurredFit::ringAt, BlurredFit::ringAt) += 0.25 * sectorPrior;
  }
  fit.linear = held.ldlt().solve(fit.right);
  fit.squares = (greys - design * fit.linear).squaredNorm();
  const Eigen::Matrix3d light = fit.matrix.topLeftCorner<3, 3>();
  fit.plain = fit.total - fit.right.head<3>().dot(light.ldlt().solve(fit.right.head<3>()));
  if (!(fit.linear[BlurredFit::ringAt] > 0.) || !std::isfinite(fit.squares)) {
    fit.squares = HUGE_VAL;
  }
}

BlurredFit BlurredMarker::changed(const BlurredFit &from, const Eigen::VectorXd &by, int poseSize) const
{
  BlurredFit to;
  to.plane = from.plane;
  to.blur = from.blur;
  Eigen::Matrix<double, 6, 1> twist = Eigen::Matrix<double, 6, 1>::Zero();
  twist.head(poseSize) = by.head(poseSize);
  move(twist, to.plane);
  if (from.blur.disc > 0.) {
    to.blur.disc = std::max(to.blur.disc + by[poseSize], 2. * leastKernel);
  }
  else {
    to.blur.motion += by.segment<2>(poseSize);
  }
  return to;
}

// False after the deadline.
bool BlurredMarker::linearise(const BlurredFit &fit, int poseSize, Eigen::MatrixXd &matrix, Eigen::VectorXd &right)
{
  const int moving = poseSize + (fit.blur.disc > 0. ? 1 : 2);
  const int columns = BlurredFit::firstSector + m_sectors;
  const auto rows = static_cast<Eigen::Index>(m_samples.size());
  Eigen::MatrixXd derivatives(rows, moving + columns);
  Eigen::VectorXd residuals(rows);
  Eigen::VectorXd here(rows);
  setPose(fit.plane, fit.blur);
  for (Eigen::Index i = 0; i < rows; ++i) {
    if (isOver(i)) {
      return false;
    }
    const BlurredSample &sample = m_samples[static_cast<std::size_t>(i)];
    Point point;
    see(sample, point);
    const Eigen::Vector2d offset = (sample.pixel - m_center) / m_extent;
    derivatives(i, moving) = 1.;
    derivatives(i, moving + 1) = offset.x();
    derivatives(i, moving + 2) = offset.y();
    derivatives(i, moving + BlurredFit::ringAt) = -point.ring;
    here[i] = fit.linear[BlurredFit::ringAt] * point.ring;
    for (int k = 0; k < m_sectors; ++k) {
      const double share = point.sector[static_cast<std::size_t>(k)];
      derivatives(i, moving + BlurredFit::firstSector + k) = -share;
      here[i] += fit.linear[BlurredFit::firstSector + k] * share;
    }
    residuals[i] = sample.grey - (fit.linear[0] + fit.linear[1] * offset.x() + fit.linear[2] * offset.y() - here[i]);
  }
  for (int k = 0; k < moving; ++k) {
    Eigen::VectorXd by = Eigen::VectorXd::Zero(moving);
    by[k] = k < poseSize ? poseStep : blurStep;
    const BlurredFit other = changed(fit, by, poseSize);
    setPose(other.plane, other.blur);
    for (Eigen::Index i = 0; i < rows; ++i) {
      if (isOver(i)) {
        return false;
      }
      derivatives(i, k) = (here[i] - darkness(m_samples[static_cast<std::size_t>(i)], fit.linear)) / by[k];
    }
  }
  matrix = Eigen::MatrixXd::Zero(moving + columns, moving + columns);
  matrix.selfadjointView<Eigen::Lower>().rankUpdate(derivatives.transpose());
  matrix = Eigen::MatrixXd(matrix.selfadjointView<Eigen::Lower>());
  for (int k = BlurredFit::firstSector; k < columns; ++k) {
    matrix(moving + k, moving + k) += sectorPrior;
  }
  right = derivatives.transpose() * residuals;
  return true;
}

void BlurredMarker::improve(BlurredFit &fit, int steps, bool movesSpin)
{
  constexpr int mostTrials = 4;
  constexpr double leastGain = 1e-4; // share of the squares, a twentieth of a sample's: less is the end
  const int poseSize = movesSpin ? 6 : 5;
  const int moving = poseSize + (fit.blur.disc > 0. ? 1 : 2);
  double damping = 1e-3;
  Eigen::MatrixXd matrix;
  Eigen::VectorXd right;
  double gain = 1.;
  for (int step = 0; step < steps && fit.squares < HUGE_VAL && gain > leastGain; ++step) {
    if (!linearise(fit, poseSize, matrix, right)) {
      return;
    }
    gain = 0.;
    for (int trial = 0; trial < mostTrials && gain == 0.; ++trial) {
      Eigen::MatrixXd damped = matrix;
      damped.diagonal().head(moving) *= 1. + damping;
      const Eigen::VectorXd by = damped.ldlt().solve(right);
      BlurredFit next = changed(fit, by, poseSize);
      const bool isVisible = by.allFinite() && next.plane.center.z() > 0.1 * next.plane.radius &&
                             next.plane.rotation.col(2).dot(next.plane.center) > 0.;
      if (isVisible) {
        solve(next);
      }
      if (next.squares < fit.squares) {
        gain = 1. - next.squares / fit.squares;
        fit = next;
        damping = std::max(0.1 * damping, 1e-6);
      }
      else {
        damping *= 10.;
      }
    }
  }
}

double BlurredMarker::coherence() const
{
  return m_sectors > 0 ? coherenceOfCode : coherenceOfRing;
}

Eigen::Matrix<double, 6, 6> BlurredMarker::covariance(const BlurredFit &fit)
{
  const int poseSize = m_sectors > 0 ? 6 : 5;
  Eigen::MatrixXd matrix;
  Eigen::VectorXd right;
  if (!linearise(fit, poseSize, matrix, right)) {
    return Eigen::Matrix<double, 6, 6>::Identity();
  }
  const double freedom = std::max(static_cast<double>(m_samples.size()) - static_cast<double>(matrix.rows()), 1.);
  const Eigen::MatrixXd inverse = matrix.ldlt().solve(Eigen::MatrixXd::Identity(matrix.rows(), matrix.cols()));
  Eigen::Matrix<double, 6, 6> result = Eigen::Matrix<double, 6, 6>::Zero();
  result.topLeftCorner(poseSize, poseSize) =
      coherence() * fit.squares / freedom * inverse.topLeftCorner(poseSize, poseSize);
  return result;
}
} // namespace circle_marker
END_VISP_NAMESPACE
