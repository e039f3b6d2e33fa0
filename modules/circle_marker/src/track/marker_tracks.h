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

#ifndef VP_CIRCLE_MARKER_MARKER_TRACKS_H
#define VP_CIRCLE_MARKER_MARKER_TRACKS_H

#include <vector>

#include <visp3/circle_marker/vpCircleMarkerFamily.h>

#include "ellipse/conic.h"
#include "support/pixel_box.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! The smallest box around an ellipse, with a margin around it, cut at the image's border; empty if it is outside. */
PixelBox boxAround(const EllipseParameters &ellipse, double margin, int width, int height);

/*! A marker in an image, as far as it matters here. */
struct SeenMarker
{
  vpCircleMarkerFamily::vpType family = vpCircleMarkerFamily::GOLAY23;
  int id = -1;               //!< -1 without a code.
  EllipseParameters outline; //!< Pixels.
  bool isWhole = true;       //!< Whether it was read for certain, with nothing in front of it.
};

/*!
  The markers of the last images and where to look for them in the next: around the place to which each moves on at the
  speed it had, with room for a change of it.
*/
class MarkerTracks
{
public:
  /*! Forgets all markers. */
  void clear();

  /*!
    Takes note of the markers of an image, all of them. Those that are not among them are lost: they are looked for
    where they were, for some images more, and not waited for.
    \param seen : The markers.
    \param width, height : Of the image, pixels.
    \param isCutShort : Whether there was no time to look for all: then those that were not seen are still expected.
  */
  void follow(const std::vector<SeenMarker> &seen, int width, int height, bool isCutShort = false);

  /*!
    Where to look in the next image. No two of the boxes touch, and their corners are multiples of eight pixels, so that
    the rooms, which halve images and leave out rows, see in them what they would see in the whole image.
    \param width, height : Of the image; another size than that of the last one has no boxes.
    \return Empty if there is nothing to follow, or so much that looking at the whole image takes no longer.
  */
  const std::vector<PixelBox> &predict(int width, int height);

  /*! The outlines that are expected in the boxes of the last predict(), pixels of the image. */
  const std::vector<EllipseParameters> &getExpected() const { return m_expected; }

  /*! Whether there are boxes of lost markers, too: no outline is expected in them. */
  bool haveLost() const;

  /*! Whether all that are followed were whole: then so they are where they are expected, or it is something else. */
  bool areWhole() const;

  /*!
    Whether all markers that are followed are among those seen in the boxes, in one piece: an outline that comes near to
    the side of its box may go on beyond it.
    \param seen : The markers that are seen.
    \param mustBeWhole : Whether one that was whole has to be whole again.
  */
  bool haveAll(const std::vector<SeenMarker> &seen, bool mustBeWhole = false) const;

private:
  /*! One marker. */
  struct Track
  {
    SeenMarker marker;             //!< As it was seen last.
    bool hasSpeed = false;         //!< Whether it was there in the image before, too.
    Eigen::Vector2d speed{0., 0.}; //!< Of its centre, pixels an image.
    double growth = 0.;            //!< Of its semi-major axis, pixels an image.
    unsigned int missed = 0;       //!< Images since it was seen.
    bool isSeen = false;           //!< Whether a marker of the next image is taken for it.

    /*! Whether it was not there in the last image. */
    bool isLost() const { return missed > 0; }

    EllipseParameters expected() const;
    double slack() const;
    double distanceTo(const SeenMarker &other) const;
    bool mayBe(const SeenMarker &other) const;
  };

  void forget(const SeenMarker &marker);
  bool isInTheOpen(const EllipseParameters &outline) const;
  void addBox(const Track &track, int width, int height);
  double areaOfBoxes() const;
  void mergeBoxes();

  std::vector<Track> m_tracks;               //!< The markers of the last image.
  std::vector<Track> m_before;               //!< Those before them, and memory for the next.
  std::vector<PixelBox> m_boxes;             //!< Where they are looked for.
  std::vector<EllipseParameters> m_expected; //!< Their outlines there.
  int m_width = 0;                           //!< Of the images, pixels.
  int m_height = 0;                          //!< Of the images, pixels.
};
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
