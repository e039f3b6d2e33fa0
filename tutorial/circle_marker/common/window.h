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
 * A window on an image: shown if there is a display.
 */

#ifndef VP_TUTORIAL_WINDOW_H
#define VP_TUTORIAL_WINDOW_H

#include <memory>
#include <optional>
#include <string>

#include <visp3/core/vpConfig.h>
#include <visp3/core/vpDisplay.h>
#include <visp3/core/vpException.h>
#include <visp3/core/vpImage.h>
#include <visp3/core/vpMouseButton.h>
#include <visp3/core/vpRGBa.h>
#if (VISP_VERSION_INT >= VP_VERSION_INT(3, 7, 0))
#include <visp3/gui/vpDisplayFactory.h>
#elif defined(VISP_HAVE_X11)
#include <visp3/gui/vpDisplayX.h>
#elif defined(VISP_HAVE_OPENCV)
#include <visp3/gui/vpDisplayOpenCV.h>
#endif

#include "visp_names.h"

namespace tutorial {
/*! A display of whatever kind this ViSP has; empty if it has none. */
inline std::shared_ptr<vpDisplay> makeDisplay()
{
#if (VISP_VERSION_INT >= VP_VERSION_INT(3, 7, 0))
  return vpDisplayFactory::createDisplay();
#elif defined(VISP_HAVE_X11)
  return std::make_shared<vpDisplayX>();
#elif defined(VISP_HAVE_OPENCV)
  return std::make_shared<vpDisplayOpenCV>();
#else
  return nullptr;
#endif
}

/*!
  A window that shows pictures of any size one after the other.
*/
class Window
{
public:
  Window(const std::string &title, int x, int y) : m_title(title), m_x(x), m_y(y) {}

  /*!
    Shows a picture. A click's meaning is the caller's.
    \param picture : What to show.
    \param hint : A line of text on top.
    \exception vpException : If no window can be opened.
  */
  void show(const vpImage<vpRGBa> &picture, const std::string &hint)
  {
    const bool sameSize = picture.getWidth() == m_shown.getWidth() && picture.getHeight() == m_shown.getHeight();
    m_shown = picture;
    if (!m_display || !sameSize) {
      open();
    }
    vpDisplay::display(m_shown);
    vpDisplay::displayText(m_shown, 20, 20, hint, vpColor::red);
    vpDisplay::flush(m_shown);
  }

  /*!
    \param wait : Whether to wait for a click.
    \return The button that was clicked in the window, if one was.
  */
  std::optional<vpMouseButton::vpMouseButtonType> click(bool wait)
  {
    vpMouseButton::vpMouseButtonType button = vpMouseButton::none;
    return vpDisplay::getClick(m_shown, button, wait) ? std::optional<vpMouseButton::vpMouseButtonType>(button)
                                                      : std::nullopt;
  }

  /*!
    \return The character of a key that was pressed in the window, if one was; "\x1b" for Escape. vpDisplayX returns any
    character for keys that have none, such as Shift.
  */
  std::optional<char> key()
  {
    std::string text;
    return vpDisplay::getKeyboardEvent(m_shown, text, false) && !text.empty() ? std::optional<char>(text[0])
                                                                              : std::nullopt;
  }

private:
  void open()
  {
    if (m_display) {
      vpDisplay::close(m_shown);
    }
    m_display = makeDisplay();
    if (!m_display) {
      throw vpException(vpException::notImplementedError, "this ViSP was built without a display");
    }
    m_display->setDownScalingFactor(vpDisplay::SCALE_AUTO);
    m_display->init(m_shown, m_x, m_y, m_title);
  }

  std::string m_title;                  //!< Title of the window.
  int m_x;                              //!< Where it opens, pixels of the screen.
  int m_y;                              //!< Where it opens, pixels of the screen.
  vpImage<vpRGBa> m_shown;              //!< What it shows; must live as long as the display.
  std::shared_ptr<vpDisplay> m_display; //!< The display, once there was something to show.
};
} // namespace tutorial

#endif
