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
 * Small dark dots of an image.
 */

/*!
  \file edges/dark_dots.h
  \brief Dots that are darker than all around.
*/

#ifndef VP_CIRCLE_MARKER_DARK_DOTS_H
#define VP_CIRCLE_MARKER_DARK_DOTS_H

#include <vector>

#include <Eigen/Core>

#include <visp3/circle_marker/vpConfigCircleMarker.h>
#include <visp3/core/vpImage.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  A dark dot some pixels wide, such as either end of a ring that is seen from nearly the side: along the ring's long
  sides its black is thinner than the blur, at the ends of the longer axis it is several times as long as it is wide.
*/
struct DarkDot
{
  Eigen::Vector2d place; //!< Where it is darkest, to a fraction of a pixel.
  double grey = 0.;      //!< Grey level there.
  double depth = 0.;     //!< By how much the brightest pixel around it is brighter.
};

/*! Rows at either end of an image, and columns, that have no dots. */
constexpr int dotReach = 3;

/*!
  Finds the dots of some rows, one after the other, from the left to the right.
  \param I : The image.
  \param firstRow, endRow : The rows, from dotReach to height - dotReach.
  \param rise : By how much a dot is darker than what is two or three pixels away, in each of eight directions: grey
  levels, 1 to 255.

  \param dots : They are appended.
*/
void findDarkDots(const vpImage<unsigned char> &I, int firstRow, int endRow, int rise, std::vector<DarkDot> &dots);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
