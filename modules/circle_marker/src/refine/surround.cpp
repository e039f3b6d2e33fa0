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
 * What lies beyond a marker's quiet zone.
 */

#include "refine/surround.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "refine/corners.h"
#include "support/bilinear.h"
#include "support/normal_distribution.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Looks in each direction: from where the blur of the quiet zone's end has gone, to a seventieth, a pixel apart.
constexpr unsigned int looks = 4;
constexpr double clearOfBlur = 2.2; // standard deviations
// Where the square is looked for, in units of half of its width: its corners are at 1.41.
constexpr std::array<double, 4> sampleExtents = {{1.07, 1.14, 1.21, 1.28}};
// Angles of the square that are tried, 5 degrees apart: each within reach of the best that lies between them.
constexpr int squareAngles = 18;
// Then that is halved so often: to 0.16 degrees, which moves the square's corners by 0.5 % of the radius.
constexpr int angleHalvings = 5;

// Samples of the image around a marker, between the sides of a square sheet and its corners.
class SheetSamples
{
public:
  SheetSamples(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane &plane, double outermost)
      : m_outermost(outermost)
  {
    const double middle = 0.5 * (sampleExtents.front() + sampleExtents.back());
    double outward = 0.; // how much brighter it becomes that way
    for (unsigned int k = 0; k < Surround::directions; ++k) {
      const double direction = 2. * M_PI * k / Surround::directions;
      for (const double extent : sampleExtents) {
        const Eigen::Vector2d q = extent * outermost * Eigen::Vector2d(std::cos(direction), std::sin(direction));
        const Eigen::Vector2d p = camera.toPixel(plane.project(q));
        if (const auto grey = bilinear(I, p)) {
          const ModelPixel pixel = {camera.toMeter(p), camera.meterPerPixel(p)};
          m_samples[m_count++] = {planePoint(pixel, plane), *grey};
          m_mean += *grey;
          outward += (extent - middle) * *grey;
        }
      }
    }
    m_mean /= std::max(static_cast<double>(m_count), 1.);
    m_sign = outward > 0. ? -1. : 1.;
  }

  // How much of the samples' variance a square at this angle explains, beyond whose sides lies what is seen farther
  // out, darker or brighter: its square root, times a constant. A square that is off by 45 degrees explains as much
  // with the other sign.
  double score(double angle, double blur) const
  {
    PaperEnd paper;
    paper.shape = PaperShape::SQUARE;
    paper.extent = m_outermost;
    paper.angle = angle;
    double sum = 0., squares = 0., product = 0.;
    for (std::size_t i = 0; i < m_count; ++i) {
      const double share = shareBeyond(m_samples[i].point, paper, blur).share;
      sum += share;
      squares += share * share;
      product += m_sign * share * (m_mean - m_samples[i].grey);
    }
    const double variance = squares - sum * sum / static_cast<double>(m_count);
    return variance > 0. ? product / std::sqrt(variance) : 0.;
  }

private:
  struct Sample
  {
    PlanePoint point;
    double grey;
  };
  std::array<Sample, Surround::directions * sampleExtents.size()> m_samples;
  std::size_t m_count = 0;
  double m_mean = 0.;
  double m_sign = 1.; // -1 where the ground is brighter than the paper
  double m_outermost;
};
} // namespace

unsigned int Surround::directionOf(const Eigen::Vector2d &q)
{
  const double turns = std::atan2(q.y(), q.x()) / (2. * M_PI);
  return static_cast<unsigned int>(std::lround((turns + 1.) * directions)) % directions;
}

const Ground &Surround::toward(unsigned int direction)
{
  if (!m_isLookedAt[direction]) {
    m_grounds[direction] = look(direction);
    m_isLookedAt[direction] = true;
  }
  return m_grounds[direction];
}

Ground Surround::look(unsigned int direction) const
{
  const double angle = 2. * M_PI * direction / directions;
  const Eigen::Vector2d q(std::cos(angle), std::sin(angle));
  // Outward from the paper's end, on the plane: the end's normal.
  Eigen::Vector2d out = q;
  double scale = 1.;
  if (m_paper.shape == PaperShape::SQUARE) {
    const Eigen::Vector2d along = m_paper.alongAxes(q);
    Eigen::Index side = 0;
    scale = along.cwiseAbs().maxCoeff(&side);
    out = std::copysign(1., along[side]) * m_paper.axis(side);
  }
  const Eigen::Vector2d end = m_camera.toPixel(m_plane.project(m_paper.extent / scale * q));
  // And in the image: at a right angle to the end as it is seen. Aslant the looks would be nearer to it than they are
  // long, and see paper by the blur.
  const PlanePoint point = planePoint({m_camera.toMeter(end), m_camera.meterPerPixel(end)}, m_plane);
  const Eigen::Vector2d outward = (point.byPixel.transpose() * out).normalized();
  double sum = 0., squares = 0.;
  bool isInside = true;
  for (unsigned int i = 0; i < looks && isInside; ++i) {
    const Eigen::Vector2d p = end + (clearOfBlur * m_blur + i) * outward;
    const auto grey = bilinear(m_image, p);
    isInside = grey.has_value();
    if (isInside) {
      sum += *grey;
      squares += *grey * *grey;
    }
  }
  const double mean = sum / looks;
  return {static_cast<float>(mean), isInside
                                        ? static_cast<float>(std::sqrt(std::max(squares / looks - mean * mean, 0.)))
                                        : std::numeric_limits<float>::infinity()};
}

ShareBeyond shareBeyond(const PlanePoint &point, const PaperEnd &paper, double blur)
{
  const NormalDistribution &normal = NormalDistribution::instance();
  if (paper.shape == PaperShape::ROUND) {
    const Eigen::Vector2d fromCenter = point.q - paper.center;
    const double radius = fromCenter.norm();
    const double gradient = (point.byPixel.transpose() * (fromCenter / radius)).norm();
    const auto beyond = normal.at((radius - paper.extent) / (gradient * blur));
    return {beyond.cumulative, beyond.density / blur};
  }
  const Eigen::Vector2d q = paper.alongAxes(point.q - paper.center);
  const Eigen::Vector2d byU = paper.alongAxes(point.byPixel.col(0));
  const Eigen::Vector2d byV = paper.alongAxes(point.byPixel.col(1));
  const double perX = 1. / std::hypot(byU.x(), byV.x());
  const double perY = 1. / std::hypot(byU.y(), byV.y());
  const double a = (paper.extent - std::abs(q.x())) * perX / blur;
  const double b = (paper.extent - std::abs(q.y())) * perY / blur;
  const auto insideX = normal.at(a);
  const auto insideY = normal.at(b);
  double inside = insideX.cumulative * insideY.cumulative;
  double byDistance = insideX.density * insideY.cumulative + insideY.density * insideX.cumulative;
  const double density = insideX.density * insideY.density;
  if (density >= leastPaperCorner) { // aslant a corner is not a right angle
    const double rho = std::copysign(1., q.x() * q.y()) * (byU.x() * byU.y() + byV.x() * byV.y()) * perX * perY;
    const auto corner = cornerOf(a, b, density, rho, mostCornerTerms);
    inside += corner.value;
    byDistance += corner.byA + corner.byB;
  }
  return {1. - inside, byDistance / blur};
}

double squareAngleOf(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane &plane,
                     double outermost, double blur)
{
  const SheetSamples samples(I, camera, plane, outermost);
  double best = 0., bestScore = 0.;
  const auto attempt = [&](double angle) {
    const double score = samples.score(angle, blur);
    if (score > bestScore) {
      best = angle;
      bestScore = score;
    }
  };
  double apart = 0.5 * M_PI / squareAngles;
  for (int k = 0; k < squareAngles; ++k) {
    attempt(apart * k);
  }
  for (int halving = 0; halving < angleHalvings && bestScore > 0.; ++halving) {
    apart *= 0.5;
    const double middle = best;
    attempt(middle - apart);
    attempt(middle + apart);
  }
  return best;
}
} // namespace circle_marker
END_VISP_NAMESPACE
