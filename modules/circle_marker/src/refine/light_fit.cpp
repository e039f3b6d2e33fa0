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
 * The uneven light on a marker, by what a fit in even light makes of it.
 */

#include "refine/light_fit.h"

#include <cmath>

#include <Eigen/Cholesky>

#include "support/sensor_range.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
constexpr int terms = UnevenLight::terms;
using Terms = UnevenLight::Terms;

// Prior: standard deviation of each Gaussian, in units of the contrast. A reflection is brighter than a shade is dark.
constexpr double priorOfWhite = 1.;
constexpr double priorOfStep = 0.3;
// Pixels that see an edge tell where that is, and not the light: they count as if their noise were larger by this share
// of the contrast. With 0.15 the light followed the pose that was off, and pose and light came to their end slowly.
constexpr double edgeError = 0.5;
// Deviations of more than so many standard deviations, with this share of the contrast for what the model lacks, are
// not of the light: Cauchy's weights.
constexpr double farOff = 3.;
constexpr double lackingOfModel = 0.02;
constexpr int reweightings = 2;
// Pixels that are asked at most, evenly taken from all: by as many the sum of 52 terms is known to a fifth of the
// noise.
constexpr std::size_t mostPixels = 1500;

Eigen::Vector2d placeOf(const ExplainedPixel &pixel, const ImageFrame &frame)
{
  return frame.center + frame.size * pixel.offset.cast<double>();
}

std::size_t strideOver(const std::vector<ExplainedPixel> &pixels)
{
  return 1 + pixels.size() / mostPixels;
}

// Even light: white and the step from it to black by linear regression. False where there is no print.
bool startEven(const std::vector<ExplainedPixel> &pixels, UnevenLight &light)
{
  Eigen::Matrix2d matrix = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (const ExplainedPixel &pixel : pixels) {
    const Eigen::Vector2d row(1., -pixel.darkness);
    matrix += pixel.weight * row * row.transpose();
    right += pixel.weight * pixel.grey * row;
  }
  const Eigen::Vector2d even = matrix.ldlt().solve(right);
  light.white[0] = even[0];
  light.step[0] = even[1];
  return even.allFinite() && even[1] > 0.;
}

// Both functions once more, with the weights of what they leave now. False if they are not told.
bool improve(const std::vector<ExplainedPixel> &pixels, const ImageFrame &frame, double step, double noise,
             bool isRobust, UnevenLight &light)
{
  using Matrix = Eigen::Matrix<double, 2 * terms, 2 * terms>;
  using Vector = Eigen::Matrix<double, 2 * terms, 1>;
  Vector diagonal;
  diagonal << Terms::Constant(1. / std::pow(priorOfWhite * step, 2)),
      Terms::Constant(1. / std::pow(priorOfStep * step, 2));
  diagonal[0] = diagonal[terms] = 0.; // the means may be any
  Matrix matrix = diagonal.asDiagonal();
  Vector right = Vector::Zero();
  const double floor = std::hypot(noise, lackingOfModel * step);
  const std::size_t stride = strideOver(pixels);
  for (std::size_t i = 0; i < pixels.size(); i += stride) {
    const ExplainedPixel &pixel = pixels[i];
    if (mayBeTooBright(pixel.grey)) {
      continue;
    }
    const Terms at = light.termsAt(placeOf(pixel, frame));
    const double darkness = pixel.darkness;
    const double sigma = std::hypot(floor, edgeError * step * 4. * darkness * (1. - darkness));
    double weight = pixel.weight / (sigma * sigma);
    if (isRobust) {
      const double left = pixel.grey - (light.white - darkness * light.step).dot(at);
      weight /= 1. + std::pow(left / (farOff * sigma), 2);
    }
    Vector row;
    row << at, -darkness * at;
    matrix.selfadjointView<Eigen::Lower>().rankUpdate(row, weight);
    right += weight * pixel.grey * row;
  }
  const Vector solution = matrix.selfadjointView<Eigen::Lower>().ldlt().solve(right);
  light.white = solution.head<terms>();
  light.step = solution.tail<terms>();
  return solution.allFinite();
}
} // namespace

std::optional<UnevenLight> unevenLightOf(const std::vector<ExplainedPixel> &pixels, const ImageFrame &frame,
                                         const Eigen::Matrix2d &toSheet, double noise)
{
  UnevenLight light;
  light.center = frame.center;
  light.toSheet = toSheet / frame.size;
  if (!startEven(pixels, light)) {
    return std::nullopt;
  }
  const double step = light.step[0];
  for (int round = 0; round <= reweightings; ++round) {
    if (!improve(pixels, frame, step, noise, round > 0, light)) {
      return std::nullopt;
    }
  }
  Terms sum = Terms::Zero();
  const std::size_t stride = strideOver(pixels);
  for (std::size_t i = 0; i < pixels.size(); i += stride) {
    sum += light.termsAt(placeOf(pixels[i], frame));
  }
  light.meanWhite = light.white.dot(sum) / sum[0]; // the first term is 1
  light.meanStep = light.step.dot(sum) / sum[0];
  return light.meanStep > 0. ? std::make_optional(light) : std::nullopt;
}
} // namespace circle_marker
END_VISP_NAMESPACE
