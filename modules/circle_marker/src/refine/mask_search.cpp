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
#include <Eigen/Geometry>

#include "refine/coarse_fits.h"
#include "refine/fit_starts.h"
#include "support/sensor_range.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Widths of masks, pixels: a narrower one is a sharper lens, a wider one a veil of light.
constexpr double leastSigma = 0.5;
constexpr double mostSigma = 5.;
// Weak masks, amount and pixels: towards what sharpened an image one of them makes it likelier; that is the last one
// where a small marker was sharpened strongly.
constexpr std::array<UnsharpMask, 3> weakMasks = {{{0.2, 1.}, {0.15, 2.}, {0.5, 2.}}};
// Where the search begins, amount and pixels: what many cameras do; and if that does not explain the image, strong
// sharpening by wide masks, which is not seen behind weak narrow ones.
constexpr std::array<UnsharpMask, 4> starts = {{{0.5, 1.}, {0.45, 2.}, {1.4, 2.}, {3., 2.}}};
// So many steps of the width are tried to either side.
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

// From one pose to another: of the centre, metres, and of the normal, as a rotation, rad. No mask turns a marker about
// its normal.
Eigen::Matrix<double, 6, 1> change(const MarkerPlane &from, const MarkerPlane &to)
{
  Eigen::Matrix<double, 6, 1> pose;
  pose << to.center * (from.radius / to.radius) - from.center, from.rotation.col(2).cross(to.rotation.col(2));
  return pose;
}

// They would stand for a part of a mask.
void dropExtensions(Photometry &photometry)
{
  photometry.toneCurve.reset();
  photometry.lightCurvature.reset();
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
    dropExtensions(m_nearest->photometry);
  }
  if (start.photometry.toneCurve) {
    m_toned = start;
    m_toned->photometry.lightCurvature.reset(); // no other trial has one
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
  const MaskTrial &best = m_trials.best();
  if (!isBetterThanNone() || best.left > clearlyLess * rival) {
    return std::nullopt;
  }
  SearchedMask found = result();
  found.gain = 0.5 * best.pixels * std::log(rival / best.left);
  return found;
}

void MaskSearch::searchFrom(const UnsharpMask &start)
{
  const Eigen::Vector2d place = placeOf(start.amount, start.sigma);
  if (!searchStrength(place) || !isBetterThanNone()) {
    return;
  }
  searchWidth();
  const Eigen::Vector2d wide = m_trials.best().place;
  if (wide[1] != place[1]) {
    searchStrength(wide);
    searchWidth();
  }
  searchBoth();
}

// Whether a weak mask makes the marker likelier. What is left of it may have many another reason.
bool MaskSearch::isLikelierBehindAny()
{
  return std::any_of(weakMasks.begin(), weakMasks.end(), [this](const UnsharpMask &mask) {
    return leftAt(placeOf(mask.amount, mask.sigma)) < m_trials.none().left;
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
  const MaskTrial &best = m_trials.best();
  return best.noise < mostLeft * std::max(m_noise / (1. + maskAt(best.place).amount), quantisation);
}

bool MaskSearch::isBetterThanNone() const
{
  return m_trials.best().left < clearlyLess * m_trials.none().left;
}

bool MaskSearch::isOver() const
{
  const bool mayBeNone = m_trials.count() > 0 && !std::isfinite(m_trials.none().left);
  return m_trials.count() >= (mayBeNone ? mostTrialsOfUnlike : MaskTrials::most);
}

UnsharpMask MaskSearch::maskAt(const Eigen::Vector2d &place) const
{
  UnsharpMask mask = maskOf(place);
  mask.white = m_white;
  mask.ink = m_ink;
  return mask;
}

// What is left behind a mask, whether it was tried before or not: grey levels^2.
double MaskSearch::leftAt(const Eigen::Vector2d &place)
{
  const MaskTrial *const known = m_trials.at(place);
  return known != nullptr ? known->left : tryAt(place);
}

// From where it was measured behind the best mask; with the noise that is as likely: fits that weigh pixels by another
// noise leave more or less, by some per cent, which hides what masks do.
std::optional<FitBehind> MaskSearch::measureBehind(const UnsharpMask &mask) const
{
  if (!m_nearest) {
    return m_measureBehind(mask, nullptr);
  }
  FittedPose nearest = *m_nearest;
  if (m_trials.count() > 0) {
    nearest.noise *= std::exp(lnGainOf(maskAt(m_trials.best().place)) - lnGainOf(mask));
  }
  return m_measureBehind(mask, &nearest);
}

// The same of one that was not; HUGE_VAL if there were trials enough.
double MaskSearch::tryAt(const Eigen::Vector2d &place)
{
  if (isOver()) {
    return HUGE_VAL;
  }
  MaskTrial trial;
  trial.place = place;
  const UnsharpMask mask = maskAt(trial.place);
  const auto behind = measureBehind(mask);
  if (!behind) {
    m_trials.add(trial);
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
  if (m_trials.add(trial) || !m_nearest) {
    m_nearest = fit;
    dropExtensions(m_nearest->photometry);
    m_white = fit.photometry.white;
    m_ink = m_white * (1. - fit.photometry.contrast());
  }
  return trial.left;
}

// The best strength of a width. False if none is better than no mask.
bool MaskSearch::searchStrength(const Eigen::Vector2d &start)
{
  const double most = mostStrengthOf(start[1]);
  double strength = std::min(start[0], 0.5 * most);
  const auto leftBy = [&](double tried) { return leftAt({tried, start[1]}); };
  const double none = m_trials.none().left;
  double at = leftBy(strength);
  if (at >= none) {
    strength /= 3.;
    at = leftBy(strength);
  }
  if (at >= none) {
    return false;
  }
  double below = none;
  double twice = leftBy(2. * strength);
  double from = 0.;
  while (twice < at && 4. * strength <= most) {
    below = at;
    at = twice;
    from = strength;
    strength *= 2.;
    twice = leftBy(2. * strength);
  }
  // The vertex of the parabola through three values, by divided differences.
  const double up = (twice - at) / strength;
  const double down = (at - below) / (strength - from);
  const double curvature = (up - down) / (2. * strength - from); // half of it
  if (std::isfinite(curvature) && curvature > 0.) {
    const double vertex = 0.5 * (strength + from) - 0.5 * down / curvature;
    leftBy(std::clamp(vertex, 0.5 * (from + strength), 1.5 * strength));
  }
  return true;
}

// Narrower and wider masks of the best strength.
void MaskSearch::searchWidth()
{
  const MaskTrial start = m_trials.best();
  for (const double direction : {-1., 1.}) {
    double before = start.left;
    for (int step = 1; step <= mostSteps; ++step) {
      const double lnSigma = start.place[1] + direction * step * m_trials.units()[1];
      if (lnSigma < std::log(leastSigma) || lnSigma > std::log(mostSigma) || start.place[0] > mostStrengthOf(lnSigma)) {
        break;
      }
      const double left = leftAt({start.place[0], lnSigma});
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
    const auto there = m_trials.surface();
    if (!there) {
      return;
    }
    const MaskTrial &best = m_trials.best();
    // As far as the next trials at most.
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(there->curvature);
    const Eigen::Vector2d values = axes.eigenvalues().cwiseMax(1e-3 * best.left);
    const Eigen::Vector2d along = axes.eigenvectors().transpose() * there->slope;
    Eigen::Vector2d step = -axes.eigenvectors() * along.cwiseQuotient(values);
    const double promised = -(there->slope.dot(step) + 0.5 * step.dot(there->curvature * step));
    step = step.cwiseMax(-1.).cwiseMin(1.);
    Eigen::Vector2d place = best.place + step.cwiseProduct(m_trials.units());
    place[1] = std::clamp(place[1], std::log(leastSigma), std::log(mostSigma));
    place[0] = std::min(place[0], mostStrengthOf(place[1]));
    if (0.5 * best.pixels * promised / best.left < negligible || m_trials.isNear(place, leastStep)) {
      return;
    }
    tryAt(place);
  }
}

SearchedMask MaskSearch::result() const
{
  const MaskTrial &best = m_trials.best();
  SearchedMask found;
  found.mask = maskAt(best.place);
  found.pose = m_start;
  // Information of what cameras do, and of the likelihood, which is nowhere less than none; nothing of that is known
  // where too little was tried.
  Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
  information(0, 0) = std::pow(m_trials.units()[0] / (strengthOfCameras * best.place[0]), 2.);
  information(1, 1) = std::pow(m_trials.units()[1] / widthOfCameras, 2.);
  if (const auto there = m_trials.surface()) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(0.5 * best.pixels / best.left * there->curvature);
    information += axes.eigenvectors() * axes.eigenvalues().cwiseMax(0.).asDiagonal() * axes.eigenvectors().transpose();
  }
  const Eigen::Matrix<double, 6, 2> slope = m_trials.poseSlope();
  found.doubt = slope * information.inverse() * slope.transpose();
  return found;
}
} // namespace circle_marker
END_VISP_NAMESPACE
