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
 * Command line of circle-marker-simulator.
 */

#ifndef VP_SIMULATOR_COMMAND_LINE_H
#define VP_SIMULATOR_COMMAND_LINE_H

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "circle_marker/common/arguments.h"
#include "common/room.h"
#include "script.h"

namespace simulator {
/*! What to do. */
struct Order
{
  common::Room room;
  vpCameraParameters camera;
  unsigned int width = 0;
  unsigned int height = 0;
  std::vector<ScriptEvent> script;
  bool hasScript = false;
  std::string json; //!< File for a line for each image; empty: none.
  std::string shots = "simulator-%04d.png";
  double distance = 0.5; //!< At which the servo ends, metres.
  std::uint64_t seed = 1;
  bool display = true;
};

using Request = tutorial::RequestFor<Order>;

/*! \exception common::UsageError : If the arguments are wrong. */
Request parseCommandLine(int argc, const char *const argv[]);
} // namespace simulator

#endif
