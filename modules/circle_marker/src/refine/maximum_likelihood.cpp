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
 * Maximum-likelihood pose of a marker from the grey levels around its edges.
 */

#include "refine/maximum_likelihood.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "refine/likelihood.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
namespace {
// The blur stays between that of the pixel's own area and one that no marker is recognised through, pixels.
constexpr double leastSigma = 0.29;
constexpr double mostSigma = 20.;
// What a shadow leaves of the light, and the softness of its edge, in units of the marker's size.
constexpr double leastFactor = 0.02;
constexpr double mostFactor = 1.;
constexpr double leastSoftness = 0.003;
constexpr double mostSoftness = 1.;
// The noise is estimated again after each of the first steps; later ones keep it, so that they have one cost to lower.
constexpr int mostNoiseUpdates = 5;
// Below this damping a step is as long as the equations want it: only then a short one means convergence.
constexpr double freeDamping = 0.1;
// The damping of the first step after one that failed. The steps are not damped otherwise: in the marker's frame the
// depth is a difference of well known things, and the least damping of these holds it back.
constexpr double leastDamping = 1e-3;
// Beyond this damping no step lowers the cost: the fit is at its minimum, to rounding.
constexpr double mostDamping = 1e6;
// Decrease of that excess from step to step, and where it ends.
constexpr double excessDecay = 0.5;
constexpr double leastExcess = 0.3;
// Relative error of a cost, summed up in single precision.
constexpr double rounding = 1e-6;
// Reweighting alone makes a step too short: the biweight's slope, E[psi'] = 0.762, is less than its mean weight, 0.915.
constexpr double biweightStep = 0.915 / 0.762;
// What a step leaves of the way: by the chance of the weights this share, and by the bend of the edges' profiles as
// much as it moves them, in units of their blur.
constexpr double stepError = 0.2;
// The matrix of a pass serves for the next ones as long as the outline has moved by less than this, in units of the
// blur, and the light, the contrast and the blur have changed by less than this share: by as much it is wrong. And as
// long as each step, in standard deviations, is shorter than the one before by this factor.
constexpr double nearMotion = 0.03;
constexpr double nearLight = 0.01;
constexpr double shorter = 0.5;
// The pixels are sorted again by what they see when the pose has moved by this share of what the sorting leaves room
// for.
constexpr double sortAgain = 0.5;
// Or when the blur has become wider by this factor.
constexpr double muchWider = 1.2;
// The correction of strong bends is made again at the end if pose or blur have changed by more than this, pixels: it
// has changed by no more than a few hundredths of itself by then.
constexpr double correctAgain = 0.1;
// The surround is also judged again at the end if it is by this factor more or less even than was thought.
constexpr double unevenAgain = 1.4;
// And the surround is judged again when the light has changed by this share of it: white paper beyond the quiet zone
// would be taken for something else.
constexpr double judgeAgain = 0.005;

// Who is still behind a rival by more than this share of how far it was before the last step does not catch up.
constexpr double catchingUp = 0.5;

void applyStep(const ParameterVector &step, MarkerPlane &plane, Photometry &photometry)
{
  plane.center += plane.radius * (plane.rotation * step.head<3>());
  const Eigen::Vector3d turn = step.segment<3>(3);
  const double angle = turn.norm();
  if (angle > 0.) {
    plane.rotation = plane.rotation * Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
  }
  photometry.light += step[lightAt];
  photometry.lightGradient += step.segment<2>(gradientAt);
  photometry.contrast += step[contrastAt];
  photometry.blur.sigma = std::clamp(photometry.blur.sigma + step[sigmaAt], leastSigma, mostSigma);
  photometry.blur.elongate(step.segment<2>(elongationAt));
  photometry.blur.growth += step[growthAt];
  photometry.blur.spread += step[spreadAt];
  for (std::size_t shape = 0; shape < paperShapes; ++shape) {
    photometry.surround[shape] += step[surroundAt + static_cast<int>(shape)];
  }
  if (photometry.shadow) {
    Shadow &shadow = *photometry.shadow;
    shadow.factor = std::clamp(shadow.factor + step[shadowAt], leastFactor, mostFactor);
    shadow.direction += step[shadowAt + 1];
    shadow.edge += step[shadowAt + 2];
    shadow.softness = std::clamp(shadow.softness + step[shadowAt + 3], leastSoftness, mostSoftness);
  }
}

bool isAlike(const Photometry &p, const Photometry &q)
{
  return std::abs(p.light - q.light) < nearLight * p.light && std::abs(p.contrast - q.contrast) < nearLight &&
         std::abs(p.blur.sigma - q.blur.sigma) < nearLight * p.blur.sigma;
}

// Of the parameters that any pixel depends on.
using UsedMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, parameters, parameters>;

// Solves the equations of the first parameters; the others stay as they are.
ParameterVector solve(const ParameterMatrix &matrix, const ParameterVector &right, Eigen::Index used)
{
  ParameterVector solution = ParameterVector::Zero();
  solution.head(used) = UsedMatrix(matrix.topLeftCorner(used, used)).ldlt().solve(right.head(used));
  return solution;
}

// Standard deviation of the noise from the weighted residuals: more efficient than the median.
double noiseOfSquares(const Equations &equations)
{
  // Of normal noise the biweight keeps this share of the mean square at its constant c:
  // (1 - 6 / c^2 + 15 / c^4) / (1 - 2 / c^2 + 3 / c^4).
  constexpr double biweightShrinkage = 0.828;
  const double freedom = std::max(equations.kept - equations.used, 1.);
  return std::max(std::sqrt(equations.squares / freedom / biweightShrinkage), quantisation);
}

// The biweight's mean is 0.915 with normal noise, and the equations' information with it; its efficiency is 0.95.
constexpr double biweightCovariance = 0.915 / 0.95;

// Whether the marker faces the camera and lies in front of it.
bool isVisible(const MarkerPlane &plane)
{
  return plane.center.z() > plane.radius * 0.1 && plane.rotation.col(2).dot(plane.center) > 0.;
}

// Whether paper is lit and ink darker: the negative of a marker is none, however well it correlates.
bool isPrint(const Photometry &photometry)
{
  return photometry.light > 0. && photometry.contrast > 0.;
}

// Covariance of (t, w) in the camera frame from that of the twist in the marker's.
Eigen::Matrix<double, 6, 6> inCameraFrame(const Eigen::Matrix<double, 6, 6> &covariance, const MarkerPlane &plane)
{
  Eigen::Matrix<double, 6, 6> change = Eigen::Matrix<double, 6, 6>::Zero();
  change.topLeftCorner<3, 3>() = plane.radius * plane.rotation;
  change.bottomRightCorner<3, 3>() = plane.rotation;
  return change * covariance * change.transpose();
}
// The pixels as they are prepared for a fit: sorted by what they see, strong bends corrected, the surround judged. All
// that depends on the pose, the blur and the light, but little.
class Preparation
{
public:
  Preparation(const std::vector<FitPixel> &pixels, const FitSettings &settings, Likelihood &fit,
              const FitMemory &memory)
      : m_pixels(pixels), m_sortAgain(sortAgain * settings.poseError), m_fit(fit), m_memory(memory),
        m_hasPixels(settings.samePixels)
  {
  }

  // Only sorts, for what comes before light and noise are known.
  void sort(const MarkerPlane &plane, const Photometry &photometry, double noise)
  {
    if (!m_hasPixels || !m_fit.keepPixels(m_pixels, plane, photometry, noise, m_sortAgain)) {
      m_fit.setPixels(m_pixels, plane, photometry, noise);
    }
    m_hasPixels = true;
    m_sorted = plane;
    m_sortedBlur = photometry.blur.widest();
  }

  void prepare(const MarkerPlane &plane, const Photometry &photometry, double noise)
  {
    // The surround is judged with the light and the noise.
    if (m_sortedBlur == 0. || !m_memory.blocks.surrounds.empty() || motion(m_sorted, plane) > 0. ||
        isWider(photometry)) {
      sort(plane, photometry, noise);
    }
    m_isBent = m_fit.correct(plane, photometry);
    m_plane = plane;
    m_photometry = photometry;
  }

  // Whether pixels may see other edges by now, or other light.
  bool isStale(const MarkerPlane &plane, const Photometry &photometry) const
  {
    return motion(m_sorted, plane) > m_sortAgain || isWider(photometry) ||
           (!m_memory.blocks.surrounds.empty() &&
            std::abs(photometry.light - m_photometry.light) > judgeAgain * m_photometry.light);
  }

  // Whether a fit that is done wants a better preparation for its last steps.
  bool isRough(const MarkerPlane &plane, const Photometry &photometry) const
  {
    const double uneven = photometry.unevenShare / m_photometry.unevenShare;
    return (m_isBent && (motion(m_plane, plane) > correctAgain ||
                         std::abs(photometry.blur.sigma - m_photometry.blur.sigma) > correctAgain)) ||
           (!m_memory.blocks.surrounds.empty() && std::max(uneven, 1. / uneven) > unevenAgain);
  }

private:
  // Pixels.
  double motion(const MarkerPlane &from, const MarkerPlane &to) const
  {
    return outlineMotion(from, to) / m_memory.blocks.reference.unit;
  }

  // Whether the blur reaches much farther than when the pixels were sorted.
  bool isWider(const Photometry &photometry) const { return photometry.blur.widest() > muchWider * m_sortedBlur; }

  const std::vector<FitPixel> &m_pixels;
  const double m_sortAgain; // pixels
  Likelihood &m_fit;
  const FitMemory &m_memory;
  bool m_hasPixels; // whether those in the memory are these
  MarkerPlane m_sorted;
  double m_sortedBlur = 0.; // pixels; 0 before
  MarkerPlane m_plane;
  Photometry m_photometry;
  bool m_isBent = false;
};

// The noise comes down from what the edges' residuals are at the start to that of a right fit, so that they are not
// taken for outliers while they are needed.
class NoiseDescent
{
public:
  explicit NoiseDescent(bool isKnown) : m_excess(isKnown ? 0. : 1.), m_updates(isKnown ? 0 : mostNoiseUpdates) {}

  // Whether the noise is no more than that of the residuals.
  bool isDown() const { return m_excess == 0.; }

  // Whether it stays what it is.
  bool isOver() const { return m_updates == 0; }

  // The noise after a step.
  double next(Likelihood &fit)
  {
    --m_updates;
    m_excess = m_excess > leastExcess ? m_excess * excessDecay : 0.;
    const ResidualSpread spread = fit.spreadOfResiduals();
    return std::max(spread.median, m_excess * spread.wide);
  }

private:
  double m_excess;
  int m_updates;
};

// Where the matrix of the equations was formed, and whether it serves at other parameters.
class MatrixPlace
{
public:
  void set(const MarkerPlane &plane, const Photometry &photometry)
  {
    m_plane = plane;
    m_photometry = photometry;
  }

  // size: of the step that leads there, standard deviations; unit: of a pixel.
  bool servesAt(const MarkerPlane &plane, const Photometry &photometry, double size, double unit)
  {
    const bool isShorter = size < shorter * m_lastSize;
    m_lastSize = size;
    return isShorter && isAlike(m_photometry, photometry) &&
           outlineMotion(m_plane, plane) < nearMotion * unit * photometry.blur.sigma;
  }

private:
  MarkerPlane m_plane;
  Photometry m_photometry;
  double m_lastSize = HUGE_VAL;
};

// A fit against a rival that is better already.
class Race
{
public:
  explicit Race(const std::optional<Rival> &rival) : m_rival(rival) {}

  // Whether the fit stays far behind, by the residuals kept after a step.
  bool isLost(const Likelihood &fit, const Photometry &photometry)
  {
    if (!m_rival) {
      return false;
    }
    const double before = m_behind;
    m_behind = fit.costOfResiduals(photometry, m_rival->noise) - m_rival->squares;
    return m_behind > 2. * m_rival->odds * m_rival->noise * m_rival->noise && m_behind > catchingUp * before;
  }

private:
  const std::optional<Rival> &m_rival;
  double m_behind = HUGE_VAL; // grey levels^2
};

// What is known at the end of a fit besides pose and light; false if the equations are singular. lastStep: beyond where
// they were made.
bool conclude(const Likelihood &fit, const Equations &equations, const ParameterVector &lastStep, double noise,
              const FitSettings &settings, FittedPose &result)
{
  result.squares = equations.cost;
  result.noise = noiseOfSquares(equations);
  const Explanation explanation = fit.explain(noise);
  result.inliers = explanation.inliers;
  result.correlation = explanation.correlation;
  ParameterMatrix inverse = ParameterMatrix::Zero();
  inverse.topLeftCorner(equations.used, equations.used) =
      UsedMatrix(equations.matrix.topLeftCorner(equations.used, equations.used))
          .ldlt()
          .solve(UsedMatrix::Identity(equations.used, equations.used));
  if (!inverse.allFinite()) {
    return false;
  }
  result.decrement = equations.right.dot(inverse * equations.right);
  const double coherence = settings.exactBends ? fit.coherence(inverse, lastStep, noise, equations.used) : 1.;
  Eigen::Matrix<double, 6, 6> covariance =
      coherence * biweightCovariance * result.noise * result.noise * inverse.topLeftCorner<poseSize, poseSize>();
  if (!settings.spinIsKnown) {
    covariance.row(spinAt).setZero();
    covariance.col(spinAt).setZero();
  }
  result.covariance = inCameraFrame(covariance, result.plane);
  return true;
}
} // namespace

std::optional<FittedPose> fitPose(const std::vector<FitPixel> &pixels, const FitStart &start,
                                  const MarkerPattern &pattern, const FitSettings &settings, FitMemory &memory)
{
  if (pixels.size() < 2 * parameters) {
    return std::nullopt;
  }
  Likelihood fit(pattern, settings, memory);
  Preparation preparation(pixels, settings, fit, memory);
  FittedPose result;
  result.plane = start.plane;
  if (start.photometry) {
    result.photometry = *start.photometry;
  }
  else {
    result.photometry.shadow = settings.shadow;
    preparation.sort(result.plane, result.photometry, 0.);
    if (!fit.startPhotometry(result.plane, result.photometry)) {
      return std::nullopt;
    }
  }
  preparation.prepare(result.plane, result.photometry, start.noise.value_or(0.));
  double noise = 0.;
  if (start.noise) {
    noise = *start.noise;
  }
  else {
    fit.evaluate(result.plane, result.photometry);
    noise = fit.spreadOfResiduals().wide;
  }
  if (!std::isfinite(noise)) {
    return std::nullopt;
  }
  Equations equations = fit.linearise(result.plane, result.photometry, noise);
  fit.keepResiduals();
  MatrixPlace matrixPlace;
  matrixPlace.set(result.plane, result.photometry);
  NoiseDescent descent(start.noise.has_value());
  Race race(settings.rival);
  double damping = 0.;
  ParameterVector lastStep = ParameterVector::Zero(); // beyond the equations
  for (int iteration = 0; iteration < settings.mostIterations; ++iteration) {
    ParameterMatrix damped = equations.matrix;
    damped.diagonal() *= 1. + damping;
    ParameterVector step = solve(damped, equations.right, equations.used);
    if (!step.allFinite()) {
      return std::nullopt;
    }
    const double size = std::sqrt(step.dot(equations.matrix * step)) / noise;
    step *= biweightStep;
    MarkerPlane plane = result.plane;
    Photometry photometry = result.photometry;
    applyStep(step, plane, photometry);
    const double bend = outlineMotion(result.plane, plane) / (memory.blocks.reference.unit * photometry.blur.sigma);
    const bool isStale = preparation.isStale(plane, photometry);
    if (!isStale && descent.isDown() && damping < freeDamping && size * (stepError + bend) < settings.convergence) {
      result.plane = plane;
      result.photometry = photometry;
      result.photometry.unevenShare = fit.unevenShareOfResiduals(noise);
      if (!preparation.isRough(plane, result.photometry)) {
        lastStep = step / biweightStep; // the weights change as well
        result.isSettled = true;
        break;
      }
      preparation.prepare(plane, result.photometry, noise);
      equations = fit.linearise(plane, result.photometry, noise);
      fit.keepResiduals();
      matrixPlace.set(plane, result.photometry);
      continue;
    }
    if (isVisible(plane) && isPrint(photometry)) {
      const bool isNear =
          matrixPlace.servesAt(plane, photometry, size, memory.blocks.reference.unit) && descent.isOver();
      Equations trial = isNear ? fit.pull(plane, photometry, noise) : fit.linearise(plane, photometry, noise);
      if (trial.cost <= equations.cost * (1. + rounding)) {
        result.plane = plane;
        result.photometry = photometry;
        damping = damping > leastDamping ? 0.1 * damping : 0.;
        if (isStale) {
          preparation.prepare(plane, photometry, noise);
          trial = fit.linearise(plane, photometry, noise);
        }
        equations = trial;
        fit.keepResiduals();
        if (isStale || !isNear) {
          matrixPlace.set(plane, photometry);
        }
        // While the noise comes down, all residuals are outliers to the rival's: their cost tells nothing.
        if (descent.isDown() && race.isLost(fit, photometry)) {
          break;
        }
        if (!descent.isOver()) {
          noise = descent.next(fit);
          equations.cost = fit.costOfResiduals(photometry, noise);
        }
        continue;
      }
    }
    damping = std::max(damping * 10., leastDamping);
    if (damping > mostDamping) {
      result.isSettled = true;
      break;
    }
  }
  return conclude(fit, equations, lastStep, noise, settings, result) ? std::optional<FittedPose>(result) : std::nullopt;
}

double robustSquares(const std::vector<FitPixel> &pixels, const FittedPose &fit, const MarkerPattern &pattern,
                     const Photometry &surround, double noise, bool exactBends, FitMemory &memory)
{
  FitSettings settings;
  settings.growth = false;
  settings.exactBends = exactBends;
  Likelihood likelihood(pattern, settings, memory);
  if (!likelihood.keepPixels(pixels, fit.plane, surround, noise, 0.)) {
    likelihood.setPixels(pixels, fit.plane, surround, noise);
  }
  likelihood.correct(fit.plane, fit.photometry);
  likelihood.evaluate(fit.plane, fit.photometry);
  return likelihood.costOfResiduals(fit.photometry, noise);
}
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE
