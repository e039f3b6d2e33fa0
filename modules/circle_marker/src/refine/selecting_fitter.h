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
 * A fitter on lanes that chooses its pixels.
 */

#ifndef VP_CIRCLE_MARKER_SELECTING_FITTER_H
#define VP_CIRCLE_MARKER_SELECTING_FITTER_H

#include "refine/fit_pixels.h"
#include "refine/lanes_fitter.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
/*! Chooses pixels, too, by the function of its own namespace. */
class SelectingFitter final : public LanesFitter
{
public:
  void selectPixels(const vpImage<unsigned char> &I, const CameraModel &camera, const ImageFrame &frame,
                    const MarkerPlane *planes, std::size_t count, const MarkerPattern &pattern,
                    const PixelChoice &choice, std::vector<FitPixel> &pixels) override
  {
    CIRCLE_MARKER_LANES::selectPixels(I, camera, frame, planes, count, pattern, choice, pixels);
  }
};
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
