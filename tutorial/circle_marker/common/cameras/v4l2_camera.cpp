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
 * Cameras of Video4Linux 2, through ViSP's grabber.
 */

#include "v4l2_camera.h"

#include <visp3/core/vpConfig.h>

#if defined(VISP_HAVE_V4L2)
#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <vector>

#include <fcntl.h>
#include <libv4l2.h>
#include <linux/videodev2.h>

#include <visp3/sensor/vpV4l2Grabber.h>

#include "../camera_file.h"

namespace fs = std::filesystem;

namespace tutorial {
namespace {
/*! A device file, open as long as this lives; through libv4l, as ViSP does. */
class Device
{
public:
  explicit Device(const std::string &path) : m_file(v4l2_open(path.c_str(), O_RDWR | O_NONBLOCK, 0)), m_error(errno) {}
  Device(const Device &) = delete;
  Device &operator=(const Device &) = delete;
  ~Device()
  {
    if (m_file >= 0) {
      v4l2_close(m_file);
    }
  }

  bool isOpen() const { return m_file >= 0; }
  int error() const { return m_error; }
  template <typename Data> bool ask(unsigned long request, Data &data) const
  {
    return v4l2_ioctl(m_file, request, &data) == 0;
  }

private:
  int m_file;  //!< Descriptor, or -1.
  int m_error; //!< Why it could not be opened.
};

std::string devicesText()
{
  std::vector<std::string> devices;
  std::error_code error;
  for (const fs::directory_entry &entry : fs::directory_iterator("/dev", error)) {
    if (entry.path().filename().string().rfind("video", 0) == 0) {
      devices.push_back(entry.path().string());
    }
  }
  std::sort(devices.begin(), devices.end());
  std::string text;
  for (const std::string &device : devices) {
    text += (text.empty() ? "" : ", ") + device;
  }
  return text.empty() ? "there is no /dev/video*: plug a camera in; in a container or a virtual machine, pass it on"
                      : "there are " + text;
}

/*! Why a device cannot be used; empty if it can. vpV4l2Grabber goes on with what is no camera, and then fails badly. */
std::string obstacle(const std::string &path)
{
  if (!fs::exists(path)) {
    return "there is no such device; " + devicesText();
  }
  // What libv4l would write to the standard error is said here.
  static FILE *const nowhere = std::fopen("/dev/null", "w");
  v4l2_log_file = nowhere;
  const Device device(path);
  if (!device.isOpen() && device.error() != ENOTTY) {
    return std::string(std::strerror(device.error())) +
           "; to be allowed to use it, join the group video (\"adduser <you> video\" as root, then "
           "log in again), and end other programs that use it";
  }
  v4l2_capability capability = {};
  if (!device.isOpen() || !device.ask(VIDIOC_QUERYCAP, capability)) {
    return "it is no V4L2 device; " + devicesText();
  }
  const auto abilities =
      capability.capabilities & V4L2_CAP_DEVICE_CAPS ? capability.device_caps : capability.capabilities;
  if (!(abilities & V4L2_CAP_VIDEO_CAPTURE) || !(abilities & V4L2_CAP_STREAMING)) {
    return "it gives no images; " + devicesText();
  }
  return "";
}

/*! Unix time of a time stamp: most drivers count from the computer's start. */
std::optional<double> unixTime(const timeval &stamp)
{
  const double time = static_cast<double>(stamp.tv_sec) + 1e-6 * static_cast<double>(stamp.tv_usec);
  timespec sinceStart;
  clock_gettime(CLOCK_MONOTONIC, &sinceStart);
  const double now = unixSeconds();
  const double monotonic = static_cast<double>(sinceStart.tv_sec) + 1e-9 * static_cast<double>(sinceStart.tv_nsec);
  constexpr double mostAge = 60.; // seconds; an older image is none of this camera's clock
  for (const double clock : {monotonic, now}) {
    if (std::abs(clock - time) < mostAge) {
      return time + now - clock;
    }
  }
  return std::nullopt;
}

/*! A camera of vpV4l2Grabber. */
class V4l2Camera : public FrameSource
{
public:
  explicit V4l2Camera(const CameraSettings &settings)
      : m_name(settings.name), m_device(settings.address), m_grabber(std::make_unique<vpV4l2Grabber>())
  {
    const SilentStream silentErrors(std::cerr), silentOutput(std::cout);
    const bool hasSize = settings.size.first != 0;
    // ViSP's own size unless told.
    m_width = hasSize ? settings.size.first : 640;
    m_height = hasSize ? settings.size.second : 480;
    m_grabber->setDevice(m_device);
    m_grabber->setInput(0);
    m_grabber->setWidth(m_width);
    m_grabber->setHeight(m_height);
    // The other choice of ViSP's cuts images at 288 lines: a field of a television camera.
    m_grabber->setFramerate(vpV4l2Grabber::framerate_25fps);
    vpImage<unsigned char> image;
    try {
      m_grabber->open(image);
    }
    catch (const vpException &e) {
      abandon();
      throw SourceError("the camera " + m_name + " cannot be started: " + e.what() +
                        "; end other programs that use it, or choose another --image-size (v4l2-ctl "
                        "--list-formats-ext lists them)");
    }
    checkSize();
  }

  ~V4l2Camera() override
  {
    try {
      // Closing throws when the camera is gone, and the grabber's destructor must not.
      m_grabber->close();
    }
    catch (const vpException &) {
      abandon();
    }
  }

  std::optional<Frame> next() override
  {
    Frame frame;
    timeval stamp = {};
    try {
      m_grabber->acquire(frame.image, stamp);
    }
    catch (const vpException &e) {
      throw SourceError("the camera " + m_name + " delivers no more images (" + e.what() +
                        "): was it unplugged? Plug it in and start again");
    }
    frame.time = unixTime(stamp);
    frame.number = m_number++;
    frame.name = m_name + "#" + std::to_string(frame.number);
    return frame;
  }

  bool isLive() const override { return true; }

private:
  /*! Drivers change a size that they do not have, and vpV4l2Grabber then reads lines of the wrong length. */
  void checkSize()
  {
    const Device device(m_device);
    v4l2_format format = {};
    format.type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
    if (device.isOpen() && device.ask(VIDIOC_G_FMT, format) &&
        (format.fmt.pix.width != m_width || format.fmt.pix.height != m_height)) {
      throw SourceError("the camera " + m_name + " gives images of " + std::to_string(format.fmt.pix.width) + " x " +
                        std::to_string(format.fmt.pix.height) + " pixels where " + std::to_string(m_width) + " x " +
                        std::to_string(m_height) + " were asked for; use --image-size " +
                        std::to_string(format.fmt.pix.width) + "x" + std::to_string(format.fmt.pix.height));
    }
  }

  /*! A grabber that cannot be closed is kept, unused, until the program ends. */
  void abandon()
  {
    static auto *const kept = new std::vector<vpV4l2Grabber *>;
    kept->push_back(m_grabber.release());
  }

  std::string m_name;                       //!< As the user calls the camera.
  std::string m_device;                     //!< Path of the device.
  unsigned int m_width = 0;                 //!< Pixels.
  unsigned int m_height = 0;                //!< Pixels.
  std::unique_ptr<vpV4l2Grabber> m_grabber; //!< Acquires the images.
  long m_number = 0;                        //!< Of the next image.
};
} // namespace

std::unique_ptr<FrameSource> openV4l2Camera(const CameraSettings &settings)
{
  const std::string why = obstacle(settings.address);
  if (!why.empty()) {
    throw SourceError("the camera " + settings.name + " cannot be used: " + why);
  }
  return std::make_unique<V4l2Camera>(settings);
}

std::string listV4l2Cameras()
{
  std::string text;
  std::error_code error;
  for (const fs::directory_entry &entry : fs::directory_iterator("/dev", error)) {
    const std::string path = entry.path().string();
    if (entry.path().filename().string().rfind("video", 0) == 0) {
      const std::string why = obstacle(path);
      text += "v4l2:" + path + (why.empty() ? "" : "  cannot be used: " + why) + "\n";
    }
  }
  return text.empty() ? "no V4L2 camera: " + devicesText() + "\n" : text;
}
} // namespace tutorial
#else
namespace tutorial {
namespace {
const std::string missing =
    "this program was built without Video4Linux: ViSP did not find libv4l when it was built "
    "(Debian: apt-get install libv4l-dev, then build ViSP with USE_V4L2 and this project again)";
}

std::unique_ptr<FrameSource> openV4l2Camera(const CameraSettings &)
{
  throw SourceError(missing);
}

std::string listV4l2Cameras()
{
  return "no V4L2 camera: " + missing + "\n";
}
} // namespace tutorial
#endif
