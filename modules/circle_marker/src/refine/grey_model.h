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
 * Grey levels of a block of pixels as the model has them, and their weights.
 */

/*!
  \file grey_model.h
  \brief Grey levels of a block of pixels as the model has them, their derivatives and their weights: what all passes
  over the pixels share.
*/

#ifndef VP_CIRCLE_MARKER_GREY_MODEL_H
#define VP_CIRCLE_MARKER_GREY_MODEL_H

#include <array>
#include <cmath>

#include "refine/light_lanes.h"
#include "refine/likelihood.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
// Tukey's constant for 95 % efficiency with normal noise.
constexpr double tukey = 4.685;
// With normal noise, mean of (w r)^2 over that of w for the biweight's weights w.
constexpr double pullOfNoise = 0.6605;

// Weight and loss of a residual.
struct LossLanes
{
  Lanes kept;   // share of the pixel that is not taken for an outlier
  Lanes tells;  // how much the pixel tells of the noise: little if the surround may change it
  Lanes weight; // with that of the noise in what is uncertain of it
  Lanes cost;
};

// Tukey's biweight of residuals with noise and what the surround may add.
inline LossLanes biweight(const Lanes &residual, const Lanes &variance, float noise)
{
  const float bound = static_cast<float>(tukey * tukey);
  const Lanes perVariance = (noise * noise + variance).inverse();
  const Lanes kept = (1.f - residual.square() * perVariance * (1.f / bound)).max(0.f);
  const Lanes certainty = noise * noise * perVariance;
  return {kept.square(), certainty.square(), certainty * kept.square(),
          noise * noise * bound / 3.f * (1.f - kept.cube())};
}

// 1 for lanes that hold a pixel, else 0.
inline Lanes holdsPixel(const PixelBlock &block)
{
  return (1e-3f * (noPixel - block.variance)).min(1.f);
}

// Calls use(block, sight) for all blocks, in their order.
template <class Use> void forEachBlock(const PixelBlocks &blocks, const Use &use)
{
  for (std::size_t kind = 0; kind < pixelSights; ++kind) {
    for (const PixelBlock &block : blocks.bySight[kind]) {
      use(block, static_cast<PixelSight>(kind));
    }
  }
}

// The share of the light that a shadow leaves, and its derivatives.
struct ShadowLanes
{
  Lanes value;
  std::array<Lanes, shadowSize> by;
};

inline ShadowLanes shadowOf(const PixelBlock &block, const Shadow &shadow)
{
  const auto cosine = static_cast<float>(std::cos(shadow.direction));
  const auto sine = static_cast<float>(std::sin(shadow.direction));
  const auto perSoftness = static_cast<float>(1. / shadow.softness);
  const auto lost = static_cast<float>(1. - shadow.factor);
  const Lanes z = perSoftness * (cosine * block.offsetU + sine * block.offsetV - static_cast<float>(shadow.edge));
  const NormalLanes normal = normalOf(z);
  const Lanes slope = lost * perSoftness * normal.density;
  ShadowLanes lanes;
  lanes.value = 1.f - lost * normal.cumulative;
  lanes.by[0] = normal.cumulative;                                       // factor
  lanes.by[1] = slope * (sine * block.offsetU - cosine * block.offsetV); // direction
  lanes.by[2] = slope;                                                   // edge
  lanes.by[3] = slope * z.max(-6.5f).min(6.5f);                          // softness
  return lanes;
}

// What a tone curve adds to a print's share of white.
struct ToneLanes
{
  Lanes added;
  Lanes byPrint; // derivatives of that by the print,
  Lanes byBlack; // by the print of ink,
  Lanes byCurve; // and by the curve's parameter
};

inline ToneLanes toneOf(const Lanes &print, double black, double curve)
{
  const auto range = static_cast<float>(1. - black);
  const auto kappa = static_cast<float>(curve);
  const Lanes w = (print - static_cast<float>(black)) / range;
  const Lanes shape = w * (1.f - w) * (1.f - 2.f * w);
  const Lanes slope = 1.f - 6.f * w * (1.f - w);
  ToneLanes tone;
  tone.byCurve = range * shape;
  tone.added = kappa * tone.byCurve;
  tone.byPrint = kappa * slope;
  tone.byBlack = kappa * (slope * (w - 1.f) - shape);
  return tone;
}

// The print of ink, share of white.
inline double inkOf(const Photometry &photometry)
{
  return std::pow(std::max(1. - photometry.absorption, leastLight), photometry.gamma);
}

// Where the sensor's grey levels end: a pixel that should be brighter than this is this bright.
constexpr float brightest = 255.f;

// The grey levels of a block as the model has them.
struct GreyLanes
{
  Lanes logLight;       // logarithm of the light, in units of that at the marker's centre
  Lanes reflectance;    // share of it that the print leaves
  Lanes logReflectance; // and its logarithm
  Lanes white;          // grey level of white paper
  Lanes power;          // reflectance by the power of gamma
  Lanes print;          // and what the tone curve makes of it: grey level of the print, in units of white's
  Lanes paper;          // share of what does not lie beyond the quiet zone
  Lanes residual;
  Lanes tells;        // 0 where the model is brighter than what the sensor can tell, else 1
  bool isCut = false; // whether it is so anywhere in the block
};

// darkness: share of black that each pixel sees; surround: what the block sees of it; nullptr if nothing.
inline GreyLanes greyOf(const PixelBlock &block, const SurroundLanes *surround, const Photometry &photometry,
                        const Lanes &darkness)
{
  GreyLanes grey;
  const auto gamma = static_cast<float>(photometry.gamma);
  Lanes light = lightOf(block, photometry);
  if (photometry.shadow) {
    light = light * shadowOf(block, *photometry.shadow).value;
  }
  grey.logLight = light.log();
  grey.white = static_cast<float>(photometry.white) * (gamma * grey.logLight).exp();
  grey.reflectance = (1.f - static_cast<float>(photometry.absorption) * darkness).max(static_cast<float>(leastLight));
  grey.logReflectance = grey.reflectance.log();
  grey.power = (gamma * grey.logReflectance).exp();
  grey.print = grey.power;
  if (photometry.toneCurve) {
    grey.print += toneOf(grey.power, inkOf(photometry), *photometry.toneCurve).added;
  }
  grey.residual = block.grey - grey.white * grey.print;
  grey.paper.setOnes();
  if (surround != nullptr) {
    for (std::size_t shape = 0; shape < paperShapes; ++shape) {
      const Lanes share = static_cast<float>(photometry.surround[shape]) * surround->share[shape];
      grey.paper -= share;
      grey.residual -= share * (surround->beyond[shape] - grey.white);
    }
  }
  // Over-exposed paper: more light would make no difference.
  const Lanes seen = block.grey - grey.residual;
  if (seen.maxCoeff() > brightest) {
    grey.isCut = true;
    grey.tells = isPositive(brightest - seen);
    grey.residual = block.grey - seen.min(brightest);
  }
  return grey;
}

// Derivatives of a block's grey levels by all parameters that any pixel depends on (UsedParameters).
using RowLanes = std::array<Lanes, parameters>;

inline void rowOf(const PixelBlock &block, const SurroundLanes *surround, const Photometry &photometry,
                  const DarknessLanes &darkness, const GreyLanes &grey, RowLanes &row)
{
  const auto gamma = static_cast<float>(photometry.gamma);
  Lanes byLogReflectance = gamma * grey.white * grey.power;
  Lanes byInk = Lanes::Zero(); // what its print has besides by the curve
  if (photometry.toneCurve) {
    const ToneLanes tone = toneOf(grey.power, inkOf(photometry), *photometry.toneCurve);
    byLogReflectance *= 1.f + tone.byPrint;
    byInk = grey.white * tone.byBlack;
    row[toneAt] = grey.white * tone.byCurve;
  }
  const Lanes byReflectance = byLogReflectance * grey.reflectance.inverse();
  const Lanes byDarkness = -static_cast<float>(photometry.absorption) * byReflectance;
  for (std::size_t k = 0; k < poseSize; ++k) {
    row[k] = byDarkness * darkness.byTwist[k];
  }
  const Lanes byLogWhite = (grey.print + grey.paper - 1.f) * grey.white;
  const Lanes byLogLight = gamma * byLogWhite;
  if (photometry.shadow) {
    const ShadowLanes shadow = shadowOf(block, *photometry.shadow);
    const Lanes byShadow = byLogLight * shadow.value.inverse();
    for (std::size_t k = 0; k < shadowSize; ++k) {
      row[shadowAt + k] = byShadow * shadow.by[k];
    }
  }
  row[lightAt] = static_cast<float>(1. / photometry.white) * byLogWhite;
  const Lanes byLight = byLogLight * lightOf(block, photometry).inverse();
  row[gradientAt] = byLight * block.offsetU;
  row[gradientAt + 1] = byLight * block.offsetV;
  if (photometry.lightCurvature) {
    row[curvatureAt] = row[gradientAt] * block.offsetU;
    row[curvatureAt + 1] = row[gradientAt] * block.offsetV;
    row[curvatureAt + 2] = row[gradientAt + 1] * block.offsetV;
  }
  row[absorptionAt] = -byReflectance * darkness.value;
  row[gammaAt] = byLogReflectance * grey.logReflectance + byLogLight * grey.logLight;
  if (photometry.toneCurve) {
    const double ink = inkOf(photometry);
    const double left = std::max(1. - photometry.absorption, leastLight);
    row[absorptionAt] -= static_cast<float>(photometry.gamma * ink / left) * byInk;
    row[gammaAt] += static_cast<float>(ink * std::log(ink)) * byInk;
  }
  row[sigmaAt] = byDarkness * darkness.bySigma;
  row[elongationAt] = byDarkness * darkness.byElongation[0];
  row[elongationAt + 1] = byDarkness * darkness.byElongation[1];
  row[spreadAt] = byDarkness * darkness.bySpread;
  for (std::size_t k = 0; k < bendSize; ++k) {
    row[bendAt + k] = byDarkness * darkness.byBend[k];
  }
  for (std::size_t k = 0; k < paperSize; ++k) {
    row[paperAt + k].setZero(); // SurroundModel adds what it is
  }
  for (std::size_t shape = 0; shape < paperShapes; ++shape) {
    if (surround != nullptr) {
      row[surroundAt + shape] = surround->share[shape] * (surround->beyond[shape] - grey.white);
    }
    else {
      row[surroundAt + shape].setZero();
    }
  }
  if (grey.isCut) {
    for (Lanes &derivative : row) {
      derivative = grey.tells * derivative;
    }
  }
}
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
