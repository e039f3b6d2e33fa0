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
 * Tests of when a servo that waits for an image stops its robot.
 */

#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <memory>
#include <thread>
#include <utility>

#include "circle_marker/common/servo/feed_eyes.h"

using namespace tutorial;

namespace {
constexpr double timeout = 60.; // seconds

//! A camera with one image at once and one when it is told.
class TwoImages : public FrameSource
{
public:
  explicit TwoImages(std::future<void> second) : m_second(std::move(second)) {}

  std::optional<Frame> next() override
  {
    if (m_images == 2) {
      return std::nullopt;
    }
    if (++m_images == 2) {
      m_second.wait();
    }
    Frame frame;
    frame.image.resize(16, 16);
    return frame;
  }

  bool isLive() const override { return true; }

private:
  std::future<void> m_second;
  int m_images = 0;
};
} // namespace

TEST(FeedEyes, StopsTheRobotOnceWithoutAnImage)
{
  std::promise<void> second;
  FrameFeed feed(std::make_unique<TwoImages>(second.get_future()), FrameFeed::Use::Newest);
  FeedEyes eyes(
      feed, "camera", timeout, [] { return false; }, [](const std::string &) {});
  int stops = 0;
  EXPECT_TRUE(eyes.look([] {})); // who starts late may have to wait for the first one
  EXPECT_TRUE(eyes.look([&] {
    ++stops;
    second.set_value(); // would throw if it came twice
  }));
  EXPECT_EQ(stops, 1);
  EXPECT_FALSE(eyes.look([] {}));
}

// The robot goes on while an image is worked on: after half a second of that it is stopped at once, though the next
// image comes soon after.
TEST(FeedEyes, TheTimeThatAnImageTakesCounts)
{
  std::promise<void> second;
  FrameFeed feed(std::make_unique<TwoImages>(second.get_future()), FrameFeed::Use::Newest);
  bool isSecond = false;
  int asked = 0; // once before each wait of 20 ms
  const auto isInterrupted = [&] {
    if (isSecond && ++asked == 3) {
      second.set_value();
    }
    return false;
  };
  FeedEyes eyes(feed, "camera", timeout, isInterrupted, [](const std::string &) {});
  EXPECT_TRUE(eyes.look([] {}));
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  isSecond = true;
  int stops = 0;
  EXPECT_TRUE(eyes.look([&stops] { ++stops; }));
  EXPECT_EQ(stops, 1);
}
