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
 * FireWire cameras, through ViSP's grabber.
 */

#include "firewire_camera.h"

#include "firewire_bus.h"

#ifdef CIRCLE_MARKER_HAVE_FIREWIRE
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <thread>
#include <utility>

#include <visp3/sensor/vp1394TwoGrabber.h>

#include "../arguments.h"
#include "../camera_file.h"
#include "firewire_frame.h"
#include "firewire_setup.h"

namespace tutorial {
namespace {
std::string guidText(std::uint64_t guid)
{
  std::ostringstream text;
  text << "0x" << std::hex << std::setw(16) << std::setfill('0') << guid;
  return text.str();
}

/*! One of the cameras, by its index or its GUID. */
FireWireHandle choose(const std::vector<FireWireHandle> &cameras, const std::string &address)
{
  char *end = nullptr;
  const std::uint64_t number = std::strtoull(address.c_str(), &end, 0);
  if (address.empty() || address[0] == '-' || *end != '\0') {
    throw UsageError("a FireWire camera is chosen by its index from 0 or its GUID, as firewire:0 or "
                     "firewire:0x00b09d01007e0ee7, not by \"" +
                     address + "\"; --list-cameras lists them");
  }
  std::string present;
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    if (number == i || number == cameras[i].guid()) {
      return cameras[i];
    }
    present += (i > 0 ? ", " : "") + std::to_string(i) + " = " + guidText(cameras[i].guid());
  }
  throw SourceError("there is no FireWire camera " + address + "; there are " + present);
}

/*!
  A camera of vp1394TwoGrabber. It is asked for frames, not for images: acquire() ends the program when a frame cannot
  be delivered.
*/
class FireWireCamera : public FrameSource
{
public:
  FireWireCamera(const CameraSettings &settings, const FireWireHandle &handle)
      : m_name(settings.name), m_region(settings.region.value_or(ImageRegion{})), m_handle(handle)
  {
    const SilentStream silentErrors(std::cerr), silentOutput(std::cout);
    try {
      m_grabber = std::make_unique<vp1394TwoGrabber>(false);
      m_grabber->setCamera(handle.guid());
      m_interval = setUpFireWireCamera(*m_grabber, handle, settings);
    }
    catch (const vpException &e) {
      letGo();
      const std::string complaints = fireWireComplaints();
      throw SourceError("the camera " + m_name + " (" + m_handle.model() + ") cannot be started: " + e.what() +
                        (complaints.empty() ? "" : " (libdc1394: " + complaints + ")") +
                        "; end other programs that use it, choose a mode or frame rate that needs less of the bus, "
                        "or unplug it and plug it in again");
    }
    catch (...) {
      letGo();
      throw;
    }
  }

  ~FireWireCamera() override { letGo(); }

  std::optional<Frame> next() override
  {
    dc1394video_frame_t *raw = m_grabber->dequeue();
    if (raw == nullptr) {
      whenNothingCame();
    }
    // Whatever happens, the frame goes back to the ring of buffers.
    const std::unique_ptr<dc1394video_frame_t, Enqueue> frame(raw, Enqueue{m_grabber.get()});
    const long number = m_number++;
    const std::string defect = frameDefect(*frame);
    if (!defect.empty()) {
      whenDamaged(number, defect);
    }
    m_failures = 0;
    Frame result;
    convertFrame(*frame, result.image);
    result.number = number;
    result.name = m_name + "#" + std::to_string(number);
    setTime(*frame, result);
    return result;
  }

  bool isLive() const override { return true; }
  ImageRegion region() const override { return m_region; }

private:
  /*! Gives a frame back. */
  struct Enqueue
  {
    vp1394TwoGrabber *grabber;
    void operator()(dc1394video_frame_t *frame) const { grabber->enqueue(frame); }
  };

  [[noreturn]] void whenNothingCame()
  {
    const std::string complaints = fireWireComplaints();
    const std::string detail = complaints.empty() ? "" : " (libdc1394: " + complaints + ")";
    if (!m_handle.answers()) {
      throw SourceError("the camera " + m_name + " no longer answers" + detail +
                        ": was it unplugged, or has it lost its power? Plug it in and start again");
    }
    countFailure("the camera " + m_name + " delivers no images" + detail);
    throw DamagedFrame("the camera " + m_name + " could not deliver an image" + detail);
  }

  [[noreturn]] void whenDamaged(long number, const std::string &defect)
  {
    if (!m_handle.answers()) {
      throw SourceError("the camera " + m_name +
                        " no longer answers: was it unplugged, or has it lost its power? "
                        "Plug it in and start again");
    }
    countFailure("the camera " + m_name + " delivers only damaged images: " + defect);
    throw DamagedFrame("image " + m_name + "#" + std::to_string(number) + " is damaged: " + defect);
  }

  /*! Many failures in a row are no accident. */
  void countFailure(const std::string &message)
  {
    constexpr int mostFailures = 30; // two seconds at 15 images a second
    constexpr std::chrono::milliseconds pause(20);
    ++m_damaged;
    if (++m_failures >= mostFailures) {
      throw SourceError(message + "; check the cable and whether other cameras fill the bus, choose a lower "
                                  "--framerate or a smaller mode, or unplug the camera and plug it in again");
    }
    std::this_thread::sleep_for(pause); // what fails at once must not fill the processor
  }

  /*! libdc1394 stamps images of FireWire, in microseconds of Unix time, but not those of USB. */
  void setTime(const dc1394video_frame_t &frame, Frame &result)
  {
    if (frame.timestamp == 0) {
      return;
    }
    const double time = 1e-6 * static_cast<double>(frame.timestamp);
    if (m_interval && m_lastTime) {
      // Those between that came damaged are counted as such.
      const long between = std::lround((time - *m_lastTime) / *m_interval) - 1 - m_damaged;
      result.missed = static_cast<unsigned int>(std::max(0L, between));
    }
    m_lastTime = time;
    m_damaged = 0;
    result.time = time;
  }

  /*!
    Closes the grabber only while the camera answers. Otherwise vp1394TwoGrabber::close() never ends; the grabber is
    then kept, unused, until the program ends.
  */
  void letGo()
  {
    if (!m_grabber) {
      return;
    }
    if (m_handle.answers()) {
      m_grabber.reset();
    }
    else {
      static auto *const kept = new std::vector<vp1394TwoGrabber *>;
      kept->push_back(m_grabber.release());
    }
  }

  std::string m_name;                          //!< As the user calls the camera.
  ImageRegion m_region;                        //!< Of the camera's whole image.
  FireWireHandle m_handle;                     //!< To ask the camera whether it is still there.
  std::unique_ptr<vp1394TwoGrabber> m_grabber; //!< Acquires the images.
  std::optional<double> m_interval;            //!< Time between two images, seconds.
  std::optional<double> m_lastTime;            //!< When the last image was taken.
  long m_number = 0;                           //!< Of the next image.
  long m_damaged = 0;                          //!< Damaged images since the last good one.
  int m_failures = 0;                          //!< In a row.
};
} // namespace

std::unique_ptr<FrameSource> openFireWireCamera(const CameraSettings &settings)
{
  const std::vector<FireWireHandle> cameras = fireWireCameras();
  if (cameras.empty()) {
    throw SourceError("no FireWire camera was found: " + fireWireAdvice());
  }
  return std::make_unique<FireWireCamera>(settings, choose(cameras, settings.address));
}

std::string listFireWireCameras()
{
  try {
    const std::vector<FireWireHandle> cameras = fireWireCameras();
    if (cameras.empty()) {
      return "no FireWire camera: " + fireWireAdvice() + "\n";
    }
    const SilentStream silentErrors(std::cerr), silentOutput(std::cout);
    vp1394TwoGrabber grabber(false);
    std::string text;
    for (std::size_t i = 0; i < cameras.size(); ++i) {
      grabber.setCamera(cameras[i].guid());
      text += "firewire:" + std::to_string(i) + " = firewire:" + guidText(cameras[i].guid()) + "  " +
              cameras[i].model() + "\n  --video-mode " + videoModesOf(grabber) + "\n  --shutter auto, " +
              cameras[i].rangeOf(DC1394_FEATURE_SHUTTER) + "  --gain auto, " + cameras[i].rangeOf(DC1394_FEATURE_GAIN) +
              "\n";
    }
    return text;
  }
  catch (const std::exception &e) {
    return std::string("no FireWire camera: ") + e.what() + "\n";
  }
}
} // namespace tutorial
#else
namespace tutorial {
namespace {
const std::string missing =
    "this program was built without FireWire: ViSP or this project did not find libdc1394 when it was built (Debian: "
    "apt-get install libdc1394-dev, then build ViSP with USE_DC1394 and this project again)";
}

std::unique_ptr<FrameSource> openFireWireCamera(const CameraSettings &)
{
  throw SourceError(missing);
}

std::string listFireWireCameras()
{
  return "no FireWire camera: " + missing + "\n";
}
} // namespace tutorial
#endif
