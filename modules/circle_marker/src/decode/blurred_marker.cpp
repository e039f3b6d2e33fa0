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

#include "pose/circle_bounds.h"
#include "support/pixel_box.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Weight, in samples, that holds a sector to the middle between black and white: less than a tenth of a sample's own.
constexpr double sectorPrior = 0.05;
// Share of the quiet zone that samples may see.
constexpr double seenQuietZone = 0.9;
// What is left between model and image is the model's error more than noise, and much the same in neighbouring samples:
// the information of about so many counts once, of a plain ring, which the model's errors shift as a whole, of more.
// The numbers are guesses; bench-circle-marker --hardships has what they are worth.
constexpr double coherenceOfCode = 4.;
constexpr double coherenceOfRing = 16.;
constexpr int largestBlock = 1 << 16; // pixels: more than an image has

void move(const Eigen::Matrix<double, 6, 1> &twist, MarkerPlane &plane)
{
  plane.center += plane.radius * (plane.rotation * twist.head<3>());
  const double angle = twist.tail<3>().norm();
  if (angle > 0.) {
    plane.rotation = plane.rotation * Eigen::AngleAxisd(angle, twist.tail<3>() / angle).toRotationMatrix();
  }
}
} // namespace

// Whether the deadline has passed, asked every few samples: each is 9 or 19 points of the print, some microseconds.
bool BlurredMarker::isOver(Eigen::Index sample) const
{
  constexpr Eigen::Index samplesAtOnce = 64;
  return sample % samplesAtOnce == 0 && m_deadline.hasPassed();
}

void BlurredMarker::select(const MarkerPlane &plane, const ImageBlur &blur, std::size_t count)
{
  m_samples.clear();
  m_center = m_camera.toPixel(plane.project(Eigen::Vector2d::Zero()));
  m_meterPerPixel = m_camera.meterPerPixel(m_center);
  const double radius = 1. + seenQuietZone * m_layout.quietZone;
  const auto [least, most] = boundsOfCircle(plane, m_camera, radius, 16);
  m_extent = 0.5 * (most - least).maxCoeff();
  const double area = M_PI_4 * (most - least).prod();
  const int block = std::max(1, pixelWithin(std::round(std::sqrt(area / static_cast<double>(count))), largestBlock));
  m_block = block;
  m_print.set(plane, blur, m_meterPerPixel, m_block);
  const int width = static_cast<int>(m_image.getWidth());
  const int height = static_cast<int>(m_image.getHeight());
  const int left = pixelWithin(std::ceil(least.x()), width);
  const int top = pixelWithin(std::ceil(least.y()), height);
  const int right = pixelWithin(std::floor(most.x()) + 1., width);
  const int bottom = pixelWithin(std::floor(most.y()) + 1., height);
  for (int y = top; y + block <= bottom && !m_deadline.hasPassed(); y += block) {
    for (int x = left; x + block <= right; x += block) {
      BlurredSample sample;
      sample.pixel = Eigen::Vector2d(x + 0.5 * (block - 1), y + 0.5 * (block - 1));
      sample.meter = m_camera.toMeter(sample.pixel);
      if (!m_print.isWithin(sample.meter, radius)) {
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
  m_print.set(fit.plane, fit.blur, m_meterPerPixel, m_block);
  const int columns = BlurredFit::firstSector + m_sectors;
  const auto rows = static_cast<Eigen::Index>(m_samples.size());
  Eigen::MatrixXd design(rows, columns);
  Eigen::VectorXd greys(rows);
  PrintParts shares;
  for (Eigen::Index i = 0; i < rows; ++i) {
    if (isOver(i)) {
      fit.squares = HUGE_VAL;
      return;
    }
    const BlurredSample &sample = m_samples[static_cast<std::size_t>(i)];
    m_print.see(sample.meter, shares);
    const Eigen::Vector2d offset = (sample.pixel - m_center) / m_extent;
    design(i, 0) = 1.;
    design(i, 1) = offset.x();
    design(i, 2) = offset.y();
    design(i, BlurredFit::ringAt) = -shares.ring;
    for (int k = 0; k < m_sectors; ++k) {
      design(i, BlurredFit::firstSector + k) = -shares.sector[static_cast<std::size_t>(k)];
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
    to.blur.disc = std::max(to.blur.disc + by[poseSize], 2. * BlurredPrint::leastKernel);
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
  m_print.set(fit.plane, fit.blur, m_meterPerPixel, m_block);
  PrintParts darkness;
  darkness.ring = fit.linear[BlurredFit::ringAt];
  for (int k = 0; k < m_sectors; ++k) {
    darkness.sector[static_cast<std::size_t>(k)] = fit.linear[BlurredFit::firstSector + k];
  }
  PrintParts shares;
  for (Eigen::Index i = 0; i < rows; ++i) {
    if (isOver(i)) {
      return false;
    }
    const BlurredSample &sample = m_samples[static_cast<std::size_t>(i)];
    m_print.see(sample.meter, shares);
    const Eigen::Vector2d offset = (sample.pixel - m_center) / m_extent;
    derivatives(i, moving) = 1.;
    derivatives(i, moving + 1) = offset.x();
    derivatives(i, moving + 2) = offset.y();
    derivatives(i, moving + BlurredFit::ringAt) = -shares.ring;
    for (int k = 0; k < m_sectors; ++k) {
      derivatives(i, moving + BlurredFit::firstSector + k) = -shares.sector[static_cast<std::size_t>(k)];
    }
    residuals[i] = sample.grey - derivatives.row(i).tail(columns).dot(fit.linear);
    const DarknessSlopes slopes = m_print.slopesAt(sample.meter, darkness);
    derivatives.row(i).head(poseSize) = -slopes.byTwist.head(poseSize).transpose();
    if (fit.blur.disc > 0.) {
      derivatives(i, poseSize) = -slopes.byDisc;
    }
    else {
      derivatives.row(i).segment<2>(poseSize) = -slopes.byMotion.transpose();
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
      if (by.allFinite() && next.plane.showsFront()) {
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
