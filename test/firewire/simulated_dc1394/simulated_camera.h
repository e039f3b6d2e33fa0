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

#ifndef VP_TEST_DC1394_SIMULATED_CAMERA_H
#define VP_TEST_DC1394_SIMULATED_CAMERA_H

#include <atomic>
#include <chrono>
#include <map>
#include <memory>
#include <vector>

#include <dc1394/dc1394.h>

#include "coding.h"
#include "scenario.h"

namespace simulated_bus {
/*!
  What a camera sees: the marker, by the reference camera of 1280 x 960 pixels; smaller images join its pixels.
  \param number : Of the frame; says where the marker is.
  \param width, height : Of the image, pixels.
*/
vpImage<unsigned char> renderFrame(long number, unsigned int width, unsigned int height);

/*! A feature of the camera. */
struct Feature
{
  std::uint32_t value = 100;
  std::uint32_t largest = 1023;
  dc1394feature_mode_t mode = DC1394_FEATURE_MODE_AUTO;
};

/*!
  A camera. All handles to a GUID share one: the mode that one of them sets is the camera's.
*/
class SimulatedCamera
{
public:
  explicit SimulatedCamera(const CameraEntry &entry);

  /*! Whether it is on the bus still. */
  bool answers() const { return !m_isUnplugged; }

  std::vector<dc1394video_mode_t> modes() const;
  /*! Rates of a mode that is not scalable. */
  std::vector<dc1394framerate_t> framerates(dc1394video_mode_t mode) const;
  std::vector<dc1394color_coding_t> codings() const;

  void setUp(unsigned int buffers);
  void tearDown() { m_buffers.clear(); }
  bool isSetUp() const { return !m_buffers.empty(); }

  /*! As dc1394_capture_dequeue() with DC1394_CAPTURE_POLICY_WAIT. */
  dc1394error_t dequeue(dc1394video_frame_t *&frame, dc1394camera_t *handle);
  void enqueue(dc1394video_frame_t *frame);
  bool isCorrupt(const dc1394video_frame_t *frame) const;

  // Registers.
  dc1394video_mode_t mode = DC1394_VIDEO_MODE_640x480_MONO8;
  dc1394framerate_t framerate = DC1394_FRAMERATE_15;
  dc1394color_coding_t format7Coding = DC1394_COLOR_CODING_MONO8;
  unsigned int left = 0, top = 0, width = 1280, height = 960; // Format7
  dc1394switch_t transmission = DC1394_OFF;
  std::map<dc1394feature_t, Feature> features; //!< Those that it has.
  CameraEntry entry;

private:
  /*! A buffer of the ring; the frame is its first member, as in libdc1394. */
  struct Buffer
  {
    dc1394video_frame_t frame = {};
    std::vector<unsigned char> bytes;
    bool isTaken = false;
    bool isCorrupt = false;
  };

  vpImage<unsigned char> render(long number) const;
  void fill(Buffer &buffer, long number);
  double interval() const;

  std::vector<std::unique_ptr<Buffer>> m_buffers; //!< The ring.
  std::size_t m_nextBuffer = 0;
  long m_number = 0;                      //!< Of the next frame.
  long m_taken = 0;                       //!< Images taken, those that were lost as well.
  std::atomic<bool> m_isUnplugged{false}; //!< Whether it is gone.
  double m_start = 0.;                    //!< When the first image was taken, Unix time, seconds.
};
} // namespace simulated_bus

#endif
