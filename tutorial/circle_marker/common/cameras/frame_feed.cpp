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
 * Images that a camera gives at its own pace, for a program that works at another.
 */

#include "frame_feed.h"

#include <condition_variable>
#include <mutex>
#include <sstream>
#include <thread>
#include <utility>

namespace tutorial {
namespace {
using Clock = std::chrono::steady_clock;
}

/*! What the program and the thread share. */
struct FrameFeed::State
{
  std::unique_ptr<FrameSource> source; //!< Used by the thread alone.
  Use use = Use::Newest;

  std::mutex mutex; //!< Guards all below.
  std::condition_variable changed;
  std::optional<Frame> frame; //!< The next image for the program.
  std::string damage;         //!< The damage that the program has not heard of.
  std::string failure;        //!< Why the source has failed.
  bool hasFailed = false;     //!< Whether it has.
  bool isEnd = false;         //!< Whether the thread has ended.
  bool isStopped = false;     //!< Whether the program wants no more.
  FrameCounts counts;
  Clock::time_point lastSign = Clock::now(); //!< When the source last gave anything.

  void run();
  bool put(Frame &&next);
};

/*! \return Whether to go on. */
bool FrameFeed::State::put(Frame &&next)
{
  std::unique_lock<std::mutex> lock(mutex);
  lastSign = Clock::now();
  counts.missed += next.missed;
  if (use == Use::All) {
    changed.wait(lock, [this] { return !frame || isStopped; });
    lastSign = Clock::now();
  }
  counts.passedOver += frame ? 1 : 0;
  frame = std::move(next);
  changed.notify_all();
  return !isStopped;
}

void FrameFeed::State::run()
{
  try {
    bool goOn = true;
    while (goOn) {
      try {
        std::optional<Frame> next = source->next();
        goOn = next && put(std::move(*next));
      }
      catch (const DamagedFrame &e) {
        const std::lock_guard<std::mutex> lock(mutex);
        lastSign = Clock::now();
        ++counts.damaged;
        damage += (damage.empty() ? "" : "; ") + std::string(e.what());
        goOn = !isStopped;
        changed.notify_all();
      }
    }
  }
  catch (const std::exception &e) {
    const std::lock_guard<std::mutex> lock(mutex);
    hasFailed = true;
    failure = e.what();
  }
  // The source is closed here, by the thread that has used it, and before anyone hears of the end.
  source.reset();
  const std::lock_guard<std::mutex> lock(mutex);
  isEnd = true;
  changed.notify_all();
}

FrameFeed::FrameFeed(std::unique_ptr<FrameSource> source, Use use) : m_state(std::make_shared<State>())
{
  m_state->source = std::move(source);
  m_state->use = use;
  // Detached: a thread that waits for a dead camera cannot be joined.
  std::thread([state = m_state] { state->run(); }).detach();
}

FrameFeed::~FrameFeed()
{
  std::unique_lock<std::mutex> lock(m_state->mutex);
  m_state->isStopped = true;
  m_state->changed.notify_all();
  // Longer than the slowest camera takes for an image, 0.53 s, and than ViSP takes to close it.
  constexpr std::chrono::seconds patience(2);
  m_state->changed.wait_for(lock, patience, [this] { return m_state->isEnd; });
}

FrameFeed::Delivery FrameFeed::wait(std::chrono::milliseconds longest)
{
  std::unique_lock<std::mutex> lock(m_state->mutex);
  State &state = *m_state;
  state.changed.wait_for(lock, longest, [&state] { return state.frame || state.isEnd || !state.damage.empty(); });
  Delivery delivery;
  delivery.damage = std::exchange(state.damage, "");
  if (state.frame) {
    delivery.frame = std::exchange(state.frame, std::nullopt);
    ++state.counts.delivered;
    state.changed.notify_all();
    return delivery;
  }
  // Damage is told before the failure that it leads to.
  if (state.hasFailed && delivery.damage.empty()) {
    throw SourceError(state.failure);
  }
  delivery.isEnd = state.isEnd && !state.hasFailed;
  return delivery;
}

double FrameFeed::silence() const
{
  const std::lock_guard<std::mutex> lock(m_state->mutex);
  return m_state->frame ? 0. : std::chrono::duration<double>(Clock::now() - m_state->lastSign).count();
}

FrameCounts FrameFeed::counts() const
{
  const std::lock_guard<std::mutex> lock(m_state->mutex);
  return m_state->counts;
}
std::string silenceMessage(const std::string &name, double seconds)
{
  std::ostringstream message;
  message << "no image came from " << name << " for " << seconds
          << " s: check its cable and power, and whether other cameras fill the bus; choose a lower --framerate or a "
             "smaller mode, or a longer --timeout for long exposures";
  return message.str();
}
} // namespace tutorial
