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
 * Why a candidate was not taken for a circular marker.
 */

/*!
  \file vpCircleMarkerReject.h
  \brief Why a candidate was not taken for a circular marker.
*/

#ifndef VP_CIRCLE_MARKER_REJECT_H
#define VP_CIRCLE_MARKER_REJECT_H

#include <string>

#include <visp3/circle_marker/vpConfigCircleMarker.h>

BEGIN_VISP_NAMESPACE

/*!
  \ingroup group_circle_marker
  \brief Why a candidate was not taken for a marker. Of an outline's reasons for being no marker of a family, the later
  ones are of candidates that have more of a marker.
*/
enum class vpCircleMarkerReject
{
  NONE, //!< It was taken.
  // A chain of edge pixels that is no outline
  TOO_SHORT,       //!< Too few edge points.
  LITTLE_BEND,     //!< No piece of it bends enough to fix an ellipse.
  BRIGHT_INSIDE,   //!< The outline of something bright, or no outline at all.
  NOT_AN_ELLIPSE,  //!< No ellipse fits, or its axes are out of bounds.
  BAD_FIT,         //!< The points lie too far from the ellipse.
  LITTLE_SUPPORT,  //!< Too small a part of the ellipse has an edge in the image.
  NOT_DARK_INSIDE, //!< There is no dark band along the inside of the ellipse.
  OTHER_CENTER,    //!< Its centre is not as bright, or as dark, as that of the markers sought.
  KNOWN_OUTLINE,   //!< An outline that another chain, or another scale of the image, has given already.
  // An outline that is no marker of a family
  NO_POSE,            //!< No circle in front of the camera has this image.
  INSIDE_OF_A_MARKER, //!< A piece of a marker that was found: its ring again, or a sector of its code.
  TOO_SMALL,          //!< Too few pixels for the family's code or shape.
  OUT_OF_IMAGE,       //!< It reaches out of the image.
  NO_RING,            //!< No dark ring between white and white.
  OTHER_SHAPE,        //!< A disc where a ring is sought, or a ring where a disc is.
  NOT_ALL_AROUND,     //!< Without a code: the ring or disc does not show in all directions.
  NO_SECTORS,         //!< The code track is not made of black and white sectors.
  NO_CODEWORD,        //!< The sectors are no codeword, nor near enough to one.
  MIRRORED,           //!< The sectors are a codeword's in the other direction: a mirror, or an image that is flipped.
  LOW_MARGIN,         //!< The sectors agree too little with the nearest codeword.
  // A marker whose pose was refined
  UNLIKE_THE_MODEL, //!< The image does not look like the marker at any pose near by.
  TOO_MANY,         //!< Its code is in doubt, or it is covered, and too many that looked more like one were none.
  // Anything
  TIMEOUT //!< There was no time left to look.
};

/*! \return The reason's name in lower case with spaces, for instance "low margin". */
VISP_EXPORT std::string vpCircleMarkerRejectName(vpCircleMarkerReject reason);

END_VISP_NAMESPACE

#endif
