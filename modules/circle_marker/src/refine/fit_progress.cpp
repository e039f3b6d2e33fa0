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
 * How a fit goes on: what it takes for noise, which matrix it works with, and whether a rival has won.
 */

#include "refine/fit_progress.h"

#include <algorithm>

#include "refine/fit_step.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
namespace {
// The noise is estimated again after each of the first steps; later ones keep it, so that they have one cost to lower.
constexpr int mostNoiseUpdates = 5;
// Decrease of the noise's excess from step to step, and where it ends: all, a half, a quarter, none. Where the start is
// near without the quarter: 900 markers of 40 to 200 pixels in any light ended at the same poses, to a tenth of a
// standard deviation. Small ones were found as often without it, but one of 150 was read as another
// (testDetectorWrongIds).
constexpr double excessDecay = 0.5;
constexpr double leastExcess = 0.3;
constexpr double leastExcessIfNear = 0.6;
// The matrix of a pass serves for the next ones as long as the outline has moved by less than this, in units of the
// blur: by as much it is wrong. And as long as each step, in standard deviations, is shorter than the one before by
// this factor.
constexpr double nearMotion = 0.03;
constexpr double shorter = 0.5;
// Who is still behind a rival by more than this share of how far it was before the last step does not catch up.
constexpr double catchingUp = 0.5;
} // namespace

NoiseDescent::NoiseDescent(bool isKnown, bool isQuick)
    : m_excess(isKnown ? 0. : 1.), m_leastExcess(isQuick ? leastExcessIfNear : leastExcess),
      m_updates(isKnown ? 0 : mostNoiseUpdates)
{
}

double NoiseDescent::next(Likelihood &fit)
{
  --m_updates;
  m_excess = m_excess > m_leastExcess ? m_excess * excessDecay : 0.;
  const ResidualSpread spread = fit.spreadOfResiduals();
  return std::max(spread.median, m_excess * spread.wide);
}

void MatrixPlace::set(const MarkerPlane &plane, const Photometry &photometry)
{
  m_plane = plane;
  m_photometry = photometry;
}

bool MatrixPlace::servesAt(const MarkerPlane &plane, const Photometry &photometry, double size, double unit)
{
  const bool isShorter = size < shorter * m_lastSize;
  m_lastSize = size;
  return isShorter && isAlike(m_photometry, photometry) &&
         outlineMotion(m_plane, plane) < nearMotion * unit * photometry.blur.sigma;
}

bool Race::isLost(const Likelihood &fit, const MarkerPlane &plane, const Photometry &photometry)
{
  if (!m_rival) {
    return false;
  }
  const double before = m_behind;
  m_behind = fit.costOfResiduals(plane, photometry, m_rival->scale) - m_rival->squares;
  return m_behind > 2. * m_rival->odds * m_rival->scale * m_rival->scale && m_behind > catchingUp * before;
}
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE
