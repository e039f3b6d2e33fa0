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
 * Finds circular markers in the images of a camera: identity, both poses, covariance.
 */

/*!
  \example tutorial-circle-marker-detector-live/main.cpp
  Finds circular markers in the images of a FireWire, V4L2 or OpenCV camera: identity, both poses, covariance.
*/

#include <chrono>
#include <cmath>
#include <iostream>
#include <optional>
#include <string>

#include <unistd.h>

#include <visp3/circle_marker/vpDetectorCircleMarker.h>

#include "../common/cameras/frame_feed.h"
#include "../common/cameras/region_camera.h"
#include "../common/detection/json_line.h"
#include "../common/detection/marker_overlay.h"
#include "../common/interruption.h"
#include "../common/processor_time.h"
#include "../common/program.h"
#include "../common/visp_names.h"
#include "../common/whole_file.h"
#include "command_line.h"
#include "live_statistics.h"
#include "live_window.h"
#include "recorder.h"

using namespace tutorial;

namespace {
const Program program("tutorial-circle-marker-detector-live");

//! [Detection]
ImageResult detectMarkers(vpDetectorCircleMarker &detector, const Frame &frame, const DetectorSettings &settings,
                          const vpCameraParameters &cam)
{
  std::vector<vpHomogeneousMatrix> cMo;
  // Of this thread where it does all the work: others acquire and record at the same time.
  const auto clock = detector.getNbThreads() > 1 ? processorMilliseconds : threadMilliseconds;
  const double start = clock();
  detector.detect(frame.image, settings.size, cam, cMo);
  const double end = clock();
  LiveTiming timing;
  timing.time = frame.time;
  timing.missed = frame.missed;
  if (const double latency = unixSeconds() - frame.time.value_or(HUGE_VAL); latency >= 0.) {
    timing.latencyMilliseconds = 1e3 * latency;
  }
  return ImageResult{frame.name, frame.image.getWidth(), frame.image.getHeight(), end - start, detector.getDetections(),
                     timing,     detector.getDatabase()};
}
//! [Detection]

/*!
  Detects in one image of the camera after the other.
*/
class Run
{
public:
  explicit Run(const Order &order)
      : m_order(order), m_detector(makeDetector(order.detector)), m_camera(order.cameraFile, order.cameraName)
  {
    if (!order.record.empty()) {
      m_recorder.emplace(order.record);
    }
    std::unique_ptr<FrameSource> source = openFrameSource(order.camera);
    if (!order.json.empty()) {
      checkWritable(order.json);
    }
    m_region = source->region();
    // A recording does not run away.
    const bool isAll = order.allImages || !source->isLive();
    m_feed.emplace(std::move(source), isAll ? FrameFeed::Use::All : FrameFeed::Use::Newest);
    if (order.display) {
      m_window.emplace(m_recorder.has_value());
    }
  }

  /*! \return Whether the camera was well until the end. */
  bool all()
  {
    try {
      while (!isOver()) {
        step();
      }
    }
    catch (const SourceError &e) {
      m_isGood = false;
      endProgress();
      program.complain(e.what());
    }
    finish();
    return m_isGood && m_feed->counts().damaged == 0;
  }

private:
  bool isOver() const
  {
    const bool isQuit = m_window && m_window->choices().quit;
    const bool isEnough = m_order.count && m_feed->counts().delivered >= *m_order.count;
    return isQuit || isEnough || m_isEnd || isInterrupted();
  }

  //! [Step]
  void step()
  {
    constexpr std::chrono::milliseconds patience(30); // so that keys and clicks are seen at once
    FrameFeed::Delivery delivery = m_feed->wait(patience);
    if (!delivery.damage.empty()) {
      endProgress();
      program.complain(delivery.damage);
    }
    if (delivery.frame) {
      oneOrNone(*delivery.frame);
    }
    m_isEnd = delivery.isEnd;
    const double silence = m_feed->silence();
    if (!m_isEnd && !delivery.frame && silence > m_order.timeout) {
      throw SourceError(silenceMessage(m_order.camera.name, m_order.timeout));
    }
    if (m_window && m_window->readInput()) {
      redraw();
    }
  }
  //! [Step]

  // An image that cannot be used, such as one of 8 x 8 pixels, is left out; what was found in the others is kept.
  void oneOrNone(const Frame &frame)
  {
    try {
      one(frame);
    }
    catch (const CameraError &e) { // of the first image it is an argument that is wrong
      if (m_isFirst) {
        throw;
      }
      leaveOut(frame, e.what());
    }
    catch (const vpException &e) {
      leaveOut(frame, e.what());
    }
    m_isFirst = false;
  }

  void leaveOut(const Frame &frame, const std::string &reason)
  {
    m_isGood = false;
    endProgress();
    program.complain("\"" + frame.name + "\" is left out: " + reason);
  }

  void one(const Frame &frame)
  {
    if (m_window && m_window->choices().hold) {
      return; // the camera goes on, the picture stays
    }
    const vpImage<unsigned char> &image = frame.image;
    const vpCameraParameters cam = m_camera.forImage(image.getWidth(), image.getHeight(), m_region);
    for (const std::string &note : m_camera.newNotes()) {
      program.complain(note);
    }
    m_result = detectMarkers(m_detector, frame, m_order.detector, cam);
    const bool isRecorded = m_recorder && (!m_window || m_window->choices().record);
    if (isRecorded) {
      m_result.name = m_recorder->nextName();
    }
    const std::string line = jsonLine(m_result);
    keep(line);
    if (isRecorded) {
      m_recorder->record(image, line);
    }
    m_statistics.add(m_result.cpuMilliseconds, m_result.live->latencyMilliseconds);
    if (m_window) {
      m_image = image;
      m_cam = cam;
      redraw();
    }
    progress();
  }

  void keep(const std::string &line)
  {
    if (!m_order.json.empty()) {
      m_lines += line + "\n";
    }
    else if (!m_recorder) {
      std::cout << line << std::endl;
    }
  }

  void redraw()
  {
    if (m_image.getSize() == 0) {
      return;
    }
    std::vector<std::string> status = m_statistics.lines(m_feed->counts());
    if (m_recorder) {
      status.push_back(std::to_string(m_recorder->count()) + " recorded");
    }
    try {
      m_window->show(markerOverlay(m_image, m_result.detections, m_cam, m_window->choices().details), status);
    }
    catch (const vpException &e) {
      program.complain(std::string("no window can be opened (") + e.what() +
                       "); going on without, --display-off does so silently; Ctrl-C ends");
      m_window.reset();
    }
  }

  void progress()
  {
    if (!m_window && isatty(STDERR_FILENO) != 0) {
      const std::vector<std::string> lines = m_statistics.lines(m_feed->counts());
      std::cerr << "\r" << lines[0] << "  " << lines[1] << "   " << std::flush;
      m_hasProgress = true;
    }
  }

  void endProgress()
  {
    if (m_hasProgress) {
      std::cerr << std::endl;
      m_hasProgress = false;
    }
  }

  void finish()
  {
    endProgress();
    if (!m_order.json.empty()) { // first: the disk of the recording may be full
      writeWholeText(m_order.json, m_lines);
    }
    if (m_recorder) {
      m_recorder->finish();
    }
    std::cerr << LiveStatistics::summary(m_feed->counts()) << std::endl;
  }

  Order m_order;                      //!< What to do.
  vpDetectorCircleMarker m_detector;  //!< Finds the markers.
  RegionCamera m_camera;              //!< Camera parameters for the images.
  ImageRegion m_region;               //!< Of the camera's whole image.
  std::optional<Recorder> m_recorder; //!< Records the images.
  std::optional<FrameFeed> m_feed;    //!< Gives the images.
  std::optional<LiveWindow> m_window; //!< Shows them.
  LiveStatistics m_statistics;        //!< How it keeps up.
  vpImage<unsigned char> m_image;     //!< The last image.
  vpCameraParameters m_cam;           //!< Its camera.
  ImageResult m_result;               //!< What was found in it.
  std::string m_lines;                //!< Results so far.
  bool m_isFirst = true;              //!< Whether no image has been used or left out yet.
  bool m_isEnd = false;               //!< Whether there are no more images.
  bool m_isGood = true;               //!< Whether the camera has not failed.
  bool m_hasProgress = false;         //!< Whether a line of progress is being written.
};
} // namespace

int main(int argc, const char *argv[])
{
  return program.run(parseCommandLine, argc, argv, [](const Order &order) {
    watchInterruption();
    Run run(order);
    return run.all() ? 0 : 1;
  });
}
