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
 * What is compared: markers, camera, cells of poses, methods.
 */

#ifndef VP_COMPARE_EXPERIMENT_H
#define VP_COMPARE_EXPERIMENT_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "common/detectors.h"
#include "common/footprint.h"
#include "common/reference_camera.h"

namespace compare {
using namespace common;

/*! A range of poses, as in the columns of the thesis's table 5.6. */
struct Cell
{
  double maxTilt;     //!< Greatest angle between the marker's normal and the line of sight, degrees.
  double maxDistance; //!< Greatest depth of the marker's centre, metres.
};

constexpr std::array<Cell, 5> cells = {{{30, 10.4}, {60, 10.4}, {60, 18.4}, {90, 10.4}, {90, 18.4}}};

/*! Least depth of the marker's centre, metres: the thesis's. */
constexpr double minDistance = 0.36;

/*! The ways from an image to a pose that are compared. */
enum class Method
{
  Circle,
  AprilTag1,          //!< Decimation 1: the image as it is.
  AprilTag1HalfPixel, //!< The same, with the principal point moved by half a pixel.
  AprilTag2,          //!< Decimation 2: quadrilaterals are sought in the image at half its size.
  AprilTag2HalfPixel
};

constexpr std::size_t methodCount = 5;
constexpr std::array<const char *, methodCount> methodNames = {"circle", "apriltag-1", "apriltag-1-half-pixel",
                                                               "apriltag-2", "apriltag-2-half-pixel"};

constexpr std::size_t indexOf(Method method)
{
  return static_cast<std::size_t>(method);
}

constexpr const char *circleFamily = "golay23";
constexpr int circleIds = 178;
constexpr const char *tagFamily = "36h11";

/*! What the command line fixes. */
struct Settings
{
  std::string output;                //!< Folder.
  unsigned int frames = 100;         //!< Of each cell.
  std::uint64_t seed = 1;            //!< Of poses, ids and noise.
  unsigned int threads = 1;          //!< More than one disturb the CPU times.
  double size = defaultRing;         //!< Outer diameter of the circle's ring, metres.
  double noise = 2.;                 //!< Standard deviation, grey levels.
  double blur = 0.7;                 //!< Standard deviation, pixels.
  std::string tagPose = bestTagPose; //!< One of tagPoseMethods(); the most accurate, see --help.

  /*! Side of both markers' square sheet, metres. */
  double sheetSide() const { return sheetOfRing(size); }
  /*! Side of the tag's black square, metres. */
  double tagSize() const { return tagOnSheet(sheetSide()); }
};
} // namespace compare

#endif
