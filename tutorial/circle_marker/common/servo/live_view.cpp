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
 * The servo in a window, with curves.
 */

#include "live_view.h"

#include <string>

#include "servo_report.h"

namespace tutorial {
namespace {
constexpr unsigned int distanceGraph = 0, angleGraph = 1, velocityGraph = 2;

std::unique_ptr<vpPlot> makeCurves()
{
  auto curves = std::make_unique<vpPlot>(3, 700, 500, 700, 10, "Servo");
  curves->initGraph(distanceGraph, 2);
  curves->setTitle(distanceGraph, "Distance to go [mm]");
  curves->initGraph(angleGraph, 2);
  curves->setTitle(angleGraph, "Angle to go [deg]");
  for (const unsigned int graph : {distanceGraph, angleGraph}) {
    curves->setLegend(graph, 0, "measured");
    curves->setLegend(graph, 1, "true");
  }
  curves->initGraph(velocityGraph, 6);
  curves->setTitle(velocityGraph, "Velocity [m/s, rad/s]");
  const std::string names[] = {"vx", "vy", "vz", "wx", "wy", "wz"};
  for (unsigned int axis = 0; axis < 6; ++axis) {
    curves->setLegend(velocityGraph, axis, names[axis]);
  }
  return curves;
}
} // namespace

LiveView::LiveView(const ServoGoal &goal)
    : m_goal(goal), m_window("Servo on circular markers", 10, 10), m_curves(makeCurves())
{
}

ServoWish LiveView::show(const vpImage<unsigned char> &I, const ServoStep &step)
{
  m_window.show(servoPicture(I, step, m_goal),
                m_isRunning ? "Left click: stop. Right click: quit." : "Left click: start. Right click: quit.");
  if (const auto click = m_window.click(false)) {
    if (*click == vpMouseButton::button3) {
      return ServoWish::Quit;
    }
    m_isRunning = *click == vpMouseButton::button1 ? !m_isRunning : m_isRunning;
  }
  if (m_isRunning) {
    plot(step);
  }
  return m_isRunning ? ServoWish::Go : ServoWish::Hold;
}

void LiveView::plot(const ServoStep &step)
{
  if (step.measured) {
    m_curves->plot(distanceGraph, 0, step.iteration, 1e3 * step.measured->distance());
    m_curves->plot(angleGraph, 0, step.iteration, step.measured->angle() * 180. / M_PI);
  }
  if (step.trueError) {
    m_curves->plot(distanceGraph, 1, step.iteration, 1e3 * step.trueError->distance());
    m_curves->plot(angleGraph, 1, step.iteration, step.trueError->angle() * 180. / M_PI);
  }
  m_curves->plot(velocityGraph, step.iteration, step.velocity);
}

void LiveView::showEnd(const ServoRecord &record)
{
  if (record.snapshots.empty()) {
    return;
  }
  const Snapshot &last = record.snapshots.back();
  m_window.show(servoPicture(last.image, last.step, m_goal),
                std::string(record.converged ? "Converged." : "Not converged.") + " Click: quit.");
  m_window.click(true);
}
} // namespace tutorial
