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
 * What the rooms of the circular marker detector saw in an image, to be looked at.
 */

/*!
  \file vpCircleMarkerDebug.h
  \brief What the rooms of the circular marker detector saw in an image, to be looked at.
*/

#ifndef VP_CIRCLE_MARKER_DEBUG_H
#define VP_CIRCLE_MARKER_DEBUG_H

#include <string>
#include <vector>

#include <visp3/circle_marker/vpCircleMarkerDetection.h>
#include <visp3/circle_marker/vpCircleMarkerReject.h>
#include <visp3/core/vpImage.h>

BEGIN_VISP_NAMESPACE

/*!
  \struct vpCircleMarkerCandidate
  \ingroup group_circle_marker
  \brief Something that might have been a marker, and what became of it: see vpDetectorCircleMarker::setDebug().

  A candidate is a chain of edge pixels, or a piece of one, until an outline is made of it (reasons up to
  vpCircleMarkerReject::KNOWN_OUTLINE); then an outline that is tried as a marker of a family.
*/
struct VISP_EXPORT vpCircleMarkerCandidate
{
  /*! A sector of the code track as it was read. */
  struct Sector
  {
    vpImagePoint center; //!< Of the sector, pixels.
    double black = 0.;   //!< From -1, white, to 1, black.
  };

  vpCircleMarkerReject reason = vpCircleMarkerReject::NONE; //!< Why it is no marker; NONE if it is one.
  std::vector<vpImagePoint> points;                         //!< Its edge points, pixels.
  vpImageEllipse ellipse;                                   //!< Its ellipse; a = 0 if there is none.
  bool isOutline = false;                                   //!< Whether it was tried as a marker of a family.
  vpCircleMarkerFamily family;                              //!< The family, if it was.
  std::vector<Sector> sectors;                              //!< The code as it was read; empty if it was not.
  int id = -1;                                              //!< The nearest codeword's; -1 without one.
  unsigned int hamming = 0;                                 //!< How many sectors it corrects.
  double margin = 0.;                                       //!< Decision margin: see getMargin().
  bool isInverse = false;                                   //!< Whether it was seen in the negative: white on black.

  std::string getText() const;
};

/*!
  \struct vpCircleMarkerDebug
  \ingroup group_circle_marker
  \brief What the rooms of vpDetectorCircleMarker saw in an image: see vpDetectorCircleMarker::setDebug().
*/
struct vpCircleMarkerDebug
{
  /*! The image, or a region of it, in the first rooms, at full size, at half or at a quarter. */
  struct Scale
  {
    vpImagePoint origin;                           //!< Pixel (0, 0) of this scale covers the image from here on.
    double pixel = 1.;                             //!< Side of a pixel of this scale, pixels of the image: 1, 2 or 4.
    double noise = 0.;                             //!< Standard deviation of the noise, grey levels.
    double leastStart = 0.;                        //!< Step of an edge that starts a chain, grey levels.
    double leastStep = 0.;                         //!< Step of an edge that continues one, grey levels.
    vpImage<unsigned char> edges;                  //!< 2 where a chain may start, 1 where it may go on, 0 elsewhere.
    std::vector<std::vector<vpImagePoint>> chains; //!< Chains of edge pixels, pixels of the image.
    bool isInverse = false;                        //!< Whether it is of the negative, for markers white on black.
  };

  std::vector<Scale> scales; //!< Full size, half, quarter, of each region that was searched, and of the negative.
  std::vector<vpCircleMarkerCandidate> candidates; //!< In the order in which the rooms settle them; markers, too.
};

END_VISP_NAMESPACE

#endif
