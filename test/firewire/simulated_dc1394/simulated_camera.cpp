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
 * A camera on the simulated bus: its registers, and the images it sends.
 */

#include "simulated_camera.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <thread>

#include <visp3/circle_marker_simulator/vpMarkerSceneSimulator.h>

namespace simulated_bus {
namespace {
double now()
{
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

/*! As poll() without a time limit, when nothing comes. */
[[noreturn]] void waitWithoutEnd()
{
  while (true) {
    std::this_thread::sleep_for(std::chrono::hours(1));
  }
}

vpHomogeneousMatrix poseOf(long number)
{
  const Scenario &plan = scenario();
  if (!plan.poseFile.empty()) {
    std::ifstream file(plan.poseFile);
    vpHomogeneousMatrix cMo;
    for (unsigned int i = 0; i < 16; ++i) {
      file >> cMo[i / 4][i % 4];
    }
    return cMo;
  }
  return plan.poses.at(static_cast<std::size_t>(number) % plan.poses.size());
}

vpHomogeneousMatrix shiftedInPlane(const vpHomogeneousMatrix &cMo, double x, double y)
{
  return cMo * vpHomogeneousMatrix(x, y, 0., 0., 0., 0.);
}

/*! A sheet with its markers; the pose is that of the place of the sheet from which the markers' places count. */
void addSheet(vpMarkerSceneSimulator &simulator, const Scenario &plan, const vpHomogeneousMatrix &cMo)
{
  double left = HUGE_VAL, right = -HUGE_VAL, top = HUGE_VAL, bottom = -HUGE_VAL;
  for (const SheetMarker &marker : plan.sheet) {
    left = std::min(left, marker.x - marker.size);
    right = std::max(right, marker.x + marker.size);
    top = std::min(top, marker.y - marker.size);
    bottom = std::max(bottom, marker.y + marker.size);
  }
  simulator.addMarker(vpSimulatedMarker::bitmap(vpImage<unsigned char>(1, 1, 255), right - left, bottom - top)
                          .setPose(shiftedInPlane(cMo, 0.5 * (left + right), 0.5 * (top + bottom))));
  for (const SheetMarker &marker : plan.sheet) {
    // A little of the white around, so that no two markers overlap.
    simulator.addMarker(vpSimulatedMarker::circle(plan.family, marker.id, marker.size)
                            .setPose(shiftedInPlane(cMo, marker.x, marker.y))
                            .setSheetSide(1.05 * marker.size));
  }
}
} // namespace

vpImage<unsigned char> renderFrame(long number, unsigned int width, unsigned int height)
{
  const double scale = width / 1280.;
  const double focalLength = scenario().focalLength * scale;
  const vpCameraParameters cam(focalLength, focalLength, 640. * scale - 0.5, 480. * scale - 0.5);
  vpMarkerSceneSimulator simulator(cam, width, height);
  vpScenePhotometry photometry;
  photometry.noiseSigma = 2.;
  photometry.blurSigma = 0.7;
  simulator.setPhotometry(photometry);
  simulator.setBackground(vpSceneBackground::plain(110.));
  const Scenario &plan = scenario();
  if (plan.sheet.empty()) {
    simulator.addMarker(vpSimulatedMarker::circle(plan.family, plan.id, plan.size).setPose(poseOf(number)));
  }
  else {
    addSheet(simulator, plan, poseOf(number));
  }
  vpImage<unsigned char> I;
  simulator.render(I, static_cast<std::uint64_t>(number) + 1);
  return I;
}

SimulatedCamera::SimulatedCamera(const CameraEntry &cameraEntry) : entry(cameraEntry)
{
  // Those of a Chameleon without colour: no hue, no saturation, no iris.
  for (const dc1394feature_t feature : {DC1394_FEATURE_BRIGHTNESS, DC1394_FEATURE_EXPOSURE, DC1394_FEATURE_SHARPNESS,
                                        DC1394_FEATURE_GAMMA, DC1394_FEATURE_SHUTTER, DC1394_FEATURE_GAIN}) {
    features[feature] = Feature{};
  }
}

std::vector<dc1394video_mode_t> SimulatedCamera::modes() const
{
  return {DC1394_VIDEO_MODE_640x480_YUV411, DC1394_VIDEO_MODE_640x480_MONO8,  DC1394_VIDEO_MODE_1280x960_YUV422,
          DC1394_VIDEO_MODE_1280x960_RGB8,  DC1394_VIDEO_MODE_1280x960_MONO8, DC1394_VIDEO_MODE_1280x960_MONO16,
          DC1394_VIDEO_MODE_FORMAT7_0};
}

std::vector<dc1394framerate_t> SimulatedCamera::framerates(dc1394video_mode_t ofMode) const
{
  std::vector<dc1394framerate_t> rates = {DC1394_FRAMERATE_3_75, DC1394_FRAMERATE_7_5};
  if (layoutOf(ofMode).coding != DC1394_COLOR_CODING_RGB8) {
    rates.push_back(DC1394_FRAMERATE_15); // 1280 x 960 in 24 bits at 15 images a second is more than the bus carries
  }
  return rates;
}

std::vector<dc1394color_coding_t> SimulatedCamera::codings() const
{
  return {DC1394_COLOR_CODING_MONO8,  DC1394_COLOR_CODING_MONO16, DC1394_COLOR_CODING_YUV411,
          DC1394_COLOR_CODING_YUV422, DC1394_COLOR_CODING_YUV444, DC1394_COLOR_CODING_RGB8,
          DC1394_COLOR_CODING_RAW8,   DC1394_COLOR_CODING_RAW16,  DC1394_COLOR_CODING_RGB16};
}

void SimulatedCamera::setUp(unsigned int buffers)
{
  m_number = 0;
  m_taken = 0;
  m_buffers.clear();
  for (unsigned int i = 0; i < buffers; ++i) {
    m_buffers.push_back(std::make_unique<Buffer>());
  }
  m_nextBuffer = 0;
}

double SimulatedCamera::interval() const
{
  return isFormat7(mode) ? 1. / 15. : 1. / (1.875 * std::pow(2., framerate - DC1394_FRAMERATE_1_875));
}

/*! The image of the mode. */
vpImage<unsigned char> SimulatedCamera::render(long number) const
{
  const ModeLayout layout = layoutOf(mode);
  const vpImage<unsigned char> I = renderFrame(number, layout.width, layout.height);
  if (!isFormat7(mode)) {
    return I;
  }
  vpImage<unsigned char> region(height, width);
  for (unsigned int row = 0; row < height; ++row) {
    std::copy(I[top + row] + left, I[top + row] + left + width, region[row]);
  }
  return region;
}

void SimulatedCamera::fill(Buffer &buffer, long number)
{
  const Scenario &plan = scenario();
  const dc1394color_coding_t coding = isFormat7(mode) ? format7Coding : layoutOf(mode).coding;
  const vpImage<unsigned char> I = render(plan.isSameNoise ? 0 : number);
  buffer.bytes = encode(I, coding);
  buffer.isCorrupt = plan.corrupt.count(number) > 0;
  if (buffer.isCorrupt) {
    // Half of the packets did not come: what the buffer held before is seen.
    std::fill(buffer.bytes.begin() + static_cast<std::ptrdiff_t>(buffer.bytes.size() / 2), buffer.bytes.end(), 0);
  }
  dc1394video_frame_t &frame = buffer.frame;
  frame.size[0] = I.getWidth();
  frame.size[1] = I.getHeight();
  frame.position[0] = isFormat7(mode) ? left : 0;
  frame.position[1] = isFormat7(mode) ? top : 0;
  frame.color_coding = coding;
  frame.video_mode = mode;
  frame.stride = I.getWidth() * bitsPerPixel(coding) / 8;
  frame.data_depth = bitsPerPixel(coding);
  if (plan.truncated.count(number) > 0) {
    // Exactly as long as it says: reading on is an error that the sanitizers see.
    buffer.bytes.resize(buffer.bytes.size() / 3);
    buffer.bytes.shrink_to_fit();
  }
  frame.image = buffer.bytes.data();
  frame.image_bytes = static_cast<std::uint32_t>(buffer.bytes.size());
  frame.total_bytes = frame.image_bytes;
  frame.allocated_image_bytes = frame.image_bytes;
  frame.id = static_cast<std::uint32_t>(m_nextBuffer);
  frame.frames_behind = 0;
}

dc1394error_t SimulatedCamera::dequeue(dc1394video_frame_t *&frame, dc1394camera_t *handle)
{
  const Scenario &plan = scenario();
  frame = nullptr;
  if (!isSetUp()) {
    return DC1394_CAPTURE_IS_NOT_SET;
  }
  Buffer &buffer = *m_buffers[m_nextBuffer];
  const bool isSilent = plan.silentAt && m_number >= *plan.silentAt;
  if (isSilent || transmission == DC1394_OFF || buffer.isTaken) {
    log("waits without end");
    waitWithoutEnd();
  }
  if (plan.unplugAt && m_number >= *plan.unplugAt) {
    log("unplugged");
    m_isUnplugged = true;
  }
  if (m_isUnplugged || plan.undeliverable.count(m_number) > 0) {
    m_number += m_isUnplugged ? 0 : 1;
    if (plan.isUsb) {
      // libdc1394 says that it has failed and gives the frame of before all the same.
      buffer.frame.camera = handle;
      buffer.isCorrupt = true;
      frame = &buffer.frame;
    }
    return DC1394_FAILURE;
  }
  m_start = m_number == 0 ? now() : m_start;
  m_taken += plan.afterGap.count(m_number) > 0 ? 2 : 0;
  const double time = m_start + static_cast<double>(m_taken) * interval();
  if (plan.isRealTime) {
    std::this_thread::sleep_for(std::chrono::duration<double>(std::max(0., time - now())));
  }
  fill(buffer, m_number);
  buffer.frame.camera = handle;
  buffer.frame.timestamp = plan.isUsb ? 0 : static_cast<std::uint64_t>(std::llround(1e6 * time));
  buffer.isTaken = true;
  frame = &buffer.frame;
  m_nextBuffer = (m_nextBuffer + 1) % m_buffers.size();
  ++m_number;
  ++m_taken;
  return DC1394_SUCCESS;
}

void SimulatedCamera::enqueue(dc1394video_frame_t *frame)
{
  for (const auto &buffer : m_buffers) {
    if (&buffer->frame == frame) {
      buffer->isTaken = false;
    }
  }
}

bool SimulatedCamera::isCorrupt(const dc1394video_frame_t *frame) const
{
  for (const auto &buffer : m_buffers) {
    if (&buffer->frame == frame) {
      return buffer->isCorrupt;
    }
  }
  return false;
}
} // namespace simulated_bus
