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
 * Images as libdc1394 delivers them.
 */

#include "firewire_frame.h"

#ifdef CIRCLE_MARKER_HAVE_FIREWIRE
#include <algorithm>
#include <cstdint>

#include <visp3/core/vpImageConvert.h>

#include "frame_source.h"

namespace tutorial {
namespace {
/*! Bits of a pixel in the codings that ViSP converts, 0 for others. */
unsigned int bitsPerPixel(dc1394color_coding_t coding)
{
  switch (coding) {
  case DC1394_COLOR_CODING_MONO8:
  case DC1394_COLOR_CODING_RAW8:
    return 8;
  case DC1394_COLOR_CODING_YUV411:
    return 12;
  case DC1394_COLOR_CODING_MONO16:
  case DC1394_COLOR_CODING_RAW16:
  case DC1394_COLOR_CODING_YUV422:
    return 16;
  case DC1394_COLOR_CODING_YUV444:
  case DC1394_COLOR_CODING_RGB8:
    return 24;
  default:
    return 0;
  }
}
} // namespace

std::string frameDefect(const dc1394video_frame_t &frame)
{
  if (frame.camera != nullptr &&
      dc1394_capture_is_frame_corrupt(frame.camera, const_cast<dc1394video_frame_t *>(&frame)) == DC1394_TRUE) {
    return "packets were lost on the way";
  }
  const std::uint64_t pixels = std::uint64_t(frame.size[0]) * frame.size[1];
  constexpr std::uint32_t longestSide = 20000; // pixels; no camera has more
  if (frame.image == nullptr || pixels == 0 || std::max(frame.size[0], frame.size[1]) > longestSide) {
    return "it says that it has " + std::to_string(frame.size[0]) + " x " + std::to_string(frame.size[1]) + " pixels";
  }
  const std::uint64_t needed = pixels * bitsPerPixel(frame.color_coding) / 8;
  if (frame.image_bytes < needed) {
    return std::to_string(frame.image_bytes) + " bytes came of " + std::to_string(needed);
  }
  return "";
}

void convertFrame(const dc1394video_frame_t &frame, vpImage<unsigned char> &I)
{
  I.resize(frame.size[1], frame.size[0]);
  const unsigned int pixels = frame.size[0] * frame.size[1];
  switch (frame.color_coding) {
  case DC1394_COLOR_CODING_MONO8:
  case DC1394_COLOR_CODING_RAW8:
    std::copy(frame.image, frame.image + pixels, I.bitmap);
    break;
  case DC1394_COLOR_CODING_MONO16:
  case DC1394_COLOR_CODING_RAW16:
    vpImageConvert::MONO16ToGrey(frame.image, I.bitmap, pixels);
    break;
  case DC1394_COLOR_CODING_YUV411:
    vpImageConvert::YUV411ToGrey(frame.image, I.bitmap, pixels);
    break;
  case DC1394_COLOR_CODING_YUV422:
    vpImageConvert::YUV422ToGrey(frame.image, I.bitmap, pixels);
    break;
  case DC1394_COLOR_CODING_YUV444:
    vpImageConvert::YUV444ToGrey(frame.image, I.bitmap, pixels);
    break;
  case DC1394_COLOR_CODING_RGB8:
    vpImageConvert::RGBToGrey(frame.image, I.bitmap, pixels);
    break;
  default:
    throw SourceError("ViSP cannot convert the camera's color coding; choose another with --video-mode or "
                      "--color-coding, such as mono8");
  }
}
} // namespace tutorial
#endif
