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
 * A robot on wheels, as it is and as it believes to be.
 */

#include "robot.h"

#include <cmath>

#include <Eigen/LU>

#include <visp3/core/vpThetaUVector.h>

namespace navigation {
namespace {
// Noise of the wheels: shares of the way and of the turn that a command makes, in one step.
constexpr double speedNoise = 0.03;
constexpr double turnNoise = 0.03;
// What the robot believes of its wheels: noise and constant error together, and a little that is always there.
constexpr double believedSpeedError = 0.06;
constexpr double believedTurnError = 0.06;
constexpr double leastWay = 1e-3;  // metres in a step
constexpr double leastTurn = 1e-3; // radians in a step
} // namespace

double wrapped(double angle)
{
  return angle - 2. * M_PI * std::ceil((angle - M_PI) / (2. * M_PI));
}

FloorPose advanced(const FloorPose &pose, const Command &command, double time)
{
  // The chord of the arc has the mean direction.
  const double half = 0.5 * command.turn * time;
  const double chord = command.speed * time * (half != 0. ? std::sin(half) / half : 1.);
  const double mean = pose.direction + half;
  return FloorPose{pose.x + chord * std::sin(mean), pose.z + chord * std::cos(mean),
                   wrapped(pose.direction + 2. * half)};
}

double TrueRobot::normal()
{
  // Box and Muller: the same numbers with every compiler.
  const double a = (static_cast<double>(m_random() >> 11) + 0.5) / 9007199254740992.;
  const double b = static_cast<double>(m_random() >> 11) / 9007199254740992.;
  return std::sqrt(-2. * std::log(a)) * std::cos(2. * M_PI * b);
}

void TrueRobot::obey(const Command &command, double time)
{
  Command real;
  real.speed = command.speed * (1. + m_speedError + speedNoise * normal());
  real.turn = command.turn * (1. + m_turnError + turnNoise * normal());
  m_pose = advanced(m_pose, real, time);
}

Belief::Belief(const FloorPose &start) : m_pose(start)
{
  // It was put there by hand: to 5 cm and 3 degrees.
  m_covariance = Eigen::Vector3d(0.05 * 0.05, 0.05 * 0.05, 0.05 * 0.05).asDiagonal();
}

void Belief::predict(const Command &command, double time)
{
  const double way = command.speed * time, turn = command.turn * time;
  const double mean = m_pose.direction + 0.5 * turn;
  Eigen::Matrix3d F = Eigen::Matrix3d::Identity();
  F(0, 2) = way * std::cos(mean);
  F(1, 2) = -way * std::sin(mean);
  Eigen::Matrix<double, 3, 2> G;
  G << std::sin(mean), 0.5 * way * std::cos(mean), std::cos(mean), -0.5 * way * std::sin(mean), 0., 1.;
  const Eigen::Vector2d noise(believedSpeedError * way + leastWay, believedTurnError * std::abs(turn) + leastTurn);
  m_covariance =
      F * m_covariance * F.transpose() + G * noise.cwiseProduct(noise).asDiagonal().toDenseMatrix() * G.transpose();
  m_pose = advanced(m_pose, command, time);
}

void Belief::correct(const Location &location)
{
  const vpHomogeneousMatrix &wMc = location.wMc;
  // The camera's axis on the floor; small rolls and tilts are the measurement's own errors.
  const double measured = std::atan2(wMc[0][2], wMc[2][2]);
  // Errors of x, z (world) and of the direction (about y, which is down) by those in the camera's frame.
  Eigen::Matrix<double, 3, 6> J = Eigen::Matrix<double, 3, 6>::Zero();
  for (unsigned int k = 0; k < 3; ++k) {
    J(0, k) = wMc[0][k];
    J(1, k) = wMc[2][k];
    J(2, 3 + k) = wMc[1][k];
  }
  Eigen::Matrix<double, 6, 6> S;
  for (unsigned int i = 0; i < 6; ++i) {
    for (unsigned int k = 0; k < 6; ++k) {
      S(i, k) = location.covariance[i][k];
    }
  }
  const Eigen::Matrix3d R = J * S * J.transpose();
  const Eigen::Matrix3d K = m_covariance * (m_covariance + R).inverse();
  const Eigen::Vector3d innovation(wMc[0][3] - m_pose.x, wMc[2][3] - m_pose.z, wrapped(measured - m_pose.direction));
  const Eigen::Vector3d step = K * innovation;
  m_pose = FloorPose{m_pose.x + step[0], m_pose.z + step[1], wrapped(m_pose.direction + step[2])};
  // Joseph's form keeps it symmetric and positive.
  const Eigen::Matrix3d A = Eigen::Matrix3d::Identity() - K;
  m_covariance = A * m_covariance * A.transpose() + K * R * K.transpose();
}

double Belief::sigmasFrom(const FloorPose &truth) const
{
  const Eigen::Vector3d error(truth.x - m_pose.x, truth.z - m_pose.z, wrapped(truth.direction - m_pose.direction));
  return std::sqrt(error.dot(m_covariance.inverse() * error) / 3.);
}
} // namespace navigation
