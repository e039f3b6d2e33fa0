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
 * What the command line of circle-marker-experiments fixes.
 */

#ifndef VP_EXPERIMENTS_SETTINGS_H
#define VP_EXPERIMENTS_SETTINGS_H

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/footprint.h"

namespace experiments {
using namespace common;

struct Settings
{
  std::string output;                    //!< Folder.
  std::vector<std::string> experiments;  //!< Their names, see experimentNames().
  std::optional<unsigned int> frames;    //!< Of each series; the experiment's own numbers unless given.
  std::uint64_t seed = 1;                //!< Of poses, ids, noise and all else that is drawn.
  unsigned int threads = 1;              //!< Frames made at once.
  double size = defaultRing;             //!< Outer diameter of the ring, metres.
  double noise = 2.;                     //!< Standard deviation, grey levels.
  double blur = 0.7;                     //!< Standard deviation, pixels.
  std::optional<double> maximumDistance; //!< Of the marker's centre along the optical axis, metres.
  std::optional<double> maximumAngle;    //!< Between normal and line of sight, degrees.
  std::string recording;                 //!< Folder of experiment 1; empty: none.
  std::optional<int> recordedId;         //!< Of the marker in it; nothing: the one found most often.
  bool reportOnly = false;               //!< Draw the report again from the data that is there.

  /*! Side of all markers' square sheet, metres. */
  double sheetSide() const { return sheetOfRing(size); }
};
} // namespace experiments

#endif
