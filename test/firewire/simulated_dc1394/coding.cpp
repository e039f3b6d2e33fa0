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

#include "coding.h"

#include <stdexcept>

namespace simulated_bus {
namespace {
constexpr unsigned char noColor = 128; // U and V of grey
}

// The tutorials' firewire_frame.cpp has a table of the same kind. This one is a second statement of the camera's
// standard, on purpose: a program and the camera that tests it must not share a mistake.
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
    return 48; // RGB16, which ViSP cannot convert
  }
}

bool isFormat7(dc1394video_mode_t mode)
{
  return mode >= DC1394_VIDEO_MODE_FORMAT7_MIN && mode <= DC1394_VIDEO_MODE_FORMAT7_MAX;
}

ModeLayout layoutOf(dc1394video_mode_t mode)
{
  switch (mode) {
  case DC1394_VIDEO_MODE_640x480_YUV411:
    return {640, 480, DC1394_COLOR_CODING_YUV411};
  case DC1394_VIDEO_MODE_640x480_MONO8:
    return {640, 480, DC1394_COLOR_CODING_MONO8};
  case DC1394_VIDEO_MODE_1280x960_YUV422:
    return {1280, 960, DC1394_COLOR_CODING_YUV422};
  case DC1394_VIDEO_MODE_1280x960_RGB8:
    return {1280, 960, DC1394_COLOR_CODING_RGB8};
  case DC1394_VIDEO_MODE_1280x960_MONO16:
    return {1280, 960, DC1394_COLOR_CODING_MONO16};
  case DC1394_VIDEO_MODE_1280x960_MONO8:
  case DC1394_VIDEO_MODE_FORMAT7_0:
    return {1280, 960, DC1394_COLOR_CODING_MONO8};
  default:
    throw std::invalid_argument("a mode that the simulated camera does not have");
  }
}

std::vector<unsigned char> encode(const vpImage<unsigned char> &I, dc1394color_coding_t coding)
{
  const unsigned int pixels = I.getSize();
  const unsigned char *grey = I.bitmap;
  std::vector<unsigned char> bytes;
  bytes.reserve(std::size_t(pixels) * bitsPerPixel(coding) / 8);
  const auto put = [&bytes](std::initializer_list<unsigned char> more) {
    bytes.insert(bytes.end(), more.begin(), more.end());
  };
  switch (coding) {
  case DC1394_COLOR_CODING_MONO8:
  case DC1394_COLOR_CODING_RAW8:
    bytes.assign(grey, grey + pixels);
    break;
  case DC1394_COLOR_CODING_MONO16:
  case DC1394_COLOR_CODING_RAW16:
    for (unsigned int i = 0; i < pixels; ++i) {
      put({grey[i], 77}); // any low byte
    }
    break;
  case DC1394_COLOR_CODING_YUV411:
    for (unsigned int i = 0; i < pixels; i += 4) {
      put({noColor, grey[i], grey[i + 1], noColor, grey[i + 2], grey[i + 3]});
    }
    break;
  case DC1394_COLOR_CODING_YUV422:
    for (unsigned int i = 0; i < pixels; i += 2) {
      put({noColor, grey[i], noColor, grey[i + 1]});
    }
    break;
  case DC1394_COLOR_CODING_YUV444:
    for (unsigned int i = 0; i < pixels; ++i) {
      put({noColor, grey[i], noColor});
    }
    break;
  case DC1394_COLOR_CODING_RGB8:
    for (unsigned int i = 0; i < pixels; ++i) {
      put({grey[i], grey[i], grey[i]});
    }
    break;
  default:
    bytes.assign(std::size_t(pixels) * bitsPerPixel(coding) / 8, 0);
    break;
  }
  return bytes;
}
} // namespace simulated_bus
