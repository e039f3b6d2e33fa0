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
 * Where the markers of the last images will be in the next one.
 */

#include "track/marker_tracks.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Room around the predicted outline: a few pixels for the edge, its blur and the search along its normal, a share of
// the ring's radius (its quiet zone has a sixth), and of the way it made since the image before.
constexpr double leastMargin = 8.;
constexpr double marginOfRadius = 0.25;
constexpr double marginOfSpeed = 0.5;
// A marker whose speed is not known may move by this share of its radius more.
constexpr double marginWithoutSpeed = 0.5;
// So many radii from where it is expected a marker with a code is known again: markers stand two apart at least.
constexpr double reachWithCode = 3.;
// An outline that comes nearer to the side of its box, pixels, may be a piece of a larger one.
constexpr double clearOfSide = 4.;
// Corners of boxes are multiples of this: the quarter-size image starts its chains on every second row.
constexpr int grid = 8;
// A lost marker is looked for where it was in as many images, a second of most cameras: a hand or a blur passes.
constexpr unsigned int mostMissed = 30;
// Beyond this share of the image, boxes take as long as the whole.
constexpr double mostOfImage = 0.6;

int roundedDown(int value)
{
  return value - value % grid;
}

bool touch(const PixelBox &p, const PixelBox &q)
{
  return p.left <= q.right && q.left <= p.right && p.top <= q.bottom && q.top <= p.bottom;
}

} // namespace

PixelBox boxAround(const EllipseParameters &ellipse, double margin, int width, int height)
{
  const Eigen::Vector2d half = halfExtents(ellipse) + Eigen::Vector2d::Constant(margin);
  return {pixelWithin(ellipse.center.x() - half.x(), width), pixelWithin(ellipse.center.y() - half.y(), height),
          pixelWithin(ellipse.center.x() + half.x() + 1., width),
          pixelWithin(ellipse.center.y() + half.y() + 1., height)};
}

// The outline in the next image, if it goes on as it did; the speed of its turn is not known.
EllipseParameters MarkerTracks::Track::expected() const
{
  EllipseParameters outline = marker.outline;
  outline.center += speed;
  const double scale = std::max(1. + growth / outline.a, 0.5);
  outline.a *= scale;
  outline.b *= scale;
  return outline;
}

// How far the marker may be from where it is expected, pixels.
double MarkerTracks::Track::slack() const
{
  return hasSpeed ? marginOfSpeed * speed.norm() : marginWithoutSpeed * marker.outline.a;
}

double MarkerTracks::Track::distanceTo(const SeenMarker &other) const
{
  return (marker.outline.center + speed - other.outline.center).norm();
}

// Whether it may be this marker that is seen there. One with a code is known again farther away; beyond that it has not
// moved but jumped, which is no speed to go on with.
bool MarkerTracks::Track::mayBe(const SeenMarker &other) const
{
  const double reach = marker.id >= 0 ? reachWithCode : 1.;
  return marker.family == other.family && marker.id == other.id &&
         distanceTo(other) < reach * marker.outline.a + slack();
}

void MarkerTracks::clear()
{
  m_tracks.clear();
}

// Of a marker with a code that turns up elsewhere nothing is left where it was.
void MarkerTracks::forget(const SeenMarker &marker)
{
  for (Track &old : m_before) {
    old.isSeen = old.isSeen || (old.marker.family == marker.family && old.marker.id == marker.id);
  }
}

void MarkerTracks::follow(const std::vector<SeenMarker> &seen, int width, int height, bool isCutShort)
{
  m_width = width;
  m_height = height;
  std::swap(m_before, m_tracks);
  m_tracks.clear();
  for (const SeenMarker &marker : seen) {
    Track track;
    track.marker = marker;
    Track *nearest = nullptr;
    for (Track &old : m_before) {
      if (old.mayBe(marker) && (nearest == nullptr || old.distanceTo(marker) < nearest->distanceTo(marker))) {
        nearest = &old;
      }
    }
    if (nearest != nullptr) {
      nearest->isSeen = true;
      if (!nearest->isLost()) { // else it is the way of many images, and nobody knows how it was made
        track.hasSpeed = true;
        track.speed = marker.outline.center - nearest->marker.outline.center;
        track.growth = marker.outline.a - nearest->marker.outline.a;
      }
    }
    else if (marker.id >= 0 && !isCutShort) { // it has jumped to here, and is not where it was
      forget(marker);
    }
    m_tracks.push_back(track);
  }
  for (Track &old : m_before) {
    const EllipseParameters expected = old.expected();
    const bool isInside = expected.center.x() >= 0. && expected.center.y() >= 0. && expected.center.x() < width &&
                          expected.center.y() < height;
    if (!isInside || old.missed >= mostMissed || old.isSeen) {
      continue;
    }
    old.marker.outline = expected;
    if (!isCutShort) { // where it goes from there nobody knows
      ++old.missed;
      old.hasSpeed = false;
      old.speed.setZero();
      old.growth = 0.;
    }
    m_tracks.push_back(old);
  }
}

const std::vector<PixelBox> &MarkerTracks::predict(int width, int height)
{
  m_boxes.clear();
  m_expected.clear();
  if (width != m_width || height != m_height) {
    return m_boxes;
  }
  if (std::all_of(m_tracks.begin(), m_tracks.end(), std::mem_fn(&Track::isLost))) { // then the whole image is looked at
    return m_boxes;
  }
  for (const Track &track : m_tracks) {
    addBox(track, width, height);
  }
  mergeBoxes();
  if (haveLost() && areaOfBoxes() > mostOfImage * width * height) {
    m_tracks.erase(std::remove_if(m_tracks.begin(), m_tracks.end(), std::mem_fn(&Track::isLost)), m_tracks.end());
    return predict(width, height);
  }
  if (areaOfBoxes() > mostOfImage * width * height) {
    m_boxes.clear();
  }
  return m_boxes;
}

// The box of one marker, unless it is on its way out of the image.
void MarkerTracks::addBox(const Track &track, int width, int height)
{
  EllipseParameters predicted = track.marker.outline;
  predicted.center += track.speed;
  const double margin = leastMargin + marginOfRadius * predicted.a + track.slack() + std::max(2. * track.growth, 0.);
  PixelBox box = boxAround(predicted, margin, width, height);
  box.left = roundedDown(box.left);
  box.top = roundedDown(box.top);
  box.right = std::min(roundedDown(box.right + grid - 1), width);
  box.bottom = std::min(roundedDown(box.bottom + grid - 1), height);
  constexpr int leastSide = 16; // pixels
  if (box.width() >= leastSide && box.height() >= leastSide) {
    m_boxes.push_back(box);
    if (!track.isLost()) {
      m_expected.push_back(track.expected());
    }
  }
}

double MarkerTracks::areaOfBoxes() const
{
  return std::accumulate(m_boxes.begin(), m_boxes.end(), 0., [](double sum, const PixelBox &box) {
    return sum + static_cast<double>(box.width()) * box.height();
  });
}

// Makes one of any two boxes that touch, until none do.
void MarkerTracks::mergeBoxes()
{
  for (std::size_t i = 0; i < m_boxes.size();) {
    const auto other = std::find_if(m_boxes.begin() + static_cast<std::ptrdiff_t>(i) + 1, m_boxes.end(),
                                    [&](const PixelBox &box) { return touch(m_boxes[i], box); });
    if (other == m_boxes.end()) {
      ++i;
      continue;
    }
    PixelBox &box = m_boxes[i];
    box = {std::min(box.left, other->left), std::min(box.top, other->top), std::max(box.right, other->right),
           std::max(box.bottom, other->bottom)};
    *other = m_boxes.back();
    m_boxes.pop_back();
    i = 0; // the larger box may touch one that was passed
  }
}

// Whether an outline lies within one box, off those of its sides that are not the image's own.
bool MarkerTracks::isInTheOpen(const EllipseParameters &outline) const
{
  const PixelBox around = boxAround(outline, clearOfSide, m_width, m_height);
  return std::any_of(m_boxes.begin(), m_boxes.end(), [&](const PixelBox &box) {
    return around.left >= box.left && around.top >= box.top && around.right <= box.right && around.bottom <= box.bottom;
  });
}

bool MarkerTracks::haveLost() const
{
  return std::any_of(m_tracks.begin(), m_tracks.end(), std::mem_fn(&Track::isLost));
}

bool MarkerTracks::areWhole() const
{
  return std::all_of(m_tracks.begin(), m_tracks.end(),
                     [](const Track &track) { return track.isLost() || track.marker.isWhole; });
}

bool MarkerTracks::haveAll(const std::vector<SeenMarker> &seen, bool mustBeWhole) const
{
  const auto isSeen = [&](const Track &track) {
    return track.isLost() || std::any_of(seen.begin(), seen.end(), [&](const SeenMarker &marker) {
             return track.mayBe(marker) && (marker.isWhole || !track.marker.isWhole || !mustBeWhole);
           });
  };
  const auto lost =
      static_cast<std::size_t>(std::count_if(m_tracks.begin(), m_tracks.end(), std::mem_fn(&Track::isLost)));
  return seen.size() + lost >= m_tracks.size() && std::all_of(m_tracks.begin(), m_tracks.end(), isSeen) &&
         std::all_of(seen.begin(), seen.end(), [&](const SeenMarker &marker) { return isInTheOpen(marker.outline); });
}
} // namespace circle_marker
END_VISP_NAMESPACE
