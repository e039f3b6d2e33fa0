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
 * The tasks that markers carry, and how a robot follows them.
 */

#ifndef VP_NAVIGATION_TASKS_H
#define VP_NAVIGATION_TASKS_H

#include <optional>
#include <string>

#include "robot.h"

namespace navigation {
/*! A task. */
struct Task
{
  bool isStop = false; //!< The end of the tour; otherwise:
  FloorPose goal;      //!< Where to go.
};

/*!
  Reads a payload: {"task": "go", "to": [x, z], "look_deg": d} with metres and degrees, or {"task": "stop"}.
  \exception std::runtime_error : If it is none.
*/
Task taskOf(const std::string &payload);

/*!
  Follows a task: turns to the goal, drives there, turns as is asked.
*/
class Driver
{
public:
  explicit Driver(const FloorPose &goal) : m_goal(goal) {}

  /*! \return What to do next; nothing: it is there. */
  std::optional<Command> next(const FloorPose &believed, double time);

private:
  FloorPose m_goal;          //!< Where to go.
  bool m_hasArrived = false; //!< Only the direction is left.
};
} // namespace navigation

#endif
