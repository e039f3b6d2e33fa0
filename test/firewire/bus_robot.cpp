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
 * A robot as a user supplies it: it moves the camera of the simulated bus.
 */

#include <cstdio>
#include <fstream>
#include <iomanip>

#include <visp3/core/vpException.h>
#include <visp3/core/vpExponentialMap.h>
#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/robot/vpRobot.h>

#include "tutorial-circle-marker-pbvs-live/user-robot/user_robot.h"

namespace tutorial {
namespace {
constexpr double period = 0.04; // seconds from one velocity to the next

/*!
  Writes the pose of the marker in its camera's frame to a file, from which the simulated bus takes it, and every
  velocity to a second file.
*/
class BusRobot : public vpRobot
{
public:
  explicit BusRobot(const std::string &address) : m_address(address), m_cMo(0.1, -0.05, 1., 0.4, -0.3, 0.5)
  {
    if (address.empty()) {
      throw vpException(vpException::badValue, "the robot needs --robot-address");
    }
    std::ofstream(m_address + ".log") << "";
    tell();
  }

  void setVelocity(const vpRobot::vpControlFrameType frame, const vpColVector &velocity) override
  {
    if (frame != vpRobot::CAMERA_FRAME || getRobotState() != vpRobot::STATE_VELOCITY_CONTROL) {
      throw vpException(vpException::badValue, "not in velocity control of the camera's frame");
    }
    m_cMo = vpExponentialMap::direct(velocity, period).inverse() * m_cMo;
    std::ofstream(m_address + ".log", std::ios::app) << velocity.t() << std::endl;
    tell();
  }

  void get_eJe(vpMatrix &) override {}
  void get_fJe(vpMatrix &) override {}
  void getDisplacement(const vpRobot::vpControlFrameType, vpColVector &) override {}
  void getPosition(const vpRobot::vpControlFrameType, vpColVector &) override {}
  void init() override {}
  void setPosition(const vpRobot::vpControlFrameType, const vpColVector &) override {}

private:
  /*! Written whole: the bus reads at any time. */
  void tell() const
  {
    std::ofstream file(m_address + ".new");
    file << std::setprecision(17);
    for (unsigned int i = 0; i < 16; ++i) {
      file << m_cMo[i / 4][i % 4] << ' ';
    }
    file.close();
    std::rename((m_address + ".new").c_str(), m_address.c_str());
  }

  std::string m_address;     //!< The file.
  vpHomogeneousMatrix m_cMo; //!< Pose of the marker in the camera's frame.
};
} // namespace

std::unique_ptr<vpRobot> makeUserRobot(const std::string &address)
{
  return std::make_unique<BusRobot>(address);
}
} // namespace tutorial
