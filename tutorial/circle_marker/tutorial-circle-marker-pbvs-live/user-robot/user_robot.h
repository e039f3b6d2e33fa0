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
 * Your robot, for tutorial-circle-marker-pbvs-live.
 */

#ifndef VP_TUTORIAL_USER_ROBOT_H
#define VP_TUTORIAL_USER_ROBOT_H

#include <memory>
#include <string>

#include <visp3/robot/vpRobot.h>

#include "../../common/visp_names.h"

namespace tutorial {
/*!
  Makes the robot that carries the camera, ready to take velocities. Write this function for your robot in a file of
  your own, and give it to CMake: -DCIRCLE_MARKER_ROBOT_SOURCE=my_robot.cpp. user_robot.cpp is an example.

  The program uses two functions of it: setRobotState() with STATE_VELOCITY_CONTROL at the start and STATE_STOP at the
  end, and setVelocity(vpRobot::CAMERA_FRAME, v) with v in m/s and rad/s after each image; zeros when no marker is
  seen, when images do not come, and at the end. So the robot must know where the camera is on it (eMc; most of ViSP's
  robots have set_eMc()), and should stop by itself when it hears nothing for some time.

  \param address : What the user has given with --robot-address; may be empty.
  \exception vpException : If the robot cannot be used.
*/
std::unique_ptr<vpRobot> makeUserRobot(const std::string &address);
} // namespace tutorial

#endif
