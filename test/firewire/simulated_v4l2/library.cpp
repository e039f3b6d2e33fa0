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
 * libv4l's C interface once more, with a camera that sees the simulated marker.
 */

#include <cerrno>
#include <cstdarg>
#include <cstring>
#include <ctime>
#include <mutex>
#include <vector>

#include <libv4l2.h>
#include <linux/videodev2.h>
#include <unistd.h>

#include "../simulated_dc1394/simulated_camera.h"

using namespace simulated_bus;

namespace {
/*!
  A camera for television-like YUYV of 1280 x 960 pixels; other sizes and formats are changed to these, as drivers do.
  Every descriptor is the reading end of a pipe: with a byte in it while there are images, so that select() returns.
*/
struct Camera
{
  static constexpr unsigned int width = 1280, height = 960;
  static constexpr std::size_t bytes = std::size_t(2) * width * height;

  std::mutex mutex;
  std::vector<std::vector<unsigned char>> buffers;
  std::vector<std::uint32_t> queued;
  long number = 0;
  bool isStreaming = false;
};

Camera &camera()
{
  static auto *const made = new Camera;
  return *made;
}

int fail(int error)
{
  errno = error;
  return -1;
}

bool isUnplugged()
{
  return scenario().unplugAt && camera().number >= *scenario().unplugAt;
}

void setFormat(v4l2_format &format)
{
  format.fmt.pix.width = Camera::width;
  format.fmt.pix.height = Camera::height;
  format.fmt.pix.pixelformat = V4L2_PIX_FMT_YUYV;
  format.fmt.pix.bytesperline = 2 * Camera::width;
  format.fmt.pix.sizeimage = Camera::bytes;
}

int dequeue(v4l2_buffer &buffer)
{
  Camera &device = camera();
  if (isUnplugged()) {
    return fail(ENODEV);
  }
  if (!device.isStreaming || device.queued.empty()) {
    return fail(EINVAL);
  }
  buffer.index = device.queued.front();
  device.queued.erase(device.queued.begin());
  const vpImage<unsigned char> I = renderFrame(device.number++, Camera::width, Camera::height);
  std::vector<unsigned char> &bytes = device.buffers.at(buffer.index);
  for (unsigned int i = 0; i < I.getSize(); ++i) {
    bytes[2 * i] = I.bitmap[i];
    bytes[2 * i + 1] = 128; // no colour
  }
  buffer.bytesused = Camera::bytes;
  // As most drivers: seconds since the computer's start.
  timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  buffer.timestamp.tv_sec = now.tv_sec;
  buffer.timestamp.tv_usec = now.tv_nsec / 1000;
  return 0;
}
} // namespace

extern "C" {
int v4l2_open(const char *, int, ...)
{
  int ends[2];
  if (pipe(ends) != 0) {
    return -1;
  }
  const char sign = 1;
  return write(ends[1], &sign, 1) == 1 ? ends[0] : -1;
}

int v4l2_close(int file)
{
  return close(file);
}

void *v4l2_mmap(void *, size_t, int, int, int, int64_t offset)
{
  return camera().buffers.at(static_cast<std::size_t>(offset)).data();
}

int v4l2_munmap(void *, size_t)
{
  return 0;
}

int v4l2_ioctl(int, unsigned long request, ...)
{
  va_list arguments;
  va_start(arguments, request);
  void *data = va_arg(arguments, void *);
  va_end(arguments);
  Camera &device = camera();
  const std::lock_guard<std::mutex> lock(device.mutex);
  // What was taken is told with the next image.
  if (isUnplugged() && request != VIDIOC_DQBUF && request != VIDIOC_QBUF) {
    return fail(ENODEV);
  }
  switch (request) {
  case VIDIOC_QUERYCAP:
    static_cast<v4l2_capability *>(data)->capabilities = V4L2_CAP_VIDEO_CAPTURE | V4L2_CAP_STREAMING;
    return 0;
  case VIDIOC_G_FMT:
  case VIDIOC_S_FMT:
    setFormat(*static_cast<v4l2_format *>(data));
    return 0;
  case VIDIOC_G_PARM:
  case VIDIOC_S_INPUT:
    return 0;
  case VIDIOC_REQBUFS:
    device.buffers.assign(static_cast<v4l2_requestbuffers *>(data)->count, std::vector<unsigned char>(Camera::bytes));
    device.queued.clear();
    return 0;
  case VIDIOC_QUERYBUF:
    static_cast<v4l2_buffer *>(data)->length = Camera::bytes;
    static_cast<v4l2_buffer *>(data)->m.offset = static_cast<v4l2_buffer *>(data)->index;
    return 0;
  case VIDIOC_QBUF:
    device.queued.push_back(static_cast<v4l2_buffer *>(data)->index);
    return 0;
  case VIDIOC_DQBUF:
    return dequeue(*static_cast<v4l2_buffer *>(data));
  case VIDIOC_STREAMON:
    device.isStreaming = true;
    return 0;
  case VIDIOC_STREAMOFF:
    device.isStreaming = false;
    return 0;
  default:
    return fail(EINVAL);
  }
}
} // extern "C"
