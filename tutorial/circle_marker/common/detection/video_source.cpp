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
 * The frames of a video file.
 */

#include "video_source.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <visp3/core/vpException.h>

#ifdef CIRCLE_MARKER_HAVE_OPENCV_VIDEOIO
#include <opencv2/core.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/videoio.hpp>
#include <visp3/core/vpImageConvert.h>
#endif
#include "image_file.h"

namespace tutorial {
#ifdef CIRCLE_MARKER_HAVE_OPENCV_VIDEOIO
namespace {
// Whether a video says how many frames it has, and does not leave it to be estimated.
bool hasIndex(const std::string &path)
{
  const std::string extensions[] = {".mpg", ".mpeg", ".mts"};
  return std::find(std::begin(extensions), std::end(extensions), extensionOf(path)) == std::end(extensions);
}

/*!
  Frames of a video, numbered from 0. OpenCV's reader: that of ViSP is the same with fewer extensions, and jumps to the
  first frame, which MPEG streams do not let it.
*/
class VideoSource : public ImageSource
{
public:
  VideoSource(const std::string &path, long first, long last) : m_path(path), m_first(first), m_last(last)
  {
    // What is wrong is told by this class. Once, and not by redirecting streams: frames may be read in a thread of
    // their own, while another one writes to these.
    cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
    if (!m_reader.open(path)) {
      throw vpException(vpException::ioError,
                        "\"%s\" cannot be read as a video; is it whole, and its codec known to OpenCV?", path.c_str());
    }
    m_frames = std::lround(std::max(0., m_reader.get(cv::CAP_PROP_FRAME_COUNT)));
  }

  std::optional<SourceImage> next() override
  {
    // Frames are decoded in order: videos do not seek exactly.
    while (m_next <= m_last) {
      cv::Mat frame;
      const bool isDecoded = m_reader.read(frame) && !frame.empty();
      // After a frame that cannot be decoded there may be others, but not after a second one.
      if (!isDecoded && (m_isDamaged || m_next + (hasIndex(m_path) ? 1 : estimate) >= m_frames)) {
        return afterTheLast();
      }
      m_isDamaged = !isDecoded;
      const long number = m_next++;
      if (number < m_first) {
        continue;
      }
      SourceImage result{nameOf(number), number, vpImage<unsigned char>(), ""};
      if (isDecoded) {
        vpImageConvert::convert(frame, *result.image);
      }
      else {
        result.image.reset();
        result.problem = "the frame cannot be decoded";
      }
      return result;
    }
    return std::nullopt;
  }

  std::size_t size() const override
  {
    return static_cast<std::size_t>(std::max(0L, std::min(m_last, m_frames - 1) - m_first + 1));
  }

private:
  std::string nameOf(long number) const { return m_path + "#" + std::to_string(number); }

  // MPEG streams have no index: how many frames they have is estimated by their length, to one or two.
  static constexpr long estimate = 2;

  // What is wrong with the next frame, which is not there; said once.
  std::optional<SourceImage> afterTheLast()
  {
    const bool isAsked = m_last != std::numeric_limits<long>::max() || m_next <= m_first;
    const bool isCutOff = m_next + (hasIndex(m_path) ? 0 : estimate) < m_frames;
    const long number = std::max(m_next, m_first);
    SourceImage result{nameOf(number), number, std::nullopt, ""};
    m_last = -1;
    if (isCutOff) {
      result.problem = "neither this frame nor one after it can be decoded";
    }
    else if (isAsked) {
      result.problem = "the video has " + std::to_string(m_next) + " frames, from 0";
    }
    return isCutOff || isAsked ? std::make_optional(result) : std::nullopt;
  }

  std::string m_path;        //!< Path of the video.
  long m_first;              //!< First frame that is wanted.
  long m_last;               //!< Last frame that is wanted.
  long m_next = 0;           //!< Frame that is decoded next.
  long m_frames = 0;         //!< Number of frames that the file says it has.
  bool m_isDamaged = false;  //!< Whether the last one could not be decoded.
  cv::VideoCapture m_reader; //!< Decodes it.
};
} // namespace
#endif

bool isVideo(const std::string &path)
{
  const std::string extensions[] = {".avi", ".mpg", ".mpeg", ".mp4", ".m4v", ".mts",
                                    ".mov", ".mkv", ".wmv",  ".flv", ".ogv", ".webm"};
  return std::find(std::begin(extensions), std::end(extensions), extensionOf(path)) != std::end(extensions);
}

std::unique_ptr<ImageSource> openVideo(const std::string &path, std::optional<long> first, std::optional<long> last)
{
#ifdef CIRCLE_MARKER_HAVE_OPENCV_VIDEOIO
  return std::make_unique<VideoSource>(path, first.value_or(0), last.value_or(std::numeric_limits<long>::max()));
#else
  (void)first;
  (void)last;
  throw vpException(vpException::ioError,
                    "\"%s\" is a video, and this program was built without OpenCV's videoio (Debian: apt-get install "
                    "libopencv-videoio-dev)",
                    path.c_str());
#endif
}
} // namespace tutorial
