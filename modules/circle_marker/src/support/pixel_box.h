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
 * A rectangle of pixels.
 */

#ifndef VP_CIRCLE_MARKER_PIXEL_BOX_H
#define VP_CIRCLE_MARKER_PIXEL_BOX_H

#include <algorithm>

#include <visp3/circle_marker/vpConfigCircleMarker.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! A rectangle of pixels: from \e left and \e top to before \e right and \e bottom. */
struct PixelBox
{
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;

  int width() const { return right - left; }
  int height() const { return bottom - top; }
};

/*! A place as a whole number of pixels from 0 to \e most; 0 for what is no number. */
inline int pixelWithin(double place, int most)
{
  return place > 0. ? static_cast<int>(std::min(place, static_cast<double>(most))) : 0;
}
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
