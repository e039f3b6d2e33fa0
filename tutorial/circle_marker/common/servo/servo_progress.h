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
 * A line that says how far a servo has come.
 */

#ifndef VP_TUTORIAL_SERVO_PROGRESS_H
#define VP_TUTORIAL_SERVO_PROGRESS_H

#include <deque>
#include <optional>
#include <string>

#include "../status_line.h"
#include "../visp_names.h"
#include "servo_loop.h"

namespace tutorial {
/*!
  A line of the standard error that says how far a servo is. The time left is that after which the error is as small as
  is asked for, if it goes on to decrease as in the last images.
*/
class ServoProgress
{
public:
  explicit ServoProgress(const ServoGoal &goal);

  /*! To be called with each image. */
  void show(const ServoStep &step);

  /*! \return The line. */
  std::string line(const ServoStep &step) const;

private:
  /*! How far off the camera was at a time, in accepted errors. */
  struct Sample
  {
    double time;
    double off;
  };

  std::optional<double> secondsLeft() const;

  double m_acceptedDistance;   //!< Metres.
  double m_acceptedAngle;      //!< Radians.
  StatusLine m_line;           //!< Where it is written.
  std::deque<Sample> m_recent; //!< The last images with a pose.
};
} // namespace tutorial

#endif
