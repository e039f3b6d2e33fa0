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
 * One template for vpDetectorAprilTag and vpDetectorCircleMarker.
 */

/*!
  \example tutorial-circle-marker-or-apriltag/main.cpp
  One template for vpDetectorAprilTag and vpDetectorCircleMarker: markers of one image, their poses, a picture of them.
*/

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <vector>

//! [Include]
#include <visp3/circle_marker/vpDetectorCircleMarker.h>
#include <visp3/detection/vpDetectorAprilTag.h>
//! [Include]
#include <visp3/core/vpDisplay.h>
#include <visp3/core/vpException.h>
#include <visp3/core/vpMeterPixelConversion.h>
#include <visp3/core/vpPoint.h>
#include <visp3/io/vpImageIo.h>

#include "../common/camera_file.h"
#include "../common/parse.h"
#include "../common/program.h"
#include "../common/visp_names.h"
#include "../common/window.h"

using namespace tutorial;

namespace {
const Program program("tutorial-circle-marker-or-apriltag");

/*! What the command line asks for. */
struct Order
{
  std::string input;                   //!< Image.
  std::string cameraFile;              //!< XML file of vpXmlParserCamera.
  std::string cameraName;              //!< Camera in it.
  std::string detector;                //!< "circle" or "apriltag".
  double size = 0.;                    //!< Metres: outer diameter of the ring, side of the tag's black square.
  bool zAlignedWithCameraAxis = false; //!< Frame of the poses: see setZAlignedWithCameraAxis().
  bool displayOff = false;             //!< Whether no window is opened.
};

/*!
  Largest distance, in pixels, between the corners that were found and the marker's points put into its pose: shows how
  the two go together.
*/
template <class Detector>
double reprojectionError(Detector &detector, std::size_t index, const vpHomogeneousMatrix &cMo, double size,
                         const vpCameraParameters &cam)
{
  //! [Points]
  std::vector<std::vector<vpImagePoint>> corners = detector.getTagsCorners();
  std::map<int, double> sizes;
  sizes[-1] = size; // of every id that is not named
  std::vector<std::vector<vpPoint>> points = detector.getTagsPoints3D(detector.getTagsId(), sizes);
  //! [Points]
  double error = 0.;
  for (std::size_t i = 0; i < points[index].size(); ++i) {
    vpPoint point = points[index][i];
    point.project(cMo);
    vpImagePoint seen;
    vpMeterPixelConversion::convertPoint(cam, point.get_x(), point.get_y(), seen);
    error = std::max(error, vpImagePoint::distance(seen, corners[index][i]));
  }
  return error;
}

/*!
  Everything below knows the detector only as a type: what is written for vpDetectorAprilTag runs with
  vpDetectorCircleMarker.
*/
//! [Template]
template <class Detector> bool findMarkers(const Order &order, vpImage<unsigned char> &I, const vpCameraParameters &cam)
{
  Detector detector;
  detector.setZAlignedWithCameraAxis(order.zAlignedWithCameraAxis);
  detector.setDisplayTag(!order.displayOff);

  std::vector<vpHomogeneousMatrix> cMo, cMo2;
  std::vector<double> errors, errors2;
  const bool found = detector.detect(I, order.size, cam, cMo, &cMo2, &errors, &errors2);

  for (size_t i = 0; i < detector.getNbObjects(); ++i) {
    std::string message = detector.getMessage(i); // "36h11 id: 5" or "golay23 id: 5"
    std::size_t position = message.find("id: ");
    if (position != std::string::npos) {
      std::cout << "id " << atoi(message.substr(position + 4).c_str()) << " of " << message << "\n";
    }
    std::cout << "polygon of " << detector.getPolygon(i).size() << " points around " << detector.getCog(i) << "\n"
              << "pose cMo, metres\n"
              << cMo[i] << "\n"
              << "corners and pose agree to " << reprojectionError(detector, i, cMo[i], order.size, cam) << " pixels"
              << std::endl;
    if (!order.displayOff) {
      vpDisplay::displayFrame(I, cMo[i], cam, order.size / 2, vpColor::none, 3);
    }
  }
  return found;
}
//! [Template]

bool findWith(const Order &order, vpImage<unsigned char> &I, const vpCameraParameters &cam)
{
  if (order.detector == "circle") {
    //! [Circle]
    return findMarkers<vpDetectorCircleMarker>(order, I, cam);
    //! [Circle]
  }
#if defined(VISP_HAVE_APRILTAG)
  //! [AprilTag]
  return findMarkers<vpDetectorAprilTag>(order, I, cam);
  //! [AprilTag]
#else
  throw vpException(vpException::notImplementedError, "this ViSP was built without AprilTag; use --detector circle");
#endif
}

bool run(const Order &order)
{
  vpImage<unsigned char> I;
  vpImageIo::read(I, order.input);
  constexpr unsigned int leastSide = 16; // pixels: ViSP's detector of AprilTags does not bear less
  if (I.getWidth() < leastSide || I.getHeight() < leastSide) {
    throw vpException(vpException::dimensionError, "\"%s\" has %u x %u pixels; at least %u x %u are needed",
                      order.input.c_str(), I.getWidth(), I.getHeight(), leastSide, leastSide);
  }
  const vpCameraParameters cam = readCamera(order.cameraFile, order.cameraName, I.getWidth(), I.getHeight()).parameters;
  std::shared_ptr<vpDisplay> display;
  if (!order.displayOff) {
    display = makeDisplay();
    if (!display) {
      throw vpException(vpException::notImplementedError, "this ViSP was built without a display; use --display-off");
    }
    display->init(I, 10, 10, order.input);
    vpDisplay::display(I);
  }
  const bool found = findWith(order, I, cam);
  if (!found) {
    std::cout << "no marker" << std::endl;
  }
  if (!order.displayOff) {
    vpDisplay::displayText(I, 20, 20, "Click to quit.", vpColor::red);
    vpDisplay::flush(I);
    vpDisplay::getClick(I);
  }
  return found;
}

RequestFor<Order> parseCommandLine(int argc, const char *const argv[])
{
  Order order;
  CLI::App app("Finds circular markers or AprilTags in an image, by the same lines of code.\n"
               "Ends with 1 where nothing is found.",
               "tutorial-circle-marker-or-apriltag");
  app.add_option("--input", order.input, "An image")->required();
  app.add_option("--intrinsic", order.cameraFile, "Camera, an XML file of ViSP with any of its models")->required();
  app.add_option("--camera-name", order.cameraName, "Name of the camera in that file")->required();
  app.add_option("--size", order.size, "Outer diameter of the ring, or side of the tag's black square, metres")
      ->required()
      ->check(tutorial::positiveNumber());
  app.add_option("--detector", order.detector, "circle (golay23) or apriltag (36h11)")
      ->required()
      ->check(CLI::IsMember({"circle", "apriltag"}));
  app.add_flag("--z-aligned", order.zAlignedWithCameraAxis,
               "z into the marker and y down, not toward the camera and up");
  app.add_flag("--display-off", order.displayOff, "Open no window");
  if (!parse(app, argc, argv)) {
    return {std::nullopt, app.help()};
  }
  return {order, ""};
}
} // namespace

int main(int argc, const char *argv[])
{
  return program.run(parseCommandLine, argc, argv, [](const Order &order) { return run(order) ? 0 : 1; });
}
