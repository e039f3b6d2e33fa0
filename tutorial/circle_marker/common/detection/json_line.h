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
 * One line of JSON for each image.
 */

#ifndef VP_TUTORIAL_JSON_LINE_H
#define VP_TUTORIAL_JSON_LINE_H

#include <optional>
#include <string>
#include <vector>

#include <visp3/circle_marker/vpCircleMarkerDatabase.h>
#include <visp3/circle_marker/vpCircleMarkerDetection.h>

#include "../visp_names.h"

namespace tutorial {
/*! When a camera took an image. */
struct LiveTiming
{
  std::optional<double> time;                //!< When it was taken, Unix time, seconds.
  std::optional<double> latencyMilliseconds; //!< From then to the end of the detection.
  unsigned long missed = 0;                  //!< Images before it that the camera took and that never arrived.
};

/*! What was found in an image. */
struct ImageResult
{
  std::string name;                                //!< The image's name.
  unsigned int width = 0;                          //!< Pixels.
  unsigned int height = 0;                         //!< Pixels.
  double cpuMilliseconds = 0.;                     //!< Time of the process for detection and pose.
  std::vector<vpCircleMarkerDetection> detections; //!< What was found, z into the markers.
  std::optional<LiveTiming> live;                  //!< When it was, if a camera took the image.
  vpCircleMarkerDatabase database;                 //!< What is known of the markers.
};

/*!
  \return One line of JSON, without the end of line. Angles are in radians, lengths in metres, image lengths in pixels,
  matrices row by row. JSON has no infinity: where "cMo2" is null, "log_odds" is the largest number of double precision.
  Markers of the database have "name" and "payload" as well, structured data as they are; a camera's images have
  "time_s", "latency_ms" (null where it is not known) and "missed" as well.
*/
std::string jsonLine(const ImageResult &result);
} // namespace tutorial

#endif
