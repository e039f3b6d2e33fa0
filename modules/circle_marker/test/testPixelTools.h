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
 * The pixels of a whole image, as the models of the room refine have them.
 */

#ifndef VP_TEST_PIXEL_TOOLS_H
#define VP_TEST_PIXEL_TOOLS_H

#include <vector>

#include "refine/fit_pixel.h"
#include "support/camera_model.h"
#include "testRoomTools.h"

namespace room_test {
//! Every pixel of an image of a scene, with its value for a grey level.
inline std::vector<circle_marker::FitPixel> allPixels(const vpImage<double> &image, const MarkerScene &scene)
{
  const circle_marker::CameraModel camera(scene.camera());
  const circle_marker::ImageFrame frame = scene.frame();
  std::vector<circle_marker::FitPixel> pixels;
  for (unsigned int v = 0; v < image.getHeight(); ++v) {
    for (unsigned int u = 0; u < image.getWidth(); ++u) {
      const Eigen::Vector2d place(u, v);
      circle_marker::FitPixel pixel;
      pixel.meter = camera.toMeter(place).cast<float>();
      pixel.meterPerPixel = camera.meterPerPixel(place).cast<float>();
      pixel.offset = ((place - frame.center) / frame.size).cast<float>();
      pixel.grey = static_cast<float>(image[v][u]);
      pixels.push_back(pixel);
    }
  }
  return pixels;
}
} // namespace room_test

#endif
