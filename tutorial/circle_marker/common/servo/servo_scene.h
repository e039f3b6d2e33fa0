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
 * What the servo's camera looks at: an object with one or two markers, and covers in front of them.
 */

#ifndef VP_TUTORIAL_SERVO_SCENE_H
#define VP_TUTORIAL_SERVO_SCENE_H

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <visp3/circle_marker_simulator/vpMarkerSceneSimulator.h>
#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/core/vpImage.h>

#include "../visp_names.h"

namespace tutorial {
/*! Which markers the object carries, and so which detectors see it. */
enum class MarkerChoice
{
  Circle,   //!< One circular marker.
  AprilTag, //!< One AprilTag.
  Both      //!< A circular marker and an AprilTag beside it.
};

/*! In place of an id: whichever circular marker is found first. */
constexpr int anyId = -1;

/*! A marker that is fixed to the object. */
struct MountedMarker
{
  int id = 0;              //!< Number in its family, or anyId.
  double size = 0.;        //!< Outer diameter of the ring, or side of the tag's black square, metres.
  double sheet = 0.;       //!< Side of its white sheet, metres.
  vpHomogeneousMatrix oMm; //!< Pose of the marker in the object's frame.
};

/*!
  The object: its frame has z into the markers. Its origin is the marker's, with two markers the middle between them.
*/
struct ServoObject
{
  std::optional<MountedMarker> circle;   //!< A golay23 marker.
  std::optional<MountedMarker> aprilTag; //!< An AprilTag 36h11.

  std::vector<MountedMarker> markers() const;
};

ServoObject makeObject(MarkerChoice choice);

/*! A camera: its parameters and the size of its images. */
struct ServoCamera
{
  vpCameraParameters parameters;
  unsigned int width = 0;  //!< Pixels.
  unsigned int height = 0; //!< Pixels.
};

/*!
  \return The camera of a file of ViSP; without a file the reference camera of the project's figures, data/camera.xml.
  \exception CameraError : If there is no such camera, or the file does not say how large its images are.
*/
ServoCamera servoCamera(const std::string &file, const std::string &name);

/*! Which of the markers have something in front of them. */
struct Covers
{
  bool circle = false;
  bool aprilTag = false;
};

/*!
  \return The image of the object, with noise of 2 grey levels and blur of 0.7 pixels.
  \param camera : The camera.
  \param object : The object.
  \param cMo : Its true pose.
  \param covers : What is covered.
  \param seed : Of the noise.
*/
vpImage<unsigned char> renderScene(const ServoCamera &camera, const ServoObject &object, const vpHomogeneousMatrix &cMo,
                                   const Covers &covers, std::uint64_t seed);

/*!
  \return The corners of a marker's sheet in the object's frame, metres, as homogeneous columns.
*/
std::vector<vpColVector> sheetCorners(const MountedMarker &marker);

/*! Ranges of the random starts. */
struct StartRange
{
  double nearest = 0.5;        //!< Least distance of the object's origin, metres.
  double farthest = 4.;        //!< Greatest distance, metres.
  double steepest = M_PI / 3.; //!< Greatest angle between the normal and the line of sight, radians.
  double margin = 10.;         //!< Least distance of the sheets from the image's border, pixels.
};

/*!
  \return A random pose of the object: distance and tilt uniform, the direction of the tilt and the spin any, every
  sheet inside the image.
  \exception vpException::badValue : If no such pose can be found.
*/
vpHomogeneousMatrix randomStart(const ServoCamera &camera, const ServoObject &object, const StartRange &range,
                                std::uint64_t seed);
} // namespace tutorial

#endif
