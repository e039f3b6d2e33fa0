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

#ifndef VP_SIMULATOR_SIMULATOR_WINDOW_H
#define VP_SIMULATOR_SIMULATOR_WINDOW_H

#include <memory>
#include <optional>

#include <visp3/core/vpDisplay.h>
#include <visp3/core/vpImage.h>
#include <visp3/core/vpRGBa.h>

#include "controls.h"

namespace simulator {
/*!
  Shows pictures of one size, and reads keys and mouse: a button that is held down and moved is a drag.
*/
class SimulatorWindow
{
public:
  /*! \exception vpException : If no window can be opened. */
  void show(const vpImage<vpRGBa> &picture);

  /*! Lets what has happened act on the controls. \return Whether anything has. */
  bool readInput(Controls &controls, double focal);

  /*! Lets a moment go by in which nothing happens. */
  void pause() const;

private:
  struct Drag
  {
    int button = 1;
    vpImagePoint last; //!< Where the pointer was.
  };

  bool followPointer(Controls &controls, double focal);

  vpImage<vpRGBa> m_shown;              //!< What it shows; must live as long as the display.
  std::shared_ptr<vpDisplay> m_display; //!< The display, once there was something to show.
  std::optional<Drag> m_drag;           //!< A button that is held.
};
} // namespace simulator

#endif
