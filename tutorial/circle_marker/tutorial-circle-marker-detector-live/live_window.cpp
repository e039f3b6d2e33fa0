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
 * The window of tutorial-circle-marker-detector-live.
 */

#include "live_window.h"

#include "../common/draw.h"

namespace tutorial {
namespace {
constexpr char escape = '\x1b';
}

std::string LiveWindow::hint() const
{
  const std::string quit = "Right click: quit. h: keys.";
  if (m_choices.hold) {
    return "Held. Space: go on. " + quit;
  }
  if (!m_canRecord) {
    return "Click: quit. h: keys.";
  }
  return (m_choices.record ? "Recording. Left click: stop. " : "Left click: record. ") + quit;
}

void LiveWindow::show(vpImage<vpRGBa> picture, const std::vector<std::string> &status)
{
  const double lineHeight = picture.getWidth() > 1000 ? 28. : 20.; // pixels; see drawText
  double v = picture.getHeight() - 6. - lineHeight * static_cast<double>(status.size());
  for (const std::string &line : status) {
    drawText(picture, line, vpImagePoint(v, 10.));
    v += lineHeight;
  }
  if (m_choices.showKeys) {
    v = 60.;
    for (const char *line :
         {"q, Escape, right click: quit", "space: hold the image", "r, left click: record or stop (with --record)",
          "2: second pose, in orange", "u: uncertainty (standard deviations)", "h: hide these lines"}) {
      drawText(picture, line, vpImagePoint(v, 10.), vpColor::white);
      v += lineHeight;
    }
  }
  m_window.show(picture, hint());
  m_isOpen = true;
}

void LiveWindow::onKey(char key)
{
  switch (key) {
  case 'q':
  case 'Q':
  case escape:
    m_choices.quit = true;
    break;
  case ' ':
    m_choices.hold = !m_choices.hold;
    break;
  case 'r':
    m_choices.record = m_canRecord && !m_choices.record;
    break;
  case '2':
    m_choices.details.secondPose = !m_choices.details.secondPose;
    break;
  case 'u':
    m_choices.details.uncertainty = !m_choices.details.uncertainty;
    break;
  case 'h':
    m_choices.showKeys = !m_choices.showKeys;
    break;
  default:
    break;
  }
}

void LiveWindow::onClick(vpMouseButton::vpMouseButtonType button)
{
  if (button == vpMouseButton::button1 && m_canRecord) {
    m_choices.record = !m_choices.record;
  }
  else {
    m_choices.quit = true;
  }
}

bool LiveWindow::readInput()
{
  bool hasChanged = false;
  if (!m_isOpen) {
    return hasChanged;
  }
  while (const auto key = m_window.key()) {
    onKey(*key);
    hasChanged = true;
  }
  while (const auto button = m_window.click(false)) {
    onClick(*button);
    hasChanged = true;
  }
  return hasChanged;
}
} // namespace tutorial
