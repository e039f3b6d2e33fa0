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
 * A ring whose pose, light and blur are measured: what the pixels of its code are compared with.
 */

#include "decode/measured_ring.h"

#include <algorithm>
#include <cmath>

#include "support/sensor_range.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Ink is no darker than this share of paper, in grey levels, when its noise is asked for: a gamma above 1 would make
// that of black endless.
constexpr double darkestInk = 0.05;
} // namespace

double MeasuredRing::levelAt(const Eigen::Vector2d &place, double grey) const
{
  const double inEvenLight = uneven ? uneven->evened(place, grey) : grey;
  return 1. - photometry.blackOf(inEvenLight / whiteAt(place));
}

Photometry MeasuredRing::photometryIn(const ImageFrame &other) const
{
  const Eigen::Vector2d aside = (other.center - frame.center) / frame.size;
  const double larger = other.size / frame.size;
  const double light = photometry.relativeLightAt(aside);
  Photometry there; // of what lies around it nothing is known
  there.white = whiteAt(other.center);
  there.lightGradient = larger / light * photometry.lightGradient;
  if (photometry.lightCurvature) {
    const Eigen::Vector3d &bend = *photometry.lightCurvature;
    const Eigen::Vector2d slope(2. * bend[0] * aside.x() + bend[1] * aside.y(),
                                bend[1] * aside.x() + 2. * bend[2] * aside.y());
    there.lightGradient += larger / light * slope;
    there.lightCurvature = larger * larger / light * bend;
  }
  there.absorption = photometry.absorption;
  there.gamma = photometry.gamma;
  there.toneCurve = photometry.toneCurve;
  there.blur = photometry.blur;
  return there;
}

bool MeasuredRing::isCutOff(const Eigen::Vector2d &place, double grey) const
{
  const double white = whiteAt(place);
  return mayBeTooBright(grey) && (uneven ? uneven->uneven(place, white) : white) > brightestTold;
}

double MeasuredRing::noiseOfLevel() const
{
  const double gamma = photometry.gamma;
  const double ink = std::max(std::pow(std::max(1. - photometry.absorption, 0.), gamma), darkestInk);
  const double slope = std::max(1., std::pow(ink, 1. / gamma - 1.)) / gamma; // of the light by the grey level
  const double flattest = 1. + photometry.toneCurve.value_or(0.);            // slope of the tone curve at ink and paper
  return noise / photometry.white * slope / (photometry.absorption * flattest);
}
} // namespace circle_marker
END_VISP_NAMESPACE
