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

#include <optional>
#include <string>

#include <visp3/core/vpConfig.h>
#if defined(VISP_HAVE_DISPLAY)
#include <visp3/gui/vpPlot.h>
#endif

#include "servo_report.h"

namespace tutorial {
#if defined(VISP_HAVE_DISPLAY)
namespace {
constexpr unsigned int distanceGraph = 0, angleGraph = 1, velocityGraph = 2;
}

/*! The window with the curves. */
class LiveView::Curves
{
public:
  Curves() : m_plot(3, 700, 500, 700, 10, "Servo")
  {
    m_plot.initGraph(distanceGraph, 2);
    m_plot.setTitle(distanceGraph, "Distance to go [mm]");
    m_plot.initGraph(angleGraph, 2);
    m_plot.setTitle(angleGraph, "Angle to go [deg]");
    for (const unsigned int graph : {distanceGraph, angleGraph}) {
      m_plot.setLegend(graph, 0, "measured");
      m_plot.setLegend(graph, 1, "true");
    }
    m_plot.initGraph(velocityGraph, 6);
    m_plot.setTitle(velocityGraph, "Velocity [m/s, rad/s]");
    const std::string names[] = {"vx", "vy", "vz", "wx", "wy", "wz"};
    for (unsigned int axis = 0; axis < 6; ++axis) {
      m_plot.setLegend(velocityGraph, axis, names[axis]);
    }
  }

  void add(const ServoStep &step)
  {
    const std::optional<ServoError> errors[] = {step.measured, step.trueError};
    for (unsigned int curve = 0; curve < 2; ++curve) {
      if (const auto &error = errors[curve]) {
        m_plot.plot(distanceGraph, curve, step.iteration, 1e3 * error->distance());
        m_plot.plot(angleGraph, curve, step.iteration, error->angle() * 180. / M_PI);
      }
    }
    m_plot.plot(velocityGraph, step.iteration, step.velocity);
  }

private:
  vpPlot m_plot; //!< Errors and velocities.
};
#else
/*! Without a display there is nothing to draw curves in. */
class LiveView::Curves
{
public:
  Curves() { throw vpException(vpException::notImplementedError, "this ViSP was built without a display"); }
  void add(const ServoStep &) {}
};
#endif

LiveView::LiveView(const ServoGoal &goal)
    : m_goal(goal), m_window("Servo on circular markers", 10, 10), m_curves(std::make_unique<Curves>())
{
}

LiveView::~LiveView() = default;

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
    m_curves->add(step);
  }
  return m_isRunning ? ServoWish::Go : ServoWish::Hold;
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
