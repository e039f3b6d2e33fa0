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
 * What was found, drawn over the image.
 */

#include "marker_overlay.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include <visp3/core/vpColVector.h>
#include <visp3/core/vpImageConvert.h>
#include <visp3/core/vpMatrix.h>

#include "../draw.h"

namespace tutorial {
namespace {
double variance(const vpMatrix &covariance, const vpColVector &direction)
{
  return std::max(0., vpColVector::dotProd(direction, covariance * direction));
}

/*! The greatest standard deviation of a 3 x 3 covariance across a direction of length one. */
double greatestAcross(const vpMatrix &covariance, const vpColVector &direction)
{
  // Any vector that is not along the direction gives two that are across it.
  const vpColVector helper(
      std::vector<double>{std::abs(direction[0]) < 0.9 ? 1. : 0., std::abs(direction[0]) < 0.9 ? 0. : 1., 0.});
  vpColVector a = vpColVector::crossProd(direction, helper);
  a.normalize();
  const vpColVector b = vpColVector::crossProd(direction, a);
  const double aa = variance(covariance, a), bb = variance(covariance, b);
  const double ab = vpColVector::dotProd(a, covariance * b);
  // The greater eigenvalue of the 2 x 2 covariance.
  return std::sqrt(0.5 * (aa + bb) + std::hypot(0.5 * (aa - bb), ab));
}

std::string firstLine(const vpCircleMarkerDetection &detection)
{
  std::ostringstream text;
  if (detection.family.isCoded()) {
    text << "id " << detection.id << "  ";
  }
  text << std::fixed << std::setprecision(3) << detection.cMo.getTranslationVector().frobeniusNorm() << " m";
  return text.str();
}

/*! Standard deviations; the fonts have no Greek letters. */
std::string deviationLine(const vpCircleMarkerDetection &detection)
{
  const PoseDeviation deviation = poseDeviation(detection);
  std::ostringstream text;
  text << std::setprecision(2) << "sd " << 1e3 * deviation.lateral << " mm, depth " << 1e3 * deviation.depth
       << " mm, normal " << deviation.normal * 180. / M_PI << " deg";
  return text.str();
}

std::string secondPoseLine(const vpCircleMarkerDetection &detection)
{
  if (!detection.hasSecondPose) {
    return "one pose";
  }
  std::ostringstream text;
  text << std::setprecision(3) << "second pose: log-odds " << detection.logOdds;
  return text.str();
}
} // namespace

PoseDeviation poseDeviation(const vpCircleMarkerDetection &detection)
{
  const vpTranslationVector t = detection.cMo.getTranslationVector();
  const vpMatrix covariance = detection.covarianceAtMarker;
  const vpMatrix place = covariance.extract(0, 0, 3, 3);
  const vpMatrix turn = covariance.extract(3, 3, 3, 3);
  vpColVector sight(std::vector<double>{t[0], t[1], t[2]});
  sight.normalize();
  const vpColVector normal(std::vector<double>{detection.cMo[0][2], detection.cMo[1][2], detection.cMo[2][2]});
  return PoseDeviation{greatestAcross(place, sight), std::sqrt(variance(place, sight)), greatestAcross(turn, normal)};
}

vpImage<vpRGBa> markerOverlay(const vpImage<unsigned char> &I, const std::vector<vpCircleMarkerDetection> &detections,
                              const vpCameraParameters &cam, const OverlayDetails &details)
{
  vpImage<vpRGBa> picture;
  vpImageConvert::convert(I, picture);
  // Pictures this wide are looked at scaled down.
  const bool isWide = I.getWidth() > 1000;
  const unsigned int thickness = isWide ? 2 : 1;
  const double lineHeight = isWide ? 28. : 20.; // pixels; see drawText
  for (const vpCircleMarkerDetection &detection : detections) {
    if (details.secondPose && detection.hasSecondPose) {
      drawAxes(picture, detection.cMo2, cam, 0.5 * detection.size, vpColor::orange, thickness);
    }
    drawRing(picture, detection.cMo, cam, 0.5 * detection.size, vpColor::green, thickness);
    drawAxes(picture, detection.cMo, cam, 0.5 * detection.size, vpColor::none, thickness + 1);
    drawMark(picture, detection.center, vpColor::yellow);
    vpImagePoint corner = detection.center + vpImagePoint(detection.ellipse.a + 4., -detection.ellipse.a);
    drawText(picture, firstLine(detection), corner);
    if (details.uncertainty) {
      corner += vpImagePoint(lineHeight, 0.);
      drawText(picture, deviationLine(detection), corner);
    }
    if (details.secondPose) {
      corner += vpImagePoint(lineHeight, 0.);
      drawText(picture, secondPoseLine(detection), corner);
    }
  }
  return picture;
}
} // namespace tutorial
