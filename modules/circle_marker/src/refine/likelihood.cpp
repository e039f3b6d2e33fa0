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
 * Likelihood of the grey levels around a marker, and its normal equations.
 */

#include "refine/likelihood.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Cholesky>

#include "refine/grey_model.h"
#include "refine/light_equations.h"
#include "refine/line_model.h"
#include "refine/shaded_edges.h"
#include "refine/sums.h"
#include "refine/surround_model.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
namespace {
// A print that stands out by less than this, grey levels, is none; rounding alone never gives as much.
constexpr double leastContrast = 0.5;
// Cameras are linear, or have a gamma of 0.45 or 2.2: by its logarithm, 0.8 to either side. A wide blur is less of a
// Gaussian, and what its shape lacks would be taken for gamma: from this blur on, pixels, less is expected.
constexpr double gammaPrior = 0.5;
constexpr double wideBlur = 1.;
// Where more of the pixels than this share are as bright as can be, light and gamma cannot be told from each other.
constexpr double mostOverExposed = 0.05;
// Ink spreads by some 0.1 mm, radii of markers are some 30 to 100 mm.
constexpr double spreadPrior = 0.003;
// Curves of cameras that raise the contrast have 0 to -0.6. And beyond such a curve's first terms half-way between
// ink and paper lies beside where the model has it, by this share of the blur.
constexpr double tonePrior = 0.5;
constexpr double lackingOfCurve = 0.1;
// A sheet of 300 mm that is bowed by 2 mm has heights of 0.008 of the outer radius of its marker of 90 mm, and paper is
// bowed by more.
constexpr double bendPrior = 0.02;
// Most pictures are not moved; those that are have blurs longer by any amount. So the prior of the elongation is
// Cauchy's, with this scale: a tenth of a pixel of motion hardly shows.
constexpr double elongationPrior = 0.03;
// The light changes by some hundredths over a marker's size, mostly, but may by any amount: Cauchy's prior again, this
// share of the light its scale. A change along the tilt makes the two poses of a small ring look more alike.
constexpr double gradientPrior = 0.02;
// A lens of 60 degrees from corner to corner leaves 0.56 of the light there, or less: across a marker that fills a
// third of the image the light bends by a tenth.
constexpr double curvaturePrior = 0.1;
// The paper mostly ends where it may, at a square or, less often, at a circle, or goes on in some directions.
constexpr std::array<double, paperShapes> expectedSurround = {{0.25, 0.5}};
constexpr double surroundPrior = 0.5;
// How sheets are cut, and prints lie on them: some millimetres and degrees off. Shift and growth in outer radii, turn
// in rad.
constexpr std::array<double, paperSize> paperPrior = {{0.01, 0.01, 0.02, 0.015}};
// Steps of a shadow's parameters have this standard deviation at most.
constexpr double shadowPrior = 0.3;
// In the first guess of light and contrast, before the noise is known, a pixel with this variance, grey levels^2, from
// the surround counts half.
constexpr float guessedVariance = 25.f;

double gammaPriorAt(const BlurParameters &blur)
{
  return gammaPrior * std::min(1., wideBlur / blur.sigma);
}

bool isOverExposed(const std::vector<FitPixel> &pixels)
{
  const auto bright =
      std::count_if(pixels.begin(), pixels.end(), [](const FitPixel &pixel) { return pixel.grey >= brightest; });
  return static_cast<double>(bright) > mostOverExposed * static_cast<double>(pixels.size());
}

Eigen::Vector4d vectorOf(const PaperPlacement &paper)
{
  return {paper.shift.x(), paper.shift.y(), paper.turn, paper.growth};
}

// Cauchy's prior of two parameters: its cost, and the weight of a normal one with the same slope, which becomes weaker
// the larger they are. That width makes the step, and goes to the covariance.
double cauchyCost(const Eigen::Vector2d &value, double scale)
{
  return 2. * std::log1p(value.squaredNorm() / (scale * scale));
}

void addCauchy(const Eigen::Vector2d &value, double scale, double noise, int at, Equations &equations)
{
  const double weight = 2. * noise * noise / (scale * scale + value.squaredNorm());
  for (int k = 0; k < 2; ++k) {
    equations.matrix(at + k, at + k) += weight;
    equations.right[at + k] -= weight * value[k];
  }
}
} // namespace

Likelihood::Likelihood(const MarkerPattern &pattern, const FitSettings &settings, FitMemory &memory)
    : m_pattern(pattern), m_settings(settings), m_memory(memory)
{
}

void Likelihood::setPixels(const std::vector<FitPixel> &pixels, const MarkerPlane &plane, const Photometry &photometry,
                           double noise)
{
  m_isOverExposed = isOverExposed(pixels);
  packPixels(pixels, plane, m_pattern, photometry, noise, m_settings.poseError, m_settings.bordersSeen,
             m_memory.blocks);
}

bool Likelihood::keepPixels(const std::vector<FitPixel> &pixels, const MarkerPlane &plane, const Photometry &photometry,
                            double noise, double room)
{
  if (!serve(m_memory.blocks, plane, m_pattern, photometry.blur, room, m_settings.bordersSeen)) {
    return false;
  }
  m_isOverExposed = isOverExposed(pixels);
  judgeSurround(pixels, plane, m_pattern, photometry, noise, m_memory.blocks);
  return true;
}

bool Likelihood::correct(const MarkerPlane &plane, const Photometry &photometry)
{
  if (!m_settings.exactBends) {
    return false;
  }
  const bool isBent = correctBends(plane, m_pattern, photometry.blur, m_memory.blocks);
  return correctShadedEdges(plane, m_pattern, photometry, m_memory.blocks) || isBent;
}

void Likelihood::keepResiduals()
{
  m_memory.residuals.swap(m_memory.trial);
  m_memory.steepness.swap(m_memory.trialSteepness);
  m_memory.sums.pulls.swap(m_memory.trialSums.pulls);
  if (m_trialHasProducts) {
    m_memory.sums.products.swap(m_memory.trialSums.products);
    m_matrix = m_trialMatrix;
  }
}

bool Likelihood::startPhotometry(const MarkerPlane &plane, Photometry &photometry) const
{
  const ImageModel model(plane, m_pattern, photometry.blur, m_memory.blocks);
  LightEquations<4> equations; // light, the two parts of its gradient, and contrast times light
  Lanes darkness;
  forEachBlock(m_memory.blocks, [&](const PixelBlock &block, PixelSight sight) {
    model.evaluate(block, sight, darkness);
    const Lanes weight = guessedVariance / (guessedVariance + block.variance);
    Lanes paper = Lanes::Ones();
    Lanes print = block.grey;
    if (const SurroundLanes *surround = m_memory.blocks.surroundOf(block)) {
      for (std::size_t shape = 0; shape < paperShapes; ++shape) {
        const Lanes share = static_cast<float>(photometry.surround[shape]) * surround->share[shape];
        paper -= share;
        print -= share * surround->beyond[shape];
      }
    }
    std::array<Lanes, 4> row = {paper, paper * block.offsetU, paper * block.offsetV, -darkness};
    if (photometry.shadow) {
      const Lanes share = shadowOf(block, *photometry.shadow).value;
      for (Lanes &lanes : row) {
        lanes = share * lanes;
      }
    }
    equations.add(row, print, weight);
  });
  const Eigen::Vector4d solution = equations.matrix().ldlt().solve(equations.right());
  if (!solution.allFinite() || solution[0] <= 0. || solution[3] < leastContrast) {
    return false;
  }
  photometry.white = solution[0];
  photometry.lightGradient = solution.segment<2>(1) / solution[0];
  photometry.absorption = std::min(solution[3] / solution[0], 1.);
  return true;
}

Equations Likelihood::linearise(const MarkerPlane &plane, const Photometry &photometry, double noise)
{
  return pass(plane, photometry, noise, true);
}

Equations Likelihood::pull(const MarkerPlane &plane, const Photometry &photometry, double noise)
{
  return pass(plane, photometry, noise, false);
}

Equations Likelihood::pass(const MarkerPlane &plane, const Photometry &photometry, double noise, bool formsProducts)
{
  const ImageModel model(plane, m_pattern, photometry.blur, m_memory.blocks, m_settings.bend);
  SurroundModel beyond(plane, m_pattern.paper, photometry, m_memory.blocks, m_settings.bend);
  Equations equations;
  equations.used = usedBy(photometry);
  Sums sums(m_memory.trialSums, equations.used, formsProducts);
  m_memory.trial.clear();
  m_memory.trialSteepness.clear();
  DarknessLanes darkness;
  std::size_t k = 0;
  PixelSight last = PixelSight::RING;
  forEachBlock(m_memory.blocks, [&](const PixelBlock &block, PixelSight sight) {
    k = sight == last ? k : 0;
    last = sight;
    const std::size_t direction = m_memory.blocks.direction[static_cast<std::size_t>(sight)][k++];
    model.evaluate(block, sight, darkness);
    const SurroundLanes *surround = beyond.at(block);
    const GreyLanes grey = greyOf(block, surround, photometry, darkness.value);
    m_memory.trial.push_back(grey.residual);
    LossLanes loss = biweight(grey.residual, block.variance, static_cast<float>(noise));
    const Lanes holds = holdsPixel(block);
    loss.cost *= holds;
    loss.kept *= holds;
    if (grey.isCut) {
      loss.tells *= grey.tells;
    }
    rowOf(block, surround, photometry, darkness, grey, sums.row());
    if (surround != nullptr) {
      beyond.addTo(grey, sums.row());
    }
    // A shift of the print in its plane moves all edges.
    const Lanes steepness = sums.row()[0].square() + sums.row()[1].square();
    m_memory.trialSteepness.push_back(steepness);
    // Coherence is not asked for where bends are not corrected: it is for a final fit.
    sums.add(grey.residual, loss, steepness, m_settings.exactBends ? direction : 0);
  });
  sums.close(equations);
  if (formsProducts) {
    m_trialMatrix = equations.matrix;
  }
  else {
    equations.matrix = m_matrix;
  }
  m_trialHasProducts = formsProducts;
  constrain(plane, photometry, noise, equations);
  return equations;
}

// What the pixels depend on.
UsedParameters Likelihood::usedBy(const Photometry &photometry) const
{
  UsedParameters used;
  used.add(0, surroundAt);
  used.add(surroundAt, m_memory.blocks.surrounds.empty() ? 0 : bendAt - surroundAt);
  used.add(bendAt, m_settings.bend ? bendSize : 0);
  used.add(shadowAt, photometry.shadow ? shadowSize : 0);
  used.add(toneAt, photometry.toneCurve ? 1 : 0);
  used.add(curvatureAt, photometry.lightCurvature ? curvatureSize : 0);
  return used;
}

double Likelihood::cost(const MarkerPlane &plane, const Photometry &photometry, double noise) const
{
  const ImageModel model(plane, m_pattern, photometry.blur, m_memory.blocks);
  SurroundModel beyond(plane, m_pattern.paper, photometry, m_memory.blocks);
  double cost = priorCost(plane, photometry, noise);
  Lanes darkness;
  forEachBlock(m_memory.blocks, [&](const PixelBlock &block, PixelSight sight) {
    model.evaluate(block, sight, darkness);
    const Lanes residual = greyOf(block, beyond.at(block), photometry, darkness).residual;
    cost += static_cast<double>(
        (biweight(residual, block.variance, static_cast<float>(noise)).cost * holdsPixel(block)).sum());
  });
  return cost;
}

void Likelihood::evaluate(const MarkerPlane &plane, const Photometry &photometry)
{
  const ImageModel model(plane, m_pattern, photometry.blur, m_memory.blocks);
  SurroundModel beyond(plane, m_pattern.paper, photometry, m_memory.blocks);
  m_memory.residuals.clear();
  m_memory.steepness.clear();
  Lanes darkness;
  forEachBlock(m_memory.blocks, [&](const PixelBlock &block, PixelSight sight) {
    model.evaluate(block, sight, darkness);
    m_memory.residuals.push_back(greyOf(block, beyond.at(block), photometry, darkness).residual);
  });
}

// Standard deviation of the ink's spread, outer radii; behind a tone curve with that of what it lacks.
double Likelihood::spreadPriorOf(const MarkerPlane &plane, const Photometry &photometry) const
{
  const double pixel = m_memory.blocks.reference.unit * plane.center.z() / plane.radius;
  return photometry.toneCurve ? std::hypot(spreadPrior, lackingOfCurve * photometry.blur.widest() * pixel)
                              : spreadPrior;
}

double Likelihood::priorCost(const MarkerPlane &plane, const Photometry &photometry, double noise) const
{
  const double u =
      m_settings.gammaAndSpread && !m_isOverExposed ? std::log(photometry.gamma) / gammaPriorAt(photometry.blur) : 0.;
  const double v = m_settings.gammaAndSpread ? photometry.blur.spread / spreadPriorOf(plane, photometry) : 0.;
  const double t = photometry.toneCurve.value_or(0.) / tonePrior;
  const double w = (plane.bend.bow * plane.bend.bow + plane.bend.saddle.squaredNorm()) / (bendPrior * bendPrior);
  const double c = photometry.lightCurvature ? photometry.lightCurvature->norm() / curvaturePrior : 0.;
  double cost = u * u + v * v + w + t * t + c * c + cauchyCost(photometry.blur.elongation, elongationPrior) +
                cauchyCost(photometry.lightGradient, gradientPrior);
  for (std::size_t shape = 0; shape < paperShapes; ++shape) {
    const double s = (photometry.surround[shape] - expectedSurround[shape]) / surroundPrior;
    cost += s * s;
  }
  const Eigen::Vector4d paper = vectorOf(photometry.paper);
  for (int k = 0; k < paperSize; ++k) {
    const double s = paper[k] / paperPrior[static_cast<std::size_t>(k)];
    cost += s * s;
  }
  return noise * noise * cost;
}

// Priors on all that other pictures tell of light, ink, blur and paper; parameters that are not fitted are taken out of
// the equations, and a 1 on the diagonal keeps these solvable.
void Likelihood::constrain(const MarkerPlane &plane, const Photometry &photometry, double noise,
                           Equations &equations) const
{
  const double surroundWeight = noise * noise / (surroundPrior * surroundPrior);
  for (std::size_t shape = 0; shape < paperShapes; ++shape) {
    const int at = surroundAt + static_cast<int>(shape);
    equations.matrix(at, at) += surroundWeight;
    equations.right[at] -= surroundWeight * (photometry.surround[shape] - expectedSurround[shape]);
  }
  const Eigen::Vector4d paper = vectorOf(photometry.paper);
  for (int k = 0; k < paperSize; ++k) {
    const double weight = std::pow(noise / paperPrior[static_cast<std::size_t>(k)], 2.);
    equations.matrix(paperAt + k, paperAt + k) += weight;
    equations.right[paperAt + k] -= weight * paper[k];
  }
  equations.cost += priorCost(plane, photometry, noise);
  addCauchy(photometry.blur.elongation, elongationPrior, noise, elongationAt, equations);
  addCauchy(photometry.lightGradient, gradientPrior, noise, gradientAt, equations);
  const auto hold = [&equations](int at) {
    equations.matrix.row(at).setZero();
    equations.matrix.col(at).setZero();
    equations.matrix(at, at) = 1.;
    equations.right[at] = 0.;
  };
  if (m_settings.gammaAndSpread) {
    const double weight = std::pow(noise / gammaPriorAt(photometry.blur), 2.);
    equations.matrix(gammaAt, gammaAt) += weight;
    equations.right[gammaAt] -= weight * std::log(photometry.gamma);
    const double weightOfSpread = std::pow(noise / spreadPriorOf(plane, photometry), 2.);
    equations.matrix(spreadAt, spreadAt) += weightOfSpread;
    equations.right[spreadAt] -= weightOfSpread * photometry.blur.spread;
  }
  else {
    hold(spreadAt);
  }
  if (!m_settings.gammaAndSpread || m_isOverExposed) {
    hold(gammaAt);
    hold(toneAt); // with paper that is cut off it would stand for gamma
  }
  if (!m_settings.spinIsKnown) {
    hold(spinAt);
  }
  const Eigen::Vector3d bend(plane.bend.bow, plane.bend.saddle.x(), plane.bend.saddle.y());
  for (int k = 0; k < bendSize; ++k) {
    const double weight = noise * noise / (bendPrior * bendPrior);
    equations.matrix(bendAt + k, bendAt + k) += weight;
    equations.right[bendAt + k] -= m_settings.bend ? weight * bend[k] : 0.;
  }
  const double weightOfTone = noise * noise / (tonePrior * tonePrior);
  equations.matrix(toneAt, toneAt) += weightOfTone;
  equations.right[toneAt] -= weightOfTone * photometry.toneCurve.value_or(0.);
  const Eigen::Vector3d curvature = photometry.lightCurvature.value_or(Eigen::Vector3d::Zero());
  for (int k = 0; k < curvatureSize; ++k) {
    const double weight = noise * noise / (curvaturePrior * curvaturePrior);
    equations.matrix(curvatureAt + k, curvatureAt + k) += weight;
    equations.right[curvatureAt + k] -= weight * curvature[k];
  }
  // Of a shadow whose edge passes beside the marker not everything is known.
  for (int k = 0; k < shadowSize; ++k) {
    equations.matrix(shadowAt + k, shadowAt + k) += noise * noise / (shadowPrior * shadowPrior);
  }
}
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE
