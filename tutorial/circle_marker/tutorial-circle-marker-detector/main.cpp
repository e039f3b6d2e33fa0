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
 * Finds circular markers in images: identity, both poses, covariance.
 */

/*!
  \example tutorial-circle-marker-detector/main.cpp
  Finds circular markers in images: identity, both poses, covariance.
*/

#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>

#include <unistd.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <visp3/circle_marker/vpDetectorCircleMarker.h>
#include <visp3/io/vpImageIo.h>

#include "../common/camera_file.h"
#include "../common/detection/debug_overlay.h"
#include "../common/detection/image_source.h"
#include "../common/detection/json_line.h"
#include "../common/detection/marker_overlay.h"
#include "../common/interruption.h"
#include "../common/numbered_name.h"
#include "../common/processor_time.h"
#include "../common/program.h"
#include "../common/visp_names.h"
#include "../common/whole_file.h"
#include "../common/window.h"
#include "command_line.h"

using namespace tutorial;

namespace {
const Program program("tutorial-circle-marker-detector");

/*! What is freed stays with the program, where the system's library can do that, up to blocks of 32 megabytes. */
void keepFreedMemory()
{
#ifdef __GLIBC__
  constexpr int megabyte = 1 << 20;
  mallopt(M_MMAP_THRESHOLD, 32 * megabyte);
  mallopt(M_TRIM_THRESHOLD, 512 * megabyte);
#endif
}

//! [Detection]
ImageResult detectMarkers(vpDetectorCircleMarker &detector, const SourceImage &source, double size,
                          const vpCameraParameters &cam)
{
  std::vector<vpHomogeneousMatrix> cMo;
  const double start = processorMilliseconds();
  detector.detect(*source.image, size, cam, cMo);
  const double end = processorMilliseconds();
  return ImageResult{source.name,           source.image->getWidth(), source.image->getHeight(),
                     end - start,           detector.getDetections(), std::nullopt,
                     detector.getDatabase()};
}
//! [Detection]

/*!
  Reads, detects and reports one image after the other.
*/
class Run
{
public:
  explicit Run(const Order &order)
      : m_order(order), m_detector(makeDetector(order.detector)),
        m_source(openSource(order.input, order.first, order.last)), m_overlayName(NumberedName::parse(order.overlay))
  {
    if (!order.overlay.empty() && !m_overlayName && m_source->size() > 1) {
      throw UsageError("--overlay names one picture for many images; use a number in the name, overlay-%04d.png");
    }
    if (!order.json.empty()) {
      checkWritable(order.json);
    }
    makeFolder(order.debug, "--debug");
    m_detector.setDebug(!order.debug.empty());
    if (order.display) {
      m_window.emplace("Circular markers", 10, 10);
    }
    else { // a window waits for a click, and would not hear of it
      watchInterruption();
    }
  }

  /*! \return Whether all inputs could be used. */
  bool all()
  {
    const bool showProgress = isatty(STDERR_FILENO) != 0 && m_source->size() > 10;
    std::size_t done = 0;
    while (const std::optional<SourceImage> source = isInterrupted() ? std::nullopt : m_source->next()) {
      one(*source);
      ++done;
      if (showProgress) {
        std::cerr << "\r" << done << " of " << m_source->size() << std::flush;
      }
      if (m_quit) {
        break;
      }
    }
    if (showProgress) {
      std::cerr << std::endl;
    }
    if (isInterrupted()) {
      m_allUsed = false;
      program.complain("interrupted after " + std::to_string(done) + " images; what was found in them is kept");
    }
    if (!m_order.json.empty()) {
      writeWholeText(m_order.json, m_lines);
    }
    return m_allUsed;
  }

private:
  void one(const SourceImage &source)
  {
    try {
      if (!source.image) {
        throw vpException(vpException::ioError, source.problem);
      }
      const vpCameraParameters cam = cameraFor(source);
      getReady(*source.image, cam);
      const ImageResult result = detectMarkers(m_detector, source, m_order.detector.size, cam);
      keep(jsonLine(result));
      showOverlay(source, result, cam);
      writeRooms(source, cam);
    }
    catch (const vpException &e) {
      leaveOut(source, e.what());
    }
    catch (const CameraError &e) { // of the first image it is an argument that is wrong
      if (!m_hadCamera) {
        throw;
      }
      leaveOut(source, e.what());
    }
  }

  // The first detection in images of a size takes its memory from the system, ten times as long as the next one. That
  // is no time of detection: a copy of the detector does it before, and leaves its memory to the program.
  void getReady(const vpImage<unsigned char> &I, const vpCameraParameters &cam)
  {
    if (I.getSize() > m_readyFor) {
      keepFreedMemory();
      std::vector<vpHomogeneousMatrix> cMo;
      vpDetectorCircleMarker(m_detector).detect(I, m_order.detector.size, cam, cMo);
      m_readyFor = I.getSize();
    }
  }

  void leaveOut(const SourceImage &source, const std::string &problem)
  {
    m_allUsed = false;
    program.complain("\"" + source.name + "\" is left out: " + problem);
  }

  void keep(const std::string &line)
  {
    if (m_order.json.empty()) {
      std::cout << line << std::endl;
    }
    else {
      m_lines += line + "\n";
    }
  }

  vpCameraParameters cameraFor(const SourceImage &source)
  {
    const unsigned int width = source.image->getWidth(), height = source.image->getHeight();
    if (m_camera && width == m_width && height == m_height) {
      return m_camera->parameters;
    }
    m_camera = readCamera(m_order.cameraFile, m_order.cameraName, width, height);
    m_hadCamera = true;
    m_width = width;
    m_height = height;
    if (m_camera->width != 0 && (m_camera->width != width || m_camera->height != height)) {
      std::ostringstream message;
      message << "the camera \"" << m_order.cameraName << "\" of \"" << m_order.cameraFile << "\" is for images of "
              << m_camera->width << " x " << m_camera->height << " pixels, but \"" << source.name << "\" has " << width
              << " x " << height << "; its parameters are used as they are: check that they are the right ones";
      program.complain(message.str());
    }
    return m_camera->parameters;
  }

  void showOverlay(const SourceImage &source, const ImageResult &result, const vpCameraParameters &cam)
  {
    if (m_order.overlay.empty() && !m_window) {
      return;
    }
    const vpImage<vpRGBa> picture = markerOverlay(*source.image, result.detections, cam);
    if (!m_order.overlay.empty()) {
      writeOverlay(m_overlayName ? (*m_overlayName)(source.number) : m_order.overlay, picture);
    }
    if (m_window) {
      showInWindow(picture);
    }
  }

  //! [Debug]
  void writeRooms(const SourceImage &source, const vpCameraParameters &cam)
  {
    if (m_order.debug.empty()) {
      return;
    }
    std::ostringstream start;
    start << m_order.debug << "/" << std::setw(4) << std::setfill('0') << source.number << "-";
    for (const RoomPicture &room : roomPictures(*source.image, m_detector, cam)) {
      writeOverlay(start.str() + room.name + ".png", room.picture);
    }
    writeWholeText(start.str() + "candidates.csv", candidateTable(m_detector.getDebug()));
  }
  //! [Debug]

  void writeOverlay(const std::string &path, const vpImage<vpRGBa> &picture)
  {
    try {
      writeWhole(path, [&picture](const std::string &temporary) { vpImageIo::write(picture, temporary); });
    }
    catch (const vpException &e) {
      m_allUsed = false;
      program.complain(e.what());
    }
  }

  void showInWindow(const vpImage<vpRGBa> &picture)
  {
    try {
      m_window->show(picture, "Click: next image. Right click: quit.");
      m_quit = m_window->click(true) == vpMouseButton::button3;
    }
    catch (const std::exception &e) {
      program.complain(std::string("no window can be opened (") + e.what() +
                       "); going on without, --display-off does so silently");
      m_window.reset();
    }
  }

  Order m_order;                             //!< What to do.
  vpDetectorCircleMarker m_detector;         //!< Finds the markers.
  std::unique_ptr<ImageSource> m_source;     //!< Where the images come from.
  std::optional<NumberedName> m_overlayName; //!< Names of the pictures, if they have a number.
  std::optional<Window> m_window;            //!< Shows the pictures.
  std::optional<NamedCamera> m_camera;       //!< Camera for images of the size below.
  bool m_hadCamera = false;                  //!< Whether there was one for any image.
  unsigned int m_readyFor = 0;               //!< Pixels of an image for which memory was had.
  unsigned int m_width = 0;                  //!< Pixels.
  unsigned int m_height = 0;                 //!< Pixels.
  std::string m_lines;                       //!< Results so far.
  bool m_allUsed = true;                     //!< Whether no image was skipped.
  bool m_quit = false;                       //!< Whether the user has had enough.
};
} // namespace

int main(int argc, const char *argv[])
{
  return program.run(parseCommandLine, argc, argv, [](const Order &order) {
    Run run(order);
    return run.all() ? 0 : 1;
  });
}
