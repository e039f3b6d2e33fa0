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
 * Whether what an outline holds differs in opposite directions as a code does.
 */

#ifndef VP_CIRCLE_MARKER_CODE_ASYMMETRY_H
#define VP_CIRCLE_MARKER_CODE_ASYMMETRY_H

#include "ellipse/conic.h"

#include <visp3/core/vpImage.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Whether the inside of a small outline differs in opposite directions as that of a marker with a code does: by more
  than the noise, and by less than what is cut off. Turned by half a turn a code never is the same, since the number of
  its sectors is odd; rings with nothing in them, discs and ellipses are, whatever blurs them. It costs some
  microseconds, and what is refused would have been measured, with several codes, for milliseconds.

  Opposite pixels are compared. That the centre is known to some tenths of a pixel only, and that light may change over
  the marker, adds to their differences a part that goes with the gradient and one that goes with the place: these are
  fitted and left out.
  \param I : The image.
  \param outline : Outer edge of the ring.
  \param noise : Standard deviation of the image's noise, grey levels.
*/
bool isAsymmetricAsCode(const vpImage<unsigned char> &I, const EllipseParameters &outline, double noise);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
