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
 * Cameras of OpenCV.
 */

#include "opencv_camera.h"

#ifdef CIRCLE_MARKER_HAVE_OPENCV_VIDEOIO
#include <visp3/core/vpImageConvert.h>

#include <opencv2/core.hpp>
#include <opencv2/videoio.hpp>

namespace tutorial {
namespace {
/*! A camera of cv::VideoCapture. OpenCV does not say when an image was taken, nor whether others were missed. */
class OpenCvCamera : public FrameSource
{
public:
  explicit OpenCvCamera(const CameraSettings &settings) : m_name(settings.name)
  {
    const std::string &address = settings.address;
    const bool isNumber = address.size() < 4 && address.find_first_not_of("0123456789") == std::string::npos;
    m_isFile = !isNumber && address.find("://") == std::string::npos && address.find('!') == std::string::npos;
    const bool isOpen = isNumber ? m_capture.open(std::stoi(address)) : m_capture.open(address);
    if (!isOpen) {
      throw SourceError("OpenCV cannot open the camera " + m_name +
                        "; numbers are those of /dev/video*, which you must be allowed to use (group video); an "
                        "address must be one that OpenCV was built for (FFmpeg, GStreamer)");
    }
    if (settings.size.first != 0) {
      m_capture.set(cv::CAP_PROP_FRAME_WIDTH, settings.size.first);
      m_capture.set(cv::CAP_PROP_FRAME_HEIGHT, settings.size.second);
    }
    if (settings.framerate) {
      m_capture.set(cv::CAP_PROP_FPS, *settings.framerate);
    }
    m_size = settings.size;
  }

  std::optional<Frame> next() override
  {
    cv::Mat picture;
    if (!m_capture.read(picture) || picture.empty()) {
      if (m_isFile && m_number > 0) {
        return std::nullopt;
      }
      throw SourceError("the camera " + m_name +
                        " delivers no images: was it unplugged, or does another program use "
                        "it? Unplug it and plug it in again");
    }
    checkSize(picture);
    Frame frame;
    frame.time = m_isFile ? std::nullopt : std::optional<double>(unixSeconds());
    if (picture.channels() == 1) {
      frame.image.resize(picture.rows, picture.cols);
      picture.copyTo(cv::Mat(picture.rows, picture.cols, CV_8UC1, frame.image.bitmap));
    }
    else {
      vpImageConvert::convert(picture, frame.image);
    }
    frame.number = m_number++;
    frame.name = m_name + "#" + std::to_string(frame.number);
    return frame;
  }

  bool isLive() const override { return !m_isFile; }

private:
  /*! OpenCV takes another size without a word. */
  void checkSize(const cv::Mat &picture) const
  {
    const auto width = static_cast<unsigned int>(picture.cols), height = static_cast<unsigned int>(picture.rows);
    if (m_size.first != 0 && (m_size.first != width || m_size.second != height)) {
      throw SourceError("the camera " + m_name + " gives images of " + std::to_string(width) + " x " +
                        std::to_string(height) + " pixels; use --image-size " + std::to_string(width) + "x" +
                        std::to_string(height) + " or leave it out");
    }
  }

  std::string m_name;                           //!< As the user calls the camera.
  bool m_isFile = false;                        //!< Whether it ends.
  cv::VideoCapture m_capture;                   //!< Acquires the images.
  std::pair<unsigned int, unsigned int> m_size; //!< Width and height asked for, pixels.
  long m_number = 0;                            //!< Of the next image.
};
} // namespace

std::unique_ptr<FrameSource> openOpenCvCamera(const CameraSettings &settings)
{
  return std::make_unique<OpenCvCamera>(settings);
}
} // namespace tutorial
#else
namespace tutorial {
std::unique_ptr<FrameSource> openOpenCvCamera(const CameraSettings &)
{
  throw SourceError("this program was built without OpenCV's cameras (Debian: apt-get install libopencv-videoio-dev, "
                    "then build this project again)");
}
} // namespace tutorial
#endif
