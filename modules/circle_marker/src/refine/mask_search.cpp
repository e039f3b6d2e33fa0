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
 * The mask of a camera that sharpens, by how well it explains a whole marker.
 */

#include "refine/mask_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "refine/coarse_fits.h"
#include "refine/fit_starts.h"
#include "support/sensor_range.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// What a mask adds at the frequency of exp(-0.3 sigma^2), 0.77 rad a pixel, is its strength: there the masks that leave
// nearly the same image, narrow ones of a large amount and wide ones of a small one, are alike.
constexpr double ofStrength = 0.3;
// Masks that are one: widths, pixels, and amounts. A narrower one is a sharper lens, a wider one a veil of light.
constexpr double leastSigma = 0.5;
constexpr double mostSigma = 5.;
constexpr double mostAmount = 6.;
// Weak masks, amount and pixels: towards what sharpened an image one of them makes it likelier; that is the last one
// where a small marker was sharpened strongly.
constexpr std::array<UnsharpMask, 3> weakMasks = {{{0.2, 1.}, {0.15, 2.}, {0.5, 2.}}};
// Where the search begins, amount and pixels: what many cameras do; and if that does not explain the image, strong
// sharpening by wide masks, which is not seen behind weak narrow ones.
constexpr std::array<UnsharpMask, 4> starts = {{{0.5, 1.}, {0.45, 2.}, {1.4, 2.}, {3., 2.}}};
// Widths are tried in steps of this, ln.
constexpr double stepOfWidth = 0.35;
constexpr int mostSteps = 4;
// Rounds in which the parabola's vertex is tried; the last is when it promises less than this of the log-likelihood.
constexpr int mostRounds = 6;
constexpr double negligible = 0.1;
// Or when it is nearer to another trial than this share of a step of the width, and of what that is for the strength.
constexpr double leastStep = 0.1;
// What leaves no more than this factor of the noise is explained; else other starts are tried.
constexpr double mostLeft = 1.12;
// Up to so many where the marker is like none in the image as it is: it may be none.
constexpr std::size_t mostTrialsOfUnlike = 20;
// A mask leaves less than this share of the variance that none leaves, or there is none: any leaves some hundredths
// less of what has other reasons.
constexpr double clearlyLess = 0.97;
// What nothing tells: a width of one pixel or of two, ln; and a strength, share of itself. Standard deviations.
constexpr double widthOfCameras = 0.7;
constexpr double strengthOfCameras = 1.;

double attenuationOf(double sigma)
{
  return 1. - std::exp(-ofStrength * sigma * sigma);
}

double strengthOf(const UnsharpMask &mask)
{
  return mask.amount * attenuationOf(mask.sigma);
}

double mostStrengthOf(double lnSigma)
{
  return mostAmount * attenuationOf(std::exp(lnSigma));
}

// From one pose to another: of the centre, metres, and of the normal, as a rotation, rad. No mask turns a marker about
// its normal.
Eigen::Matrix<double, 6, 1> change(const MarkerPlane &from, const MarkerPlane &to)
{
  Eigen::Matrix<double, 6, 1> pose;
  pose << to.center * (from.radius / to.radius) - from.center, from.rotation.col(2).cross(to.rotation.col(2));
  return pose;
}

// Whether a pose leans as another one does, not to the other side.
bool isAlike(const MarkerPlane &plane, const MarkerPlane &other)
{
  const Eigen::Vector3d normal = plane.rotation.col(2);
  return normal.dot(other.rotation.col(2)) >= normal.dot(mirrored(other).rotation.col(2));
}
} // namespace

Eigen::Matrix<double, 6, 6> SearchedMask::doubtOf(const MarkerPlane &plane) const
{
  // A normal and that of the other pose, which leans to the other side of the line of sight s, turn as 2 s s^T - 1
  // says.
  const Eigen::Vector3d sight = pose.center.normalized();
  const Eigen::Matrix3d same = Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d turned = isAlike(plane, pose) ? same : 2. * sight * sight.transpose() - same;
  Eigen::Matrix<double, 6, 6> there = Eigen::Matrix<double, 6, 6>::Zero();
  there.topLeftCorner<3, 3>() = plane.radius / pose.radius * Eigen::Matrix3d::Identity();
  there.bottomRightCorner<3, 3>() = turned;
  return there * doubt * there.transpose();
}

MaskSearch::MaskSearch(const FittedPose &start, Known known, double noise, MeasureBehind measureBehind)
    : m_start(start.plane), m_known(known), m_noise(noise), m_measureBehind(std::move(measureBehind)),
      m_white(start.photometry.white), m_ink(m_white * (1. - start.photometry.contrast()))
{
  if (known != Known::NOTHING) {
    m_nearest = start;
    m_nearest->photometry.toneCurve.reset(); // it would stand for a part of a mask
  }
  if (start.photometry.toneCurve) {
    m_toned = start;
  }
}

std::optional<SearchedMask> MaskSearch::run()
{
  const double none = tryAt(Eigen::Vector2d::Zero());
  // In even light and without what is cut off it is none: no mask is why.
  const bool isNone = m_known != Known::NOTHING && !std::isfinite(none);
  if (isNone || (m_known == Known::POSE && !isLikelierBehindAny())) {
    return std::nullopt;
  }
  for (const UnsharpMask &start : starts) {
    searchFrom(start);
    if (isExplained() || isOver()) {
      break;
    }
  }
  const double rival = std::min(none, leftByTone());
  const Trial &best = m_trials[m_best];
  if (!isBetterThanNone() || best.left > clearlyLess * rival) {
    return std::nullopt;
  }
  SearchedMask found = result();
  found.gain = 0.5 * best.pixels * std::log(rival / best.left);
  return found;
}

void MaskSearch::searchFrom(const UnsharpMask &start)
{
  const double lnSigma = std::log(start.sigma);
  if (!searchStrength(strengthOf(start), lnSigma) || !isBetterThanNone()) {
    return;
  }
  searchWidth();
  const Eigen::Vector2d wide = m_trials[m_best].place;
  if (wide[1] != lnSigma) {
    searchStrength(wide[0], wide[1]);
    searchWidth();
  }
  searchBoth();
}

// Whether a weak mask makes the marker likelier. What is left of it may have many another reason.
bool MaskSearch::isLikelierBehindAny()
{
  return std::any_of(weakMasks.begin(), weakMasks.end(), [this](const UnsharpMask &mask) {
    return leftAt(strengthOf(mask), std::log(mask.sigma)) < m_trials[0].left;
  });
}

// What is left in the image as it is by the tone curve that was measured in it; HUGE_VAL if there was none.
double MaskSearch::leftByTone() const
{
  const auto toned = m_toned ? m_measureBehind(maskAt(Eigen::Vector2d::Zero()), &*m_toned) : std::nullopt;
  return toned ? std::pow(unexplainedBy(toned->fit), 2.) : HUGE_VAL;
}

// Whether the best mask leaves hardly more than noise.
bool MaskSearch::isExplained() const
{
  const Trial &best = m_trials[m_best];
  return best.noise < mostLeft * std::max(m_noise / (1. + maskAt(best.place).amount), quantisation);
}

bool MaskSearch::isBetterThanNone() const
{
  return m_trials[m_best].left < clearlyLess * m_trials[0].left;
}

bool MaskSearch::isOver() const
{
  const bool mayBeNone = !m_trials.empty() && !std::isfinite(m_trials[0].left);
  return m_trials.size() >= (mayBeNone ? mostTrialsOfUnlike : mostTrials);
}

UnsharpMask MaskSearch::maskAt(const Eigen::Vector2d &place) const
{
  UnsharpMask mask;
  mask.sigma = std::exp(place[1]);
  mask.amount = place[0] / attenuationOf(mask.sigma);
  mask.white = m_white;
  mask.ink = m_ink;
  return mask;
}

// What is left behind a mask, whether it was tried before or not: grey levels^2.
double MaskSearch::leftAt(double strength, double lnSigma)
{
  const Eigen::Vector2d place(strength, lnSigma);
  const auto *const known =
      std::find_if(m_trials.begin(), m_trials.end(), [&](const Trial &trial) { return trial.place == place; });
  return known != m_trials.end() ? known->left : tryAt(place);
}

// From where it was measured behind the best mask; with the noise that is as likely: fits that weigh pixels by another
// noise leave more or less, by some per cent, which hides what masks do.
std::optional<FitBehind> MaskSearch::measureBehind(const UnsharpMask &mask) const
{
  if (!m_nearest) {
    return m_measureBehind(mask, nullptr);
  }
  FittedPose nearest = *m_nearest;
  if (!m_trials.empty()) {
    nearest.noise *= std::exp(lnGainOf(maskAt(m_trials[m_best].place)) - lnGainOf(mask));
  }
  return m_measureBehind(mask, &nearest);
}

// The same of one that was not; HUGE_VAL if there were trials enough.
double MaskSearch::tryAt(const Eigen::Vector2d &place)
{
  if (isOver()) {
    return HUGE_VAL;
  }
  Trial trial;
  trial.place = place;
  const UnsharpMask mask = maskAt(trial.place);
  const auto behind = measureBehind(mask);
  if (!behind) {
    m_trials.push_back(trial);
    return HUGE_VAL;
  }
  const FittedPose &fit = behind->fit;
  trial.pixels = static_cast<double>(behind->pixels) / fit.sharing;
  trial.noise = fit.noise;
  trial.left = std::pow(unexplainedBy(fit) * std::exp(lnGainOf(mask)), 2.);
  if (!m_nearest) { // the outline's pose was none of both
    m_start = fit.plane;
  }
  if (isAlike(fit.plane, m_start)) {
    trial.pose = change(m_start, fit.plane);
  }
  m_trials.push_back(trial);
  if (!m_nearest || trial.left < m_trials[m_best].left) {
    m_best = m_trials.size() - 1;
    m_nearest = fit;
    m_nearest->photometry.toneCurve.reset();
    m_white = fit.photometry.white;
    m_ink = m_white * (1. - fit.photometry.contrast());
  }
  return trial.left;
}

// The best strength of a width. False if none is better than no mask.
bool MaskSearch::searchStrength(double strength, double lnSigma)
{
  const double most = mostStrengthOf(lnSigma);
  strength = std::min(strength, 0.5 * most);
  const double none = m_trials[0].left;
  double at = leftAt(strength, lnSigma);
  if (at >= none) {
    strength /= 3.;
    at = leftAt(strength, lnSigma);
  }
  if (at >= none) {
    return false;
  }
  double below = none;
  double twice = leftAt(2. * strength, lnSigma);
  double from = 0.;
  while (twice < at && 4. * strength <= most) {
    below = at;
    at = twice;
    from = strength;
    strength *= 2.;
    twice = leftAt(2. * strength, lnSigma);
  }
  // The vertex of the parabola through three values, by divided differences.
  const double up = (twice - at) / strength;
  const double down = (at - below) / (strength - from);
  const double curvature = (up - down) / (2. * strength - from); // half of it
  if (std::isfinite(curvature) && curvature > 0.) {
    const double vertex = 0.5 * (strength + from) - 0.5 * down / curvature;
    leftAt(std::clamp(vertex, 0.5 * (from + strength), 1.5 * strength), lnSigma);
  }
  return true;
}

// Narrower and wider masks of the best strength.
void MaskSearch::searchWidth()
{
  const Trial start = m_trials[m_best];
  for (const double direction : {-1., 1.}) {
    double before = start.left;
    for (int step = 1; step <= mostSteps; ++step) {
      const double lnSigma = start.place[1] + direction * step * stepOfWidth;
      if (lnSigma < std::log(leastSigma) || lnSigma > std::log(mostSigma) || start.place[0] > mostStrengthOf(lnSigma)) {
        break;
      }
      const double left = leftAt(start.place[0], lnSigma);
      if (left >= before) {
        break;
      }
      before = left;
    }
  }
}

void MaskSearch::searchBoth()
{
  for (int round = 0; round < mostRounds && !isOver(); ++round) {
    const auto there = surface();
    if (!there) {
      return;
    }
    const Trial &best = m_trials[m_best];
    // As far as the next trials at most.
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(there->curvature);
    const Eigen::Vector2d values = axes.eigenvalues().cwiseMax(1e-3 * best.left);
    const Eigen::Vector2d along = axes.eigenvectors().transpose() * there->slope;
    Eigen::Vector2d step = -axes.eigenvectors() * along.cwiseQuotient(values);
    const double promised = -(there->slope.dot(step) + 0.5 * step.dot(there->curvature * step));
    step = step.cwiseMax(-1.).cwiseMin(1.);
    Eigen::Vector2d place = best.place + step.cwiseProduct(units());
    place[1] = std::clamp(place[1], std::log(leastSigma), std::log(mostSigma));
    place[0] = std::min(place[0], mostStrengthOf(place[1]));
    const auto isNear = [&](const Trial &trial) {
      return (place - trial.place).cwiseQuotient(units()).norm() < leastStep;
    };
    if (0.5 * best.pixels * promised / best.left < negligible ||
        std::any_of(m_trials.begin(), m_trials.end(), isNear)) {
      return;
    }
    tryAt(place);
  }
}

// Steps of the coordinates about the best trial.
Eigen::Vector2d MaskSearch::units() const
{
  return {0.3 * m_trials[m_best].place[0], stepOfWidth};
}

// Where a trial is, from the best one, in units(). No mask is so at any width.
Eigen::Vector2d MaskSearch::offBest(const Trial &trial) const
{
  Eigen::Vector2d off = (trial.place - m_trials[m_best].place).cwiseQuotient(units());
  if (trial.place[0] == 0.) {
    off[1] = 0.;
  }
  return off;
}

// Its weight in what is fitted: the less the farther it is from the best one.
double MaskSearch::weightOf(const Trial &trial) const
{
  return std::pow(m_trials[m_best].left / trial.left, 2.) / (1. + offBest(trial).squaredNorm());
}

std::optional<MaskSearch::Surface> MaskSearch::surface() const
{
  constexpr int coefficients = 6;
  Eigen::Matrix<double, coefficients, coefficients> matrix =
      1e-9 * Eigen::Matrix<double, coefficients, coefficients>::Identity();
  Eigen::Matrix<double, coefficients, 1> right = Eigen::Matrix<double, coefficients, 1>::Zero();
  int known = 0;
  for (const Trial &trial : m_trials) {
    if (!std::isfinite(trial.left)) {
      continue;
    }
    const Eigen::Vector2d d = offBest(trial);
    Eigen::Matrix<double, coefficients, 1> row;
    row << 1., d[0], d[1], 0.5 * d[0] * d[0], d[0] * d[1], 0.5 * d[1] * d[1];
    matrix += weightOf(trial) * row * row.transpose();
    right += weightOf(trial) * trial.left * row;
    ++known;
  }
  if (known < coefficients) {
    return std::nullopt;
  }
  const Eigen::Matrix<double, coefficients, 1> c = matrix.ldlt().solve(right);
  Surface result;
  result.slope = c.segment<2>(1);
  result.curvature << c[3], c[4], c[4], c[5];
  return result;
}

// Change of the pose, (t, w), by the coordinates in units(): a plane through the poses of the trials.
Eigen::Matrix<double, 6, 2> MaskSearch::poseSlope() const
{
  Eigen::Matrix3d matrix = 1e-9 * Eigen::Matrix3d::Identity();
  Eigen::Matrix<double, 3, 6> right = Eigen::Matrix<double, 3, 6>::Zero();
  for (const Trial &trial : m_trials) {
    if (trial.pose) {
      Eigen::Vector3d row;
      row << 1., offBest(trial);
      matrix += weightOf(trial) * row * row.transpose();
      right += weightOf(trial) * row * trial.pose->transpose();
    }
  }
  return matrix.ldlt().solve(right).bottomRows<2>().transpose();
}

SearchedMask MaskSearch::result() const
{
  const Trial &best = m_trials[m_best];
  SearchedMask found;
  found.mask = maskAt(best.place);
  found.pose = m_start;
  // Information of what cameras do, and of the likelihood, which is nowhere less than none; nothing of that is known
  // where too little was tried.
  Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
  information(0, 0) = std::pow(units()[0] / (strengthOfCameras * best.place[0]), 2.);
  information(1, 1) = std::pow(units()[1] / widthOfCameras, 2.);
  if (const auto there = surface()) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(0.5 * best.pixels / best.left * there->curvature);
    information += axes.eigenvectors() * axes.eigenvalues().cwiseMax(0.).asDiagonal() * axes.eigenvectors().transpose();
  }
  const Eigen::Matrix<double, 6, 2> slope = poseSlope();
  found.doubt = slope * information.inverse() * slope.transpose();
  return found;
}
} // namespace circle_marker
END_VISP_NAMESPACE
