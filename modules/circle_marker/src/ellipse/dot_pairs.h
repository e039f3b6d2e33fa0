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
 * The ring whose two ends are two dark dots.
 */

/*!
  \file ellipse/dot_pairs.h
  \brief The ring whose two ends are two dark dots.
*/

#ifndef VP_CIRCLE_MARKER_DOT_PAIRS_H
#define VP_CIRCLE_MARKER_DOT_PAIRS_H

#include <optional>

#include <visp3/core/vpImage.h>

#include "edges/dark_dots.h"
#include "ellipse/conic.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! Distance of the farthest dots that are put together, pixels: those of longer rings are too long to be dots. */
constexpr double farthestDots = 100.;

/*!
  The outer edge of a ring that is seen from nearly the side, so that no edge is left along its long sides: the black at
  both ends of the longer axis makes dots, in the middle between them it is white, and beyond them and beside them is
  paper. It is as wide as the ring is that, as the blur leaves it, correlates best with the image.
  \param I : The image.
  \param one, other : The dots.
  \param ringInner : Inner radius of the ring, of the outer one.
  \return The ellipse, to some tenths of a pixel; nothing if there is none.
*/
std::optional<EllipseParameters> ringBetween(const vpImage<unsigned char> &I, const DarkDot &one, const DarkDot &other,
                                             double ringInner);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
