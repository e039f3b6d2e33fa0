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
 * Pictures of the target from a live camera.
 */

#include "pictures.h"

#include <chrono>
#include <iostream>
#include <optional>

#include <visp3/core/vpImageConvert.h>

#include "circle_marker/common/cameras/frame_feed.h"
#include "circle_marker/common/draw.h"
#include "circle_marker/common/interruption.h"
#include "circle_marker/common/window.h"

#include "find.h"

namespace calibrate {
namespace {
/*! Mean distance of the points that two views share, pixels; nothing without any. */
std::optional<double> distanceOf(const View &a, const View &b)
{
  double sum = 0.;
  std::size_t count = 0;
  for (const Observation &o : a.observations) {
    for (const Observation &p : b.observations) {
      if (o.point == p.point) {
        sum += (o.pixel - p.pixel).norm();
        ++count;
      }
    }
  }
  return count > 0 ? std::optional<double>(sum / static_cast<double>(count)) : std::nullopt;
}

/*! Decides which images become views. */
class Taking
{
public:
  /*! Whether an image is to be taken by itself: the target stands still and is far from where it was before. */
  bool isTime(const View &view)
  {
    constexpr double still = 1.;       // pixels from one image to the next: more blurs
    constexpr double farEnough = 0.06; // of the image's width: another view
    const auto moved = m_last ? distanceOf(view, *m_last) : std::nullopt;
    const bool isStill = moved && *moved < still;
    m_last = view;
    for (const View &other : m_taken) {
      const auto distance = distanceOf(view, other);
      if (distance && *distance < farEnough * view.width) {
        return false;
      }
    }
    return isStill;
  }
  void take(const View &view) { m_taken.push_back(view); }

private:
  std::optional<View> m_last; //!< Of the image before.
  std::vector<View> m_taken;  //!< What there is.
};

/*! What the user wants in the window. */
struct Wish
{
  bool take = false; //!< The next image with the target, as it is.
  bool end = false;  //!< No more views.
};

void readWish(tutorial::Window &window, Wish &wish)
{
  while (const auto key = window.key()) {
    wish.take = wish.take || *key == ' ';
    wish.end = wish.end || *key == 'q' || *key == '\x1b';
  }
  while (const auto button = window.click(false)) {
    wish.take = wish.take || *button == vpMouseButton::button1;
    wish.end = wish.end || *button == vpMouseButton::button3;
  }
}

void showImage(tutorial::Window &window, const vpImage<unsigned char> &I, const Search &search, std::size_t taken,
               unsigned int wanted)
{
  vpImage<vpRGBa> picture;
  vpImageConvert::convert(I, picture);
  for (const Observation &o : search.view ? search.view->observations : std::vector<Observation>()) {
    tutorial::drawMark(picture, vpImagePoint(o.pixel.y(), o.pixel.x()), vpColor::green);
  }
  const std::string count = std::to_string(taken) + " of " + std::to_string(wanted) + " views. ";
  window.show(picture, count + (search.view ? "Hold still, or space: take. " : "The target is not seen whole. ") +
                           "Right click: end.");
}
} // namespace

std::vector<Picture> takePictures(const Order &order, const Complain &complain)
{
  const PictureOrder &wanted = order.pictures;
  tutorial::watchInterruption();
  std::unique_ptr<tutorial::FrameSource> source = tutorial::openFrameSource(*wanted.camera);
  const auto use = source->isLive() ? tutorial::FrameFeed::Use::Newest : tutorial::FrameFeed::Use::All;
  tutorial::FrameFeed feed(std::move(source), use);
  std::optional<tutorial::Window> window;
  if (wanted.display) {
    window.emplace("Camera calibration", 100, 100);
  }
  Finder finder(order.target);
  Taking taking;
  std::vector<Picture> pictures;
  Wish wish;
  bool isShown = false;
  while (pictures.size() < wanted.wanted && !wish.end && !tutorial::isInterrupted()) {
    const auto delivery = feed.wait(std::chrono::milliseconds(30)); // keys and clicks are seen at once
    if (!delivery.damage.empty()) {
      complain(delivery.damage);
    }
    if (delivery.isEnd) {
      break;
    }
    if (!delivery.frame) {
      if (feed.silence() > wanted.timeout) {
        throw tutorial::SourceError(tutorial::silenceMessage(wanted.camera->name, wanted.timeout));
      }
      if (window && isShown) {
        readWish(*window, wish);
      }
      continue;
    }
    const Search search = finder.find(delivery.frame->image, delivery.frame->name, std::nullopt);
    if (window) {
      try {
        showImage(*window, delivery.frame->image, search, pictures.size(), wanted.wanted);
        isShown = true;
        readWish(*window, wish);
      }
      catch (const vpException &e) {
        complain(std::string("no window can be opened (") + e.what() + "); going on without, as with --display-off");
        window.reset();
      }
    }
    if (search.view && (taking.isTime(*search.view) || wish.take)) {
      taking.take(*search.view);
      pictures.push_back(Picture{delivery.frame->name, delivery.frame->image});
      std::cerr << pictures.size() << " of " << wanted.wanted << " views" << std::endl;
    }
    wish.take = false;
  }
  return pictures;
}
} // namespace calibrate
