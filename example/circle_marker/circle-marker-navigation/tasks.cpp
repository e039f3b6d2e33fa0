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

#include "tasks.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <nlohmann/json.hpp>

namespace navigation {
namespace {
constexpr double greatestSpeed = 0.6;              // m/s, a walking pace
constexpr double greatestTurn = M_PI / 3.;         // rad/s
constexpr double placeTolerance = 0.01;            // metres
constexpr double directionTolerance = M_PI / 360.; // radians: half a degree
constexpr double beside = 20. * M_PI / 180.;       // Off by more, it turns where it stands.

/*! As much of an error as one step can make good, within a limit. */
double limited(double error, double time, double limit)
{
  return std::min(limit, std::max(-limit, 0.8 * error / time));
}
} // namespace

Task taskOf(const std::string &payload)
{
  try {
    const nlohmann::json json = nlohmann::json::parse(payload);
    const std::string kind = json.at("task").get<std::string>();
    if (kind == "stop") {
      return Task{true, FloorPose{}};
    }
    if (kind != "go") {
      throw std::runtime_error("the task \"" + kind + "\" is not known");
    }
    const double direction = json.at("look_deg").get<double>() * M_PI / 180.;
    return Task{false, FloorPose{json.at("to").at(0).get<double>(), json.at("to").at(1).get<double>(), direction}};
  }
  catch (const std::exception &e) {
    throw std::runtime_error("the payload " + payload + " is no task (" + e.what() +
                             R"(); it must be {"task": "go", "to": [x, z], "look_deg": d} or {"task": "stop"})");
  }
}

std::optional<Command> Driver::next(const FloorPose &believed, double time)
{
  const double dx = m_goal.x - believed.x, dz = m_goal.z - believed.z;
  const double left = std::hypot(dx, dz);
  // Once there, the last millimetres are not worth turning round for.
  m_hasArrived = m_hasArrived || left < placeTolerance;
  if (!m_hasArrived) {
    const double off = wrapped(std::atan2(dx, dz) - believed.direction);
    Command command;
    command.turn = limited(off, time, greatestTurn);
    // Nearly past it the goal is beside or behind: it then backs up or goes on, as it stands.
    if (std::abs(off) < beside) {
      command.speed = std::min(greatestSpeed, limited(left * std::cos(off), time, greatestSpeed));
    }
    return command;
  }
  const double off = wrapped(m_goal.direction - believed.direction);
  if (std::abs(off) < directionTolerance) {
    return std::nullopt;
  }
  return Command{0., limited(off, time, greatestTurn)};
}
} // namespace navigation
