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

#include "feed_eyes.h"

#include <utility>

namespace tutorial {
namespace {
// At the limits of a robot, 0.2 m/s, the camera has then moved by 4 cm since its last image came; cameras from 7.5
// images a second on are never that late. What is done with an image counts: the robot goes on meanwhile.
constexpr double longestBlindTime = 0.2; // seconds
constexpr std::chrono::milliseconds patience(20);
} // namespace

FeedEyes::FeedEyes(FrameFeed &feed, const std::string &name, double timeout, const std::function<bool()> &isInterrupted,
                   const std::function<void(const std::string &)> &onDamage)
    : m_feed(feed), m_name(name), m_timeout(timeout), m_isInterrupted(isInterrupted), m_onDamage(onDamage)
{
}

std::optional<ServoView> FeedEyes::look(const std::function<void()> &stop)
{
  using Seconds = std::chrono::duration<double>;
  const Clock::time_point begin = Clock::now();
  bool isStopped = false;
  while (!m_isInterrupted()) {
    FrameFeed::Delivery delivery = m_feed.wait(patience);
    if (!delivery.damage.empty()) {
      m_onDamage(delivery.damage);
    }
    if (delivery.frame) {
      m_arrival = delivery.frame->arrival;
      ServoView view;
      view.image = std::move(delivery.frame->image);
      view.time = delivery.frame->time.value_or(unixSeconds()) - m_start;
      return view;
    }
    if (delivery.isEnd) {
      return std::nullopt;
    }
    const Clock::time_point now = Clock::now();
    const double waited = Seconds(now - begin).count();
    if (!isStopped && Seconds(now - m_arrival).count() > longestBlindTime) {
      stop();
      isStopped = true;
    }
    if (waited > m_timeout) {
      throw SourceError(silenceMessage(m_name, m_timeout));
    }
  }
  return std::nullopt;
}
} // namespace tutorial
