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
 * Results of the circular marker detector.
 */

#include "vpDetectorCircleMarkerImpl.h"

#include <cmath>

#include <visp3/core/vpException.h>

BEGIN_VISP_NAMESPACE

/*!
  \return What the last call of detect() found, in the order of the messages and polygons.
*/
const std::vector<vpCircleMarkerDetection> &vpDetectorCircleMarker::getDetections() const
{
  return m_impl->detections;
}

/*!
  \return Image of the centre of a marker, pixels. It is neither the centre of its ellipse nor getCog().
  \exception vpException::badValue : If there is no such marker.
*/
vpImagePoint vpDetectorCircleMarker::getCenter(size_t index) const
{
  return m_impl->at(index).detection.center;
}

/*!
  \return 6 x 6 covariance of a marker's pose: see vpCircleMarkerDetection. It is that of the last detect(), with the
  size and the camera that it was given: for those of getPose() see there.
  \exception vpException::badValue : If there is no such marker.
*/
vpMatrix vpDetectorCircleMarker::getCovariance(size_t index) const
{
  return m_impl->at(index).detection.covariance;
}

/*!
  \return ln(likelihood of the first pose / likelihood of the second) of the last detect(), HUGE_VAL if there is no
  second one. Of the poses of getPose() it is the difference of their projErrors.
  \exception vpException::badValue : If there is no such marker.
*/
double vpDetectorCircleMarker::getLogOdds(size_t index) const
{
  return m_impl->at(index).detection.logOdds;
}

/*!
  \return How clearly the code was read, from 0 to 1 (1 without a code): of one that was read sector by sector the mean
  agreement of its sectors with the codeword (each black or white as that has it); of a covered marker the share of the
  sectors that are told and agree, less those that do not; of one that was read through a blur 1 - what its codeword
  leaves unexplained over what the next one leaves. A small marker whose code is proven as a whole has that of its first
  reading, which may be below the least one.
  \exception vpException::badValue : If there is no such marker.
*/
double vpDetectorCircleMarker::getMargin(size_t index) const
{
  return m_impl->at(index).detection.margin;
}

/*!
  \return Number of ellipses of the last image that might have been a marker's ring, before the codes were read.
*/
unsigned int vpDetectorCircleMarker::getNbOutlines() const
{
  return m_impl->outlineCount;
}

/*!
  \return Whether the time of setTimeout() was over before the last detect() ended, so that markers of the image may be
  missing. Where it was over during the very last steps none is.
*/
bool vpDetectorCircleMarker::hasTimedOut() const
{
  return m_impl->hasTimedOut;
}

/*!
  \return Number of sectors of the code that were read otherwise and had to be corrected. 0 of one whose sectors are too
  small to be read one by one; sectors that were not seen do not count.
  \exception vpException::badValue : If there is no such marker.
*/
unsigned int vpDetectorCircleMarker::getHammingDistance(size_t index) const
{
  return m_impl->at(index).detection.hamming;
}

/*!
  \return Identity of each marker in its family; -1 without a code. Where several families are looked for,
  getDetections() tells which it is. Named as in vpDetectorAprilTag.
*/
std::vector<int> vpDetectorCircleMarker::getTagsId() const
{
  std::vector<int> ids;
  for (const vpCircleMarkerDetection &detection : m_impl->detections) {
    ids.push_back(detection.id);
  }
  return ids;
}

/*!
  \return For each marker, 36 points along the image of its outer edge, pixels, of which getTagsPoints3D() tells the
  places in the marker frame. They follow each other clockwise as the image is seen, from the marker's x axis on. Named
  as in vpDetectorAprilTag, whose tags have four corners that follow each other counterclockwise.
*/
std::vector<std::vector<vpImagePoint>> vpDetectorCircleMarker::getTagsCorners() const
{
  return m_polygon;
}

/*!
  Where the points of getTagsCorners() are in the marker frame, metres, by the convention that
  setZAlignedWithCameraAxis() says now: it has to be that of the last detect(). The first is on its x axis, and they
  follow each other clockwise as a viewer sees the print. Named as in vpDetectorAprilTag.

  \param tagsId : Identities of the markers: getTagsId().
  \param tagsSize : Outer diameter of the ring, metres, by identity; that of -1 is for all that are not named.
  \return For each marker, as many points as it has in getTagsCorners(), in the same order.
  \exception vpException::badValue : If a marker has no size, or one that is not positive.
*/
std::vector<std::vector<vpPoint>> vpDetectorCircleMarker::getTagsPoints3D(const std::vector<int> &tagsId,
                                                                          const std::map<int, double> &tagsSize) const
{
  const double down = m_impl->settings.zAlignedWithCameraAxis ? 1. : -1.; // the y axis seen by a viewer
  std::vector<std::vector<vpPoint>> markers;
  for (const int id : tagsId) {
    auto size = tagsSize.find(id);
    if (size == tagsSize.end()) {
      size = tagsSize.find(-1);
    }
    if (size == tagsSize.end()) {
      throw vpException(vpException::badValue,
                        "vpDetectorCircleMarker: the marker with id %d has no size, nor is there one for all (id -1)",
                        id);
    }
    circle_marker::checkMarkerSize(size->second);
    std::vector<vpPoint> points;
    for (unsigned int i = 0; i < Impl::polygonPoints; ++i) {
      const double angle = 2. * M_PI * i / Impl::polygonPoints;
      points.emplace_back(0.5 * size->second * std::cos(angle), 0.5 * size->second * down * std::sin(angle), 0.);
    }
    markers.push_back(points);
  }
  return markers;
}

/*!
  \return For each marker, the number of corrected sectors. Named as in vpDetectorAprilTag.
*/
std::vector<int> vpDetectorCircleMarker::getTagsHammingDistance() const
{
  std::vector<int> distances;
  for (const vpCircleMarkerDetection &detection : m_impl->detections) {
    distances.push_back(static_cast<int>(detection.hamming));
  }
  return distances;
}

/*!
  \return For each marker, its decision margin: see getMargin(). Named as in vpDetectorAprilTag.
*/
std::vector<float> vpDetectorCircleMarker::getTagsDecisionMargin() const
{
  std::vector<float> margins;
  for (const vpCircleMarkerDetection &detection : m_impl->detections) {
    margins.push_back(static_cast<float>(detection.margin));
  }
  return margins;
}

END_VISP_NAMESPACE
