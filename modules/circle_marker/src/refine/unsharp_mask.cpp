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
 * Sharpening of the camera, undone.
 */

#include "refine/unsharp_mask.h"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

#include "support/sensor_range.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// What is left of the mask after the last step of undoing it, share of its amount.
constexpr double leftOfMask = 0.05;
} // namespace

double lnGainOf(const UnsharpMask &mask)
{
  constexpr int steps = 12; // in each direction: to 0.001 of the sum
  double sum = 0.;
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j < steps; ++j) {
      const double squares = std::pow(M_PI * (i + 0.5) / steps, 2.) + std::pow(M_PI * (j + 0.5) / steps, 2.);
      sum += std::log1p(mask.amount * (1. - std::exp(-0.5 * mask.sigma * mask.sigma * squares)));
    }
  }
  return sum / (steps * steps);
}

bool undo(const UnsharpMask &mask, const vpImage<unsigned char> &I, const cv::Rect &box, const Deadline &deadline,
          vpImage<unsigned char> &restored)
{
  const auto viewOf = [&box](const vpImage<unsigned char> &image) {
    const cv::Mat whole(static_cast<int>(image.getHeight()), static_cast<int>(image.getWidth()), CV_8U, image.bitmap);
    return whole(box);
  };
  if (restored.getHeight() != I.getHeight() || restored.getWidth() != I.getWidth()) {
    restored.resize(I.getHeight(), I.getWidth(), 0); // beyond the box a fit sees what it saw before, or black
  }
  const cv::Mat before = viewOf(I);
  cv::Mat sharpened;
  before.convertTo(sharpened, CV_32F);
  const cv::Mat isTooBright = before >= brightestTold;
  const cv::Mat isTooDark = before <= darkestTold;
  // f = (sharpened + a G f) / (1 + a), again and again: each step leaves a / (1 + a) of what is off, and less. A halo
  // that was cut off lies on plain paper or ink; halfway between that and the least it can be is nearest to it.
  const double share = mask.amount / (1. + mask.amount);
  const int steps = static_cast<int>(std::ceil(std::log(leftOfMask) / std::log(share)));
  cv::Mat image = sharpened.clone();
  cv::Mat blurred;
  for (int step = 0; step < std::max(steps, 1); ++step) {
    if (deadline.hasPassed()) {
      return false;
    }
    cv::GaussianBlur(image, blurred, cv::Size(), mask.sigma);
    cv::addWeighted(sharpened, 1. - share, blurred, share, 0., image);
    cv::Mat half;
    image.convertTo(half, CV_32F, 0.5, 0.5 * std::min(mask.white, 255.));
    half.copyTo(image, isTooBright);
    image.convertTo(half, CV_32F, 0.5, 0.5 * std::max(mask.ink, 0.));
    half.copyTo(image, isTooDark);
  }
  cv::Mat result = viewOf(restored);
  image.convertTo(result, CV_8U);
  return true;
}
} // namespace circle_marker
END_VISP_NAMESPACE
