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
 * The circular marker detector follows markers from image to image.
 */

#include "vpDetectorCircleMarkerImpl.h"

#include <algorithm>

#include <visp3/core/vpException.h>
#include <visp3/core/vpImageTools.h>

#include "debug_record.h"

BEGIN_VISP_NAMESPACE

using namespace circle_marker;

namespace {
// The part of an image in a box.
void copyRegion(const vpImage<unsigned char> &I, const PixelBox &box, vpImage<unsigned char> &region)
{
  vpImageTools::crop(I, box.top, box.left, static_cast<unsigned int>(box.height()),
                     static_cast<unsigned int>(box.width()), region);
}

bool isWithin(const Eigen::Vector2d &position, const vpImage<unsigned char> &I)
{
  return position.x() >= 0. && position.y() >= 0. && position.x() < I.getWidth() && position.y() < I.getHeight();
}

// From pixels of a region to those of the image.
void moveBy(const Eigen::Vector2d &offset, EllipseCandidate &outline)
{
  outline.ellipse.center += offset;
  outline.conic = conicFromEllipse(outline.ellipse);
  for (EdgePoint &point : outline.points) {
    point.position += offset;
  }
}
} // namespace

/*!
  Looks for the markers of the last images near the places where they are expected.
  \return Whether they are all there; if not, or if it is time for it, the whole image has to be searched.
*/
bool vpDetectorCircleMarker::Impl::searchRegions(const Visit &visit)
{
  if (!settings.tracking || m_sinceWhole + 1 >= settings.fullSearchPeriod) {
    return false;
  }
  const int width = static_cast<int>(visit.I.getWidth());
  const int height = static_cast<int>(visit.I.getHeight());
  const std::vector<PixelBox> &boxes = m_tracks.predict(width, height);
  if (boxes.empty()) {
    return false;
  }
  debug = vpCircleMarkerDebug();
  searched.clear();
  for (const PixelBox &box : boxes) {
    searched.push_back(vpRect(box.left, box.top, box.width(), box.height()));
  }
  if (!followAll(visit, boxes)) {
    m_regionOutlines.clear();
    for (const PixelBox &box : boxes) {
      searchRegion(visit, box);
    }
    if (!examineRegions(visit)) {
      m_hadRegions = true;
      m_inRegions = m_seen;
      if (visit.deadline.hasPassed()) { // there is no time for more: the next image is searched whole
        m_tracks.follow(m_seen, width, height, true);
        m_sinceWhole = settings.fullSearchPeriod - 1;
        return true;
      }
      return false;
    }
  }
  m_tracks.follow(m_seen, width, height);
  ++m_sinceWhole;
  return true;
}

/*!
  Looks for the outlines of the markers where they are expected. Another edge of the print may lie there, the inner one
  of the ring or the track's; then the marker looks like one of which a part is covered.
  \return Whether all are there, and what was whole is whole.
*/
bool vpDetectorCircleMarker::Impl::followAll(const Visit &visit, const std::vector<PixelBox> &boxes)
{
  // What the rooms see is kept of a search only; and where something is lost no outline is expected.
  if (keepsDebug || m_tracks.haveLost() || !followOutlines(visit, boxes)) {
    return false;
  }
  Visit following = visit;
  following.readsWholeOnly = m_tracks.areWhole();
  return examineRegions(following) && m_tracks.haveAll(m_seen, true);
}

/*! The outlines of the regions through the rooms after them; whether all markers that are followed are there. */
bool vpDetectorCircleMarker::Impl::examineRegions(const Visit &visit)
{
  std::sort(m_regionOutlines.begin(), m_regionOutlines.end(), comesBefore);
  outlineCount = static_cast<unsigned int>(m_regionOutlines.size());
  examineAll(visit, m_regionOutlines);
  keepSeen(m_regionOutlines);
  return m_tracks.haveAll(m_seen);
}

/*!
  The outlines of the markers around where they are expected: all that a search of their regions would find of them, for
  a quarter of its time. False if one is not there.
*/
bool vpDetectorCircleMarker::Impl::followOutlines(const Visit &visit, const std::vector<PixelBox> &boxes)
{
  m_regionOutlines.clear();
  const SoughtCenters sought = soughtCenters();
  for (const PixelBox &box : boxes) {
    copyRegion(visit.I, box, m_region);
    Gradient &gradient = m_regions.full.gradient;
    gradient.noise = m_outlines.full.gradient.noise;
    computeGradient(m_region, gradient, visit.deadline, NoiseSource::KNOWN);
    const Eigen::Vector2d corner(box.left, box.top);
    for (EllipseParameters expected : m_tracks.getExpected()) {
      expected.center -= corner;
      if (!isWithin(expected.center, m_region)) {
        continue; // it is in another box
      }
      EllipseCandidate &outline = m_regionOutlines.append();
      outline.behind = HUGE_VAL;
      if (m_follower.follow(m_region, gradient, expected, sought, outline) != EllipseReject::NONE) {
        return false;
      }
      moveBy(corner, outline);
    }
  }
  return m_regionOutlines.size() == m_tracks.getExpected().size();
}

/*! A region through the rooms up to the outlines. */
void vpDetectorCircleMarker::Impl::searchRegion(const Visit &visit, const PixelBox &box)
{
  copyRegion(visit.I, box, m_region);
  m_regions.keepsRefusals(keepsDebug);
  m_regions.takeNoise(m_outlines);
  findOutlines(m_region, soughtCenters(), m_workers, visit.deadline, m_regions, NoiseSource::KNOWN);
  if (keepsDebug) {
    recordOutlines(m_regions, vpImagePoint(box.top, box.left), debug);
  }
  for (EllipseCandidate &outline : m_regions.full.ellipses.known.outlines) {
    moveBy(Eigen::Vector2d(box.left, box.top), outline);
    std::swap(m_regionOutlines.append(), outline);
  }
}

/*! Notes the markers of the image, to look for them in the next one. */
void vpDetectorCircleMarker::Impl::keepSeen(const Outlines &outlines)
{
  m_seen.clear();
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    if (m_examinations[i].isFound) {
      const Recognition &marker = m_measured[m_examinations[i].place].marker;
      const bool isWhole = marker.isCertain && !marker.seen && !marker.blurred && !isPartMissing(outlines[i].support);
      m_seen.push_back({marker.family.getType(), marker.code.id, outlines[i].ellipse, isWhole});
    }
  }
}

/*!
  After a search of the whole image, which may have been cut short. Then what was not looked for is still expected; but
  what its region was searched for in this image, and not found in, is lost. The next image is searched whole, or, if
  this one had no region searched, its regions, for which there may be time, and the one after it whole.
*/
void vpDetectorCircleMarker::Impl::followSeen(const Visit &visit)
{
  const bool isCutShort = visit.deadline.hasPassed();
  if (isCutShort) {
    for (const SeenMarker &marker : m_inRegions) {
      const bool isNew = std::none_of(m_seen.begin(), m_seen.end(), [&marker](const SeenMarker &other) {
        return other.id == marker.id && (other.outline.center - marker.outline.center).norm() < marker.outline.b;
      });
      if (isNew) {
        m_seen.push_back(marker);
      }
    }
  }
  m_tracks.follow(m_seen, static_cast<int>(visit.I.getWidth()), static_cast<int>(visit.I.getHeight()),
                  isCutShort && !m_hadRegions);
  const unsigned int period = std::max(settings.fullSearchPeriod, 2U);
  m_sinceWhole = !isCutShort ? 0 : m_hadRegions ? period - 1 : period - 2;
}

/*! The next image is searched as if it were the first. */
void vpDetectorCircleMarker::Impl::forgetTracks()
{
  m_tracks.clear();
  m_sinceWhole = 0;
  for (Impl &inverse : m_inverse) {
    inverse.forgetTracks();
  }
}

/*!
  Follows markers from image to image: their outlines are looked for where they are expected, then in regions around
  these places, which takes a fraction of the time. The whole image is searched while there is no marker, when one is
  lost, and every \e fullSearchPeriod images, so that new ones are found. A lost one is looked for where it was for 30
  images more, as long as there are others. What is found of a marker is what a search of
  the whole image finds of it, as long as the image's noise is that of the last one: it is told where the whole is
  searched, and covariance and log-odds know by it how many pixels share their noise. A search of the whole image that a
  timeout cuts short does not count: one of the next two is whole again, and markers that were not reached are not
  forgotten.

  The images must be those of one camera in their order.

  \param tracking : Whether to do so; off by default.
  \param fullSearchPeriod : Every so many images the whole one is searched; 1 for all of them.
  \exception vpException::badValue : If the period is 0.
*/
void vpDetectorCircleMarker::setTracking(bool tracking, unsigned int fullSearchPeriod)
{
  if (fullSearchPeriod == 0) {
    throw vpException(vpException::badValue, "vpDetectorCircleMarker: the whole image has to be searched every 1, 2, "
                                             "3... images, not every 0");
  }
  m_impl->settings.tracking = tracking;
  m_impl->settings.fullSearchPeriod = fullSearchPeriod;
  m_impl->forgetTracks();
}

/*!
  \return Whether markers are followed from image to image: see setTracking().
*/
bool vpDetectorCircleMarker::getTracking() const
{
  return m_impl->settings.tracking;
}

/*!
  \return Every so many images the whole one is searched where markers are followed: see setTracking().
*/
unsigned int vpDetectorCircleMarker::getFullSearchPeriod() const
{
  return m_impl->settings.fullSearchPeriod;
}

/*!
  \return Where the last image was searched for markers, pixels: the whole of it, or regions around those that are
  followed (see setTracking()).
*/
const std::vector<vpRect> &vpDetectorCircleMarker::getSearchedRegions() const
{
  return m_impl->searched;
}

END_VISP_NAMESPACE
