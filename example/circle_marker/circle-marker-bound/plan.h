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
 * What the planner computes: bounds over distances, the farthest distance, the least size.
 */

#ifndef VP_BOUND_PLAN_H
#define VP_BOUND_PLAN_H

#include <optional>
#include <string>
#include <vector>

#include <visp3/circle_marker_simulator/vpMarkerPoseBound.h>

#include "common/footprint.h"
#include "common/parallel.h"
#include "common/reference_camera.h"

namespace planner {
using namespace common;

/*! The accuracy that is wanted; what is not given is not asked for. */
struct Wanted
{
  std::optional<double> xy;     //!< Standard deviation along x and along y, metres.
  std::optional<double> z;      //!< Standard deviation along z, metres.
  std::optional<double> normal; //!< Root mean square of the normal's angle, radians.
  std::optional<double> wrong;  //!< Probability that the mirrored pose fits better.

  bool any() const { return xy || z || normal || wrong; }
};

/*! What the command line fixes. */
struct Settings
{
  vpCameraParameters camera = referenceCamera();
  unsigned int width = imageWidth;   //!< Pixels.
  unsigned int height = imageHeight; //!< Pixels.
  std::string family = "golay23";
  int id = 0;                   //!< Ignored by families without code.
  double ratio = 0.8;           //!< Inner over outer diameter of a plain ring.
  double size = defaultRing;    //!< Outer diameter of the ring, metres.
  vpScenePhotometry photometry; //!< Paper, ink, blur, and the noise without rounding.
  vpMarkerPoseBound::Surround surround = vpMarkerPoseBound::UNKNOWN_SURROUND;
  std::vector<double> angles = {0., 30., 60.}; //!< Between normal and line of sight, degrees.
  double minDistance = 1.;                     //!< Metres.
  double maxDistance = 20.;                    //!< Metres.
  unsigned int rows = 20;                      //!< Distances, evenly spaced.
  Wanted wanted;
  std::optional<double> sizeFor; //!< Distance for which the least size is sought, metres; else maxDistance.
  double reserve = 1.;           //!< An estimator's errors over the bound.
  unsigned int jobs = 1;         //!< Threads.
  std::string output;            //!< Folder; empty: table only.
};

/*! The limits at one distance and angle. */
struct Row
{
  double angle;    //!< Degrees.
  double distance; //!< Metres.
  double diameter; //!< Major axis of the image of the ring's outer edge, pixels.
  double minor;    //!< Minor axis, pixels.
  bool isInImage;  //!< Whether ring and quiet zone fit into the image, the marker in its middle.
  vpPoseBound bound;
  std::optional<vpPoseSeparation> separation; //!< Nothing where the marker faces the camera: the two poses are one.
};

/*! What is possible at one angle; nothing where even the nearest distance or the largest size does not do. */
struct Reach
{
  double angle;                   //!< Degrees.
  std::optional<double> distance; //!< Farthest distance that keeps the wanted accuracy, metres.
  std::optional<double> pixels;   //!< Diameter of the image there.
  std::optional<double> size;     //!< Least size that keeps it at Settings::sizeFor or maxDistance, metres.
};

/*! The noise with that of rounding to 8 bits, grey levels. */
double noiseWithRounding(double noise);

/*! Angle by angle, near to far; the marker is in the middle of the image, tilted about the camera's x axis. */
std::vector<Row> rowsOf(const Settings &settings, const Progress &progress);

/*! Whether a row keeps the wanted accuracy, with the reserve. */
bool isEnough(const Row &row, const Settings &settings);

/*! One for each angle. */
std::vector<Reach> reachesOf(const Settings &settings, const Progress &progress);
} // namespace planner

#endif
