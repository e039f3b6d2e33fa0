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
 * The command line of tutorial-circle-marker-pbvs.
 */

#ifndef VP_TUTORIAL_PBVS_COMMAND_LINE_H
#define VP_TUTORIAL_PBVS_COMMAND_LINE_H

#include <cstdint>
#include <optional>
#include <string>

#include "../common/arguments.h"
#include "../common/servo/servo_scene.h"

namespace tutorial {
/*! What the program is asked to do. */
struct Order
{
  MarkerChoice markers = MarkerChoice::Circle; //!< What the object carries.
  bool display = true;                         //!< Whether to open windows.
  std::string folder = ".";                    //!< For table, plot and pictures.
  std::uint64_t seed = 1;                      //!< Of starts and noise.
  std::optional<double> distance;              //!< Of the start, metres.
  unsigned int runs = 1;                       //!< Number of random starts.
  std::string cameraFile;                      //!< XML file; empty: the reference camera.
  std::string cameraName = "Camera";           //!< Name of the camera in it.
};

using Request = RequestFor<Order>;

/*!
  \exception UsageError : If the arguments are wrong.
*/
Request parseCommandLine(int argc, const char *const argv[]);
} // namespace tutorial

#endif
