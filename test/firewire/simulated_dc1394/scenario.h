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
 * What happens on the simulated bus.
 */

#ifndef VP_TEST_DC1394_SCENARIO_H
#define VP_TEST_DC1394_SCENARIO_H

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <visp3/core/vpHomogeneousMatrix.h>

#include <visp3/circle_marker_simulator/vpConfigCircleMarkerSimulator.h>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace simulated_bus {
/*! A camera on the bus. */
struct CameraEntry
{
  std::uint64_t guid = 0;
  std::string vendor, model;
};

/*! A marker of a sheet, z into the sheet. */
struct SheetMarker
{
  int id = 0;
  double size = 0.;      //!< Outer diameter of its ring, metres.
  double x = 0., y = 0.; //!< Of its centre on the sheet, metres.
};

/*!
  The content of the file that the environment variable CIRCLE_MARKER_SIMULATED_BUS names (JSON); without it the bus is
  empty. Numbers of frames count from 0, as the cameras deliver them.
*/
struct Scenario
{
  bool libraryFails = false;              //!< dc1394_new() gives nothing.
  bool listFails = false;                 //!< The cameras cannot be listed.
  bool openFails = false;                 //!< No camera can be opened.
  bool setupFails = false;                //!< No bandwidth is left on the bus.
  bool isUsb = false;                     //!< As libdc1394 does with USB: no time stamps, failed frames are delivered.
  bool isRealTime = false;                //!< Images come at the camera's rate, or as fast as they are asked for.
  std::vector<CameraEntry> cameras;       //!< On the bus.
  std::optional<long> unplugAt;           //!< From this frame on nothing answers.
  std::optional<long> silentAt;           //!< From this frame on no image comes, and libdc1394 waits without end.
  std::set<long> corrupt;                 //!< Frames of which libdc1394 knows that packets were lost.
  std::set<long> truncated;               //!< Frames that are too short.
  std::set<long> undeliverable;           //!< Frames that cannot be delivered though the camera answers.
  std::set<long> afterGap;                //!< Frames before which two were lost.
  double focalLength = 1600.;             //!< Of images of 1280 x 960, pixels.
  std::string family = "golay23";         //!< Of the marker that the cameras see.
  int id = 5;                             //!< Of the marker.
  double size = 0.18;                     //!< Outer diameter of its ring, metres.
  std::vector<SheetMarker> sheet;         //!< In place of the one marker: a white sheet with these.
  std::vector<vpHomogeneousMatrix> poses; //!< cMo of the frames, from the first again after the last.
  bool isSameNoise = false;               //!< Every frame has the noise and the pose of the first.
  std::string poseFile;                   //!< 16 numbers: cMo of the next frame, in place of the poses.
  std::string log;                        //!< What the cameras were told is appended to this file.
};

/*! The scenario of this process. */
const Scenario &scenario();

/*! Appends a line to the log, if there is one. */
void log(const std::string &line);
} // namespace simulated_bus

#endif
