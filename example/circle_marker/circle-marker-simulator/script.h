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
 * Events for the simulator: from a script.
 */

#ifndef VP_SIMULATOR_SCRIPT_H
#define VP_SIMULATOR_SCRIPT_H

#include <string>
#include <vector>

namespace simulator {
/*! One line of a script. */
struct ScriptEvent
{
  enum class Kind
  {
    Key,  //!< A key is pressed.
    Drag, //!< The mouse is dragged.
    Wait, //!< Images go by.
    Shot  //!< The picture is saved under a name.
  };

  Kind kind = Kind::Wait;
  char key = ' ';
  int button = 1;
  double du = 0., dv = 0.; //!< Pixels.
  unsigned int count = 1;  //!< Images to wait for; times a key is pressed.
  std::string file;
};

/*!
  Reads a script: lines as "key w", "key N 5" (five times), "drag 1 120 -40" (button, pixels), "wait 10" (images),
  "shot name.png"; what follows # is a comment.
  \exception std::runtime_error : If it cannot be used: the line and what is wrong.
*/
std::vector<ScriptEvent> readScript(const std::string &file);
} // namespace simulator

#endif
