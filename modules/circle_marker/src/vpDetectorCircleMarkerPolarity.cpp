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
 * Markers that are white on black: they are looked for in the negative of the image.
 */

#include "vpDetectorCircleMarkerImpl.h"

#include <algorithm>
#include <cmath>

BEGIN_VISP_NAMESPACE

using namespace circle_marker;

namespace {
void negate(const vpImage<unsigned char> &I, vpImage<unsigned char> &negative)
{
  constexpr int white = 255;
  negative.resize(I.getHeight(), I.getWidth());
  std::transform(I.bitmap, I.bitmap + I.getSize(), negative.bitmap,
                 [](unsigned char grey) { return static_cast<unsigned char>(white - grey); });
}
} // namespace

/*!
  Looks for the markers of the polarities that are set. In the negative of the image, markers that are white on black
  are as others are; a detector of its own looks at it, so that each follows its own markers.
*/
void vpDetectorCircleMarker::Impl::detect(const vpImage<unsigned char> &I, double size, const vpCameraParameters &cam,
                                          bool isCameraGuessed, const Deadline &deadline)
{
  const bool both = settings.polarity == vpCircleMarkerPolarity::BOTH;
  if (settings.polarity == vpCircleMarkerPolarity::BLACK_ON_WHITE) {
    m_inverse.clear();
    detectBlack(I, size, cam, isCameraGuessed, deadline);
    return;
  }
  if (m_inverse.empty()) {
    m_inverse.emplace_back();
  }
  Impl &inverse = m_inverse.front();
  inverse.settings = settings;
  inverse.database = database;
  inverse.keepsDebug = keepsDebug;
  negate(I, m_negative);
  // Who comes second has what the first leaves of a timeout: none, where there is much to look at.
  m_isInverseFirst = both && !m_isInverseFirst;
  if (both && !m_isInverseFirst) {
    detectBlack(I, size, cam, isCameraGuessed, deadline);
  }
  inverse.detectBlack(m_negative, size, cam, isCameraGuessed, deadline);
  if (m_isInverseFirst) {
    detectBlack(I, size, cam, isCameraGuessed, deadline);
  }
  if (!both) {
    found.clear();
    detections.clear();
    outlineCount = 0;
    debug = vpCircleMarkerDebug();
    searched.clear();
  }
  addInverse(inverse);
}

/*!
  Takes what is a piece of a white marker out of what was found. The black inside of a white ring looks like a disc: it
  is the ring of the family's ratio that is seen, at another distance. And what is black between the ring and the code
  looks like a ring.
*/
void vpDetectorCircleMarker::Impl::dropPiecesOf(const Found &inverse)
{
  constexpr double mostOff = 0.05; // outer radii
  const EllipseParameters &outer = inverse.outline.ellipse;
  const vpCircleMarkerFamily &family = inverse.marker.family;
  const auto isPiece = [&](const Found &other) {
    const EllipseParameters &outline = other.outline.ellipse;
    const double off = (outline.center - outer.center).norm();
    const bool isInCode = family.isCoded() && !other.marker.family.isCoded() && off < outer.b && outline.a < outer.a;
    const bool isInRing = family.getType() == vpCircleMarkerFamily::RING &&
                          other.marker.family.getType() == vpCircleMarkerFamily::DISC && off < mostOff * outer.a &&
                          std::abs(outline.a - family.getLayout().ringInner * outer.a) < mostOff * outer.a;
    return isInCode || isInRing;
  };
  for (std::size_t k = found.size(); k-- > 0;) {
    if (isPiece(found[k])) {
      found.erase(found.begin() + static_cast<std::ptrdiff_t>(k));
      detections.erase(detections.begin() + static_cast<std::ptrdiff_t>(k));
    }
  }
}

/*!
  Adds what a detector found in the negative, but for what is a piece of a marker that was found already: between its
  black ring and the dark ground under it, round paper is a white ring on black.
*/
void vpDetectorCircleMarker::Impl::addInverse(Impl &inverse)
{
  for (const Found &marker : inverse.found) {
    dropPiecesOf(marker);
  }
  const std::size_t own = found.size();
  const auto isPiece = [&](const Found &marker) {
    return std::any_of(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(own), [&](const Found &other) {
      const EllipseParameters &outline = other.outline.ellipse;
      return (marker.outline.ellipse.center - outline.center).norm() < outline.b && !marker.marker.family.isCoded();
    });
  };
  for (Found &marker : inverse.found) {
    if (!isPiece(marker)) {
      marker.detection.isInverse = true;
      detections.push_back(marker.detection);
      found.push_back(marker);
    }
  }
  outlineCount += inverse.outlineCount;
  searched.insert(searched.end(), inverse.searched.begin(), inverse.searched.end());
  for (vpCircleMarkerCandidate &candidate : inverse.debug.candidates) {
    candidate.isInverse = true;
  }
  for (vpCircleMarkerDebug::Scale &scale : inverse.debug.scales) {
    scale.isInverse = true;
  }
  debug.candidates.insert(debug.candidates.end(), inverse.debug.candidates.begin(), inverse.debug.candidates.end());
  debug.scales.insert(debug.scales.end(), inverse.debug.scales.begin(), inverse.debug.scales.end());
}

/*!
  Sets whether markers are looked for that are black on white, white on black, or both. Both take twice the time of one;
  an inverse marker needs a black quiet zone as others need a white one. If that is more than the time of setTimeout(),
  they take turns: in every second image white ones are looked for first.

  \param polarity : Which markers are looked for; vpCircleMarkerPolarity::BLACK_ON_WHITE by default.
*/
void vpDetectorCircleMarker::setPolarity(vpCircleMarkerPolarity polarity)
{
  m_impl->settings.polarity = polarity;
  m_impl->forgetTracks();
}

/*!
  \return Which markers are looked for.
*/
vpCircleMarkerPolarity vpDetectorCircleMarker::getPolarity() const
{
  return m_impl->settings.polarity;
}

END_VISP_NAMESPACE
