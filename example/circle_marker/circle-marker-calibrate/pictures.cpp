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
 * The pictures, and what is seen in them.
 */

#include "pictures.h"

#include <filesystem>

#include <visp3/io/vpImageIo.h>

#include "circle_marker/common/detection/image_source.h"
#include "circle_marker/common/numbered_name.h"
#include "circle_marker/common/whole_file.h"
#include "common/progress.h"
#include "common/seeds.h"

#include "simulate.h"

namespace calibrate {
namespace {
std::vector<Picture> readPictures(const PictureOrder &order, const Complain &complain)
{
  std::vector<Picture> pictures;
  const auto source = tutorial::openSource(order.input, order.first, order.last);
  while (auto image = source->next()) {
    if (image->image) {
      pictures.push_back(Picture{image->name, *image->image});
    }
    else {
      complain("\"" + image->name + "\" is left out: " + image->problem);
    }
  }
  return pictures;
}

std::vector<Picture> simulatePictures(const Order &order)
{
  const SimulationOrder &s = order.simulation;
  const Lens lens = lensOf(s.camera);
  std::vector<Picture> pictures;
  common::ProgressLine line("pictures");
  for (unsigned int i = 0; i < order.pictures.simulated; ++i) {
    const std::uint64_t seed = common::mixed(s.seed, i);
    const TargetPose pose =
        randomPose(order.target, lens, s.width, s.height, HoldRange{s.leastTilt, s.mostTilt}, common::mixed(seed, 0));
    pictures.push_back(Picture{"simulated " + std::to_string(i),
                               renderTarget(order.target, s.camera, s.width, s.height, pose, common::mixed(seed, 1))});
    line.show(i + 1, order.pictures.simulated);
  }
  return pictures;
}

void save(const std::string &pattern, std::vector<Picture> &pictures)
{
  const auto name = tutorial::NumberedName::parse(pattern);
  tutorial::makeFolder(std::filesystem::path(pattern).parent_path(), "--save-views");
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    pictures[i].name = (*name)(static_cast<long>(i));
    tutorial::writeWhole(pictures[i].name,
                         [&](const std::string &temporary) { vpImageIo::write(pictures[i].image, temporary); });
  }
}
} // namespace

std::vector<Picture> gatherPictures(const Order &order, const Complain &complain)
{
  std::vector<Picture> pictures;
  if (order.pictures.simulated > 0) {
    pictures = simulatePictures(order);
  }
  else if (order.pictures.camera) {
    pictures = takePictures(order, complain);
  }
  else {
    pictures = readPictures(order.pictures, complain);
  }
  if (!order.savedViews.empty()) {
    save(order.savedViews, pictures);
  }
  return pictures;
}
} // namespace calibrate
