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
 * A real camera as the eyes of a servo.
 */

#ifndef VP_TUTORIAL_FEED_EYES_H
#define VP_TUTORIAL_FEED_EYES_H

#include <chrono>
#include <functional>
#include <string>

#include "../cameras/frame_feed.h"
#include "servo_eyes.h"

namespace tutorial {
/*!
  The newest image of a camera. Nothing is known of the truth.
*/
class FeedEyes : public ServoEyes
{
public:
  /*!
    \param feed : The camera; must live as long as this.
    \param name : The camera's name, for messages.
    \param timeout : Longest wait for an image, seconds.
    \param isInterrupted : Says whether to end.
    \param onDamage : Is told of damaged images.
  */
  FeedEyes(FrameFeed &feed, const std::string &name, double timeout, const std::function<bool()> &isInterrupted,
           const std::function<void(const std::string &)> &onDamage);

  std::optional<ServoView> look(const std::function<void()> &stop) override;

private:
  using Clock = std::chrono::steady_clock; // the system's time may be set

  FrameFeed &m_feed;                                   //!< The camera.
  std::string m_name;                                  //!< Its name.
  double m_timeout;                                    //!< Seconds.
  std::function<bool()> m_isInterrupted;               //!< Whether to end.
  std::function<void(const std::string &)> m_onDamage; //!< Is told of damaged images.
  double m_start = unixSeconds();                      //!< Unix time, seconds.
  Clock::time_point m_arrival = Clock::now();          //!< When the last image came.
};
} // namespace tutorial

#endif
