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
 * Settings of the circular marker detector.
 */

#ifndef VP_CIRCLE_MARKER_DETECTOR_SETTINGS_H
#define VP_CIRCLE_MARKER_DETECTOR_SETTINGS_H

#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <visp3/circle_marker/vpCircleMarkerPolarity.h>

#include "decode/identify.h"
#include "support/marker_size.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! Threads that can be asked for: more than any processor has; each has working memory of its own. */
constexpr unsigned int mostThreads = 1024;
/*! No marker has a larger id: of nine digits, which an int holds. */
constexpr int largestId = 999999999;

/*! All that a user can set. */
struct DetectorSettings
{
  std::vector<vpCircleMarkerFamily> families; //!< Families looked for.
  std::map<int, double> sizes;                //!< Sizes of single markers, metres, by id.
  DecodeSettings decode;                      //!< How strictly codes are read.
  bool refinePose = true;                     //!< Whether poses are refined on the grey levels.
  bool zAlignedWithCameraAxis = false;        //!< Marker frame: z into the marker rather than toward the camera.
  vpCircleMarkerPolarity polarity = vpCircleMarkerPolarity::BLACK_ON_WHITE; //!< Which markers are looked for.
  unsigned int threads = 1;                                                 //!< Number of threads.
  bool tracking = false;              //!< Whether markers are looked for near the places they had.
  unsigned int fullSearchPeriod = 10; //!< Tracking: every so many images, the whole one is searched.
  //! Of the camera's (px, py, u0, v0), pixels^2; 0: it is known.
  Eigen::Matrix4d cameraCovariance = Eigen::Matrix4d::Zero();
};

/*! \exception vpException::badValue : If it is no covariance: not symmetric, or a variance below 0. */
void checkCameraCovariance(const Eigen::Matrix4d &covariance);

/*!
  Reads settings from a JSON file; what it does not name stays as in \e settings.
  \exception vpException::ioError : If it cannot be read.
  \exception vpException::badValue : If it is not a JSON object, or a key or value is not known or out of range.
*/
DetectorSettings readSettings(const std::string &filename, const DetectorSettings &settings);

/*! Writes settings to a JSON file, whole or not at all. */
void writeSettings(const std::string &filename, const DetectorSettings &settings);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
