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
 * Recorded images in place of a camera's.
 */

#include "recording.h"

#include <chrono>
#include <thread>
#include <utility>

#include <visp3/core/vpException.h>

#include "../detection/image_source.h"

namespace tutorial {
namespace {
using Clock = std::chrono::steady_clock;

/*! Files, one after the other. */
class Recording : public FrameSource
{
public:
  Recording(std::unique_ptr<ImageSource> images, std::optional<double> framerate)
      : m_images(std::move(images)), m_framerate(framerate)
  {
  }

  std::optional<Frame> next() override
  {
    keepPace();
    std::optional<SourceImage> image = m_images->next();
    if (!image) {
      return std::nullopt;
    }
    if (!image->image) {
      throw DamagedFrame("\"" + image->name + "\" is left out: " + image->problem);
    }
    Frame frame;
    frame.image = std::move(*image->image);
    frame.name = image->name;
    frame.number = image->number;
    return frame;
  }

  bool isLive() const override { return false; }

private:
  void keepPace()
  {
    if (m_framerate) {
      std::this_thread::sleep_until(m_due);
      m_due = std::max(m_due, Clock::now() - std::chrono::seconds(1)) +
              std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(1. / *m_framerate));
    }
  }

  std::unique_ptr<ImageSource> m_images;  //!< The files.
  std::optional<double> m_framerate;      //!< Images per second; nothing: as fast as they are asked for.
  Clock::time_point m_due = Clock::now(); //!< When the next image is due.
};
} // namespace

std::unique_ptr<FrameSource> openRecording(const CameraSettings &settings)
{
  try {
    return std::make_unique<Recording>(openSource(settings.address, std::nullopt, std::nullopt), settings.framerate);
  }
  catch (const vpException &e) {
    throw SourceError(std::string(e.what()) + "; --source takes a camera, firewire, v4l2 or opencv, or a recording");
  }
}
} // namespace tutorial
