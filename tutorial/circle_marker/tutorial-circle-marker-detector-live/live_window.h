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

#ifndef VP_TUTORIAL_LIVE_WINDOW_H
#define VP_TUTORIAL_LIVE_WINDOW_H

#include <string>
#include <vector>

#include "../common/detection/marker_overlay.h"
#include "../common/window.h"

namespace tutorial {
/*! What the user has chosen with keys and mouse. */
struct LiveChoices
{
  bool quit = false;      //!< To end.
  bool hold = false;      //!< To look at one image.
  bool record = false;    //!< To record.
  bool showKeys = false;  //!< To see what the keys do.
  OverlayDetails details; //!< To see more of each marker.
};

/*!
  Shows what was found, and reads keys and mouse.
*/
class LiveWindow
{
public:
  /*! \param canRecord : Whether a place to record to was named. */
  explicit LiveWindow(bool canRecord) : m_canRecord(canRecord), m_window("Circular markers, live", 10, 10) {}

  /*!
    Shows a picture.
    \param picture : What was found.
    \param status : Lines of text at the bottom.
    \exception vpException : If no window can be opened.
  */
  void show(vpImage<vpRGBa> picture, const std::vector<std::string> &status);

  /*! Reads what was pressed and clicked since. \return Whether anything has changed. */
  bool readInput();

  const LiveChoices &choices() const { return m_choices; }

private:
  std::string hint() const;
  void onKey(char key);
  void onClick(vpMouseButton::vpMouseButtonType button);

  bool m_canRecord;      //!< Whether there is a place to record to.
  bool m_isOpen = false; //!< Whether there is a window yet.
  Window m_window;       //!< The window.
  LiveChoices m_choices; //!< What the user has chosen.
};
} // namespace tutorial

#endif
