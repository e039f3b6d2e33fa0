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

#ifndef VP_TUTORIAL_FRAME_FEED_H
#define VP_TUTORIAL_FRAME_FEED_H

#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "frame_source.h"

namespace tutorial {
/*! What has become of the images so far. */
struct FrameCounts
{
  unsigned long delivered = 0;  //!< Handed to the program.
  unsigned long passedOver = 0; //!< Arrived while the program was busy, and were replaced by a newer one.
  unsigned long missed = 0;     //!< Taken by the camera, but never arrived here.
  unsigned long damaged = 0;    //!< Arrived, but could not be used.
};

/*!
  Reads a source in a thread of its own, so that a camera that stops answering never stops the program: ViSP's grabbers
  wait without end for the next image. A source that no longer answers is left alone when the feed is destroyed.
*/
class FrameFeed
{
public:
  /*! Which images the program gets. */
  enum class Use
  {
    Newest, //!< Always the newest one; those that it has no time for are passed over.
    All     //!< Every one, in order; the source waits for the program.
  };

  FrameFeed(std::unique_ptr<FrameSource> source, Use use);
  FrameFeed(const FrameFeed &) = delete;
  FrameFeed &operator=(const FrameFeed &) = delete;
  ~FrameFeed();

  /*! What there was within the time that was waited. */
  struct Delivery
  {
    std::optional<Frame> frame; //!< The image; nothing: none has come yet.
    bool isEnd = false;         //!< There are no more images.
    std::string damage;         //!< What was wrong with an image that has come in between.
  };

  /*!
    Waits for an image.
    \param longest : Longest time to wait.
    \exception SourceError : If the source has failed.
  */
  Delivery wait(std::chrono::milliseconds longest);

  /*! Seconds since the source gave anything, or since it was started. */
  double silence() const;

  FrameCounts counts() const;

private:
  struct State;
  std::shared_ptr<State> m_state; //!< Shared with the thread, which may outlive this.
};
/*! \return What to say when a source has given nothing for so many seconds. */
std::string silenceMessage(const std::string &name, double seconds);
} // namespace tutorial

#endif
