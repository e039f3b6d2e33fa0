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

#ifndef VP_TUTORIAL_LIVE_VIEW_H
#define VP_TUTORIAL_LIVE_VIEW_H

#include <memory>

#include <visp3/core/vpImage.h>

#include "../visp_names.h"
#include "../window.h"
#include "servo_loop.h"

namespace tutorial {
/*!
  A window with what the camera sees, and one with the curves of errors and velocities. A left click in the first
  starts or stops the camera, a right click quits.
*/
class LiveView
{
public:
  /*!
    \exception vpException : If no window can be opened.
  */
  explicit LiveView(const ServoGoal &goal);
  ~LiveView();

  /*!
    Shows an image, and whether the camera moves.
    \return What the user wants.
  */
  ServoWish show(const vpImage<unsigned char> &I, const ServoStep &step);

  /*! Shows the verdict and waits for a click. */
  void showEnd(const ServoRecord &record);

private:
  class Curves;

  ServoGoal m_goal;                 //!< What is shown.
  Window m_window;                  //!< What the camera sees.
  std::unique_ptr<Curves> m_curves; //!< Errors and velocities.
  bool m_isRunning = false;         //!< Whether the camera moves.
};
} // namespace tutorial

#endif
