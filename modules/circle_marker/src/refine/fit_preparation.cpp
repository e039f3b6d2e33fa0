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
 * The pixels of a fit, prepared for the pose, the blur and the light that it has come to.
 */

#include "refine/fit_preparation.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
namespace {
// The pixels are sorted again by what they see when the pose has moved by this share of what the sorting leaves room
// for.
constexpr double sortAgain = 0.5;
// Or when the print has turned by so much, pixels: then of a sharp picture's borders between sectors no more is seen
// than to 2.5 standard deviations of the blur.
constexpr double turnedAgain = 1.5;
// Or when the blur has become wider by this factor.
constexpr double widerAgain = 1.2;
// The correction of edges that bend strongly or lie under a shadow's edge is made again when pose, blur or shadow have
// changed by more than this, pixels: it has changed by no more than a few hundredths of itself by then.
constexpr double correctAgain = 0.1;
// The surround is judged again at the end if it is by this factor more or less even than was thought.
constexpr double unevenAgain = 1.4;
// And on the way when the light has changed by this share of it and by this part of the noise: white paper beyond the
// quiet zone would be taken for something else. What is no marker leaves so much that it hardly matters; with a half of
// the noise the right pose of a small marker was lost to its mirror image.
constexpr double judgeAgain = 0.005;
constexpr double judgeAgainInNoise = 0.1;
} // namespace

FitPreparation::FitPreparation(const std::vector<FitPixel> &pixels, const FitSettings &settings, Likelihood &fit,
                               const FitMemory &memory)
    : m_pixels(pixels), m_sortAgain(sortAgain * settings.poseError), m_fit(fit), m_memory(memory),
      m_hasPixels(settings.samePixels)
{
}

void FitPreparation::sort(const MarkerPlane &plane, const Photometry &photometry, double noise)
{
  if (!m_hasPixels || !m_fit.keepPixels(m_pixels, plane, photometry, noise, m_sortAgain)) {
    m_fit.setPixels(m_pixels, plane, photometry, noise);
    m_isCorrected = false;
  }
  m_hasPixels = true;
  m_sorted = plane;
  m_sortedBlur = photometry.blur.widest();
}

void FitPreparation::prepare(const MarkerPlane &plane, const Photometry &photometry, double noise)
{
  // The surround is judged with the light and the noise.
  if (m_sortedBlur == 0. || !m_memory.blocks.surrounds.empty() || printMotion(m_sorted, plane) > 0. ||
      isWider(photometry)) {
    sort(plane, photometry, noise);
  }
  if (!m_isCorrected || hasOtherEdges(plane, photometry)) {
    m_isBent = m_fit.correct(plane, photometry);
    m_corrected = plane;
    m_correctedBlur = photometry.blur.sigma;
    m_correctedShadow = photometry.shadow.value_or(Shadow());
    m_isCorrected = true;
  }
  m_judged = photometry;
}

bool FitPreparation::isStale(const MarkerPlane &plane, const Photometry &photometry, double noise) const
{
  const double sameLight = std::max(judgeAgain * m_judged.white, judgeAgainInNoise * noise);
  const double turned = printMotion(m_sorted, plane) / m_memory.blocks.reference.unit;
  return motion(m_sorted, plane) > m_sortAgain || turned > turnedAgain || isWider(photometry) ||
         (!m_memory.blocks.surrounds.empty() && std::abs(photometry.white - m_judged.white) > sameLight);
}

bool FitPreparation::isRough(const MarkerPlane &plane, const Photometry &photometry) const
{
  const double uneven = photometry.unevenShare / m_judged.unevenShare;
  return (m_isBent && hasOtherEdges(plane, photometry)) ||
         (!m_memory.blocks.surrounds.empty() && std::max(uneven, 1. / uneven) > unevenAgain);
}

double FitPreparation::motion(const MarkerPlane &from, const MarkerPlane &to) const
{
  return outlineMotion(from, to) / m_memory.blocks.reference.unit;
}

bool FitPreparation::hasOtherEdges(const MarkerPlane &plane, const Photometry &photometry) const
{
  if (motion(m_corrected, plane) > correctAgain || std::abs(photometry.blur.sigma - m_correctedBlur) > correctAgain) {
    return true;
  }
  const Shadow &before = m_correctedShadow;
  const Shadow now = photometry.shadow.value_or(before);
  const double moved = std::abs(now.edge - before.edge) + std::abs(now.direction - before.direction);
  return now.frameSize * (moved + std::abs(now.softness - before.softness)) > correctAgain;
}

bool FitPreparation::isWider(const Photometry &photometry) const
{
  return photometry.blur.widest() > widerAgain * m_sortedBlur;
}
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE
