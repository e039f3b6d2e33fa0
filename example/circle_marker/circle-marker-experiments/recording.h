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
 * Recorded images of a marker at several places, as the detector's programs describe them.
 */

#ifndef VP_EXPERIMENTS_RECORDING_H
#define VP_EXPERIMENTS_RECORDING_H

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace experiments {
using Triple = std::array<double, 3>; //!< x, y, z of the camera frame.
using Square = std::array<Triple, 3>; //!< Rows of a matrix of 3 x 3.

/*! The marker in one image. */
struct Sight
{
  Triple centre;     //!< eC, camera frame, mm.
  Triple normal;     //!< eN, camera frame, toward the viewer, of length 1.
  Square covariance; //!< Of the centre, as the detector states it, mm^2.
};

/*! What was found in one image. */
struct Picture
{
  std::size_t markers = 0;    //!< Of any id.
  std::optional<Sight> sight; //!< Of the marker of the recording; nothing: not found.
  double cpuTime = 0.;        //!< Of detection and pose, ms.
};

/*! Images that were taken with the marker at one place, or while it was slid along a line. */
struct Station
{
  std::string name;               //!< Of its folder.
  std::optional<double> distance; //!< Metres, as measured by tape; nothing: a slide.
  std::vector<Picture> pictures;  //!< In their order.
};

struct Recording
{
  std::string family;            //!< Of the marker.
  int id = -1;                   //!< Of the marker; -1: a family without code.
  double size = 0.;              //!< Of the marker, metres, as the detector was told.
  std::vector<Station> stations; //!< By distance, slides at the end.
};

/*!
  Reads a recording: a folder with a folder for each station, which holds a file poses.jsonl, as
  tutorial-circle-marker-detector-live --record writes it and tutorial-circle-marker-detector --json. A station is named
  after its distance (2m, 2.5m), or begins with "slide".

  \param folder : Its path.
  \param id : Of the marker; nothing: the one that is found most often.
  \exception DataError : If there is no recording that can be used.
*/
Recording recordingIn(const std::string &folder, std::optional<int> id);
} // namespace experiments

#endif
