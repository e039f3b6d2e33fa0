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
 * The robot that stands in for yours: a camera that flies as it is told.
 */

#include "user_robot.h"

#include <visp3/robot/vpSimulatorCamera.h>

#include "../../common/servo/servo_eyes.h"

namespace tutorial {
//! [User robot]
std::unique_ptr<vpRobot> makeUserRobot(const std::string &)
{
  auto robot = std::make_unique<vpSimulatorCamera>();
  // Where the marker is at the start: 1 m away, to the side and tilted.
  prepareRobot(*robot, vpHomogeneousMatrix(0.1, -0.05, 1., 0.4, -0.3, 0.5));
  return robot;
}
//! [User robot]
} // namespace tutorial
