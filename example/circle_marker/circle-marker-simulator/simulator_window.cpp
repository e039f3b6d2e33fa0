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
 * The simulator's window.
 */

#include "simulator_window.h"

#include <visp3/core/vpTime.h>

#include "circle_marker/common/window.h"

namespace simulator {
void SimulatorWindow::show(const vpImage<vpRGBa> &picture)
{
  m_shown = picture;
  if (!m_display) {
    m_display = tutorial::makeDisplay();
    if (!m_display) {
      throw vpException(vpException::notImplementedError,
                        "this ViSP was built without a display; use --script with --display-off");
    }
    // Texts and small markers are to be read: only what fits no screen is made smaller.
    constexpr unsigned int widest = 1200; // pixels
    m_display->setDownScalingFactor(picture.getWidth() > widest ? vpDisplay::SCALE_AUTO : vpDisplay::SCALE_1);
    m_display->init(m_shown, 60, 60, "Circular markers, simulator");
  }
  vpDisplay::display(m_shown);
  vpDisplay::displayText(m_shown, 20, 20, "h: keys. Right click: quit.", vpColor::red);
  vpDisplay::flush(m_shown);
}

bool SimulatorWindow::followPointer(Controls &controls, double focal)
{
  vpImagePoint pointer;
  if (!m_drag || !vpDisplay::getPointerPosition(m_shown, pointer)) {
    return false;
  }
  const double du = pointer.get_u() - m_drag->last.get_u(), dv = pointer.get_v() - m_drag->last.get_v();
  m_drag->last = pointer;
  if (du == 0. && dv == 0.) {
    return false;
  }
  drag(controls, m_drag->button, du, dv, focal);
  return true;
}

bool SimulatorWindow::readInput(Controls &controls, double focal)
{
  bool hasChanged = false;
  std::string text;
  while (vpDisplay::getKeyboardEvent(m_shown, text, false)) {
    // vpDisplayX gives names of some keys and any character for keys that have none, such as Shift.
    hasChanged = (!text.empty() && pressKey(controls, text[0])) || hasChanged;
  }
  vpImagePoint place;
  vpMouseButton::vpMouseButtonType button = vpMouseButton::none;
  hasChanged = followPointer(controls, focal) || hasChanged;
  while (vpDisplay::getClick(m_shown, place, button, false)) {
    controls.isOver = controls.isOver || button == vpMouseButton::button3;
    m_drag = Drag{button == vpMouseButton::button1 ? 1 : 2, place};
    hasChanged = followPointer(controls, focal) || hasChanged;
  }
  while (vpDisplay::getClickUp(m_shown, place, button, false)) {
    // Where the button was let go counts, not where the pointer has gone since.
    if (m_drag) {
      drag(controls, m_drag->button, place.get_u() - m_drag->last.get_u(), place.get_v() - m_drag->last.get_v(), focal);
      hasChanged = true;
    }
    m_drag.reset();
  }
  return hasChanged;
}

void SimulatorWindow::pause() const
{
  constexpr double moment = 20.; // ms
  vpTime::wait(moment);
}
} // namespace simulator
