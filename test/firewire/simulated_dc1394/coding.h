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
 * Grey images in the codings of IIDC cameras.
 */

#ifndef VP_TEST_DC1394_CODING_H
#define VP_TEST_DC1394_CODING_H

#include <cstdint>
#include <vector>

#include <dc1394/dc1394.h>

#include <visp3/core/vpImage.h>

#include "scenario.h"

namespace simulated_bus {
/*! Bits of a pixel. */
unsigned int bitsPerPixel(dc1394color_coding_t coding);

/*! Width, height and coding of a video mode; of Format7 the whole image in 8 bits. */
struct ModeLayout
{
  unsigned int width, height;
  dc1394color_coding_t coding;
};
ModeLayout layoutOf(dc1394video_mode_t mode);

bool isFormat7(dc1394video_mode_t mode);

/*! The bytes that a camera sends for a grey image: colour codings without colour. IIDC's 16 bits start with the high.
 */
std::vector<unsigned char> encode(const vpImage<unsigned char> &I, dc1394color_coding_t coding);
} // namespace simulated_bus

#endif
