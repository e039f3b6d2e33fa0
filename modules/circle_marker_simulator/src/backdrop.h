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
 * Image of a scene's background.
 */

#ifndef VP_SIMULATOR_BACKDROP_H
#define VP_SIMULATOR_BACKDROP_H

#include <cstdint>

#include <visp3/core/vpImage.h>

#include "pixel_response.h"

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

//! Stretches a photograph to the size of `I` (bilinear; the pictures' borders coincide).
void drawPhoto(const vpImage<unsigned char> &photo, vpImage<float> &I);

//! Fills `I` with a gradient and random shapes: polygons, discs, rings, bars, thin lines and strokes as of writing.
void drawClutter(std::uint64_t seed, unsigned int shapes, const PixelResponse &response, vpImage<float> &I);

} // namespace marker_simulator
END_VISP_NAMESPACE

#endif
