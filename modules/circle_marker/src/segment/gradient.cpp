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
 * Image gradient with a threshold that follows the image noise.
 */

#include "segment/gradient.h"

#include <array>
#include <cmath>
#include <cstdlib>

#include <opencv2/imgproc.hpp>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// A component of the Sobel gradient sums 12 units of squared weight: its noise is sqrt(12) that of a pixel.
constexpr double sobelNoiseGain = 3.464;
// At 6 and 4 standard deviations a million pixels of pure noise start no chain and seldom prolong one.
constexpr double startSigmas = 6.;
constexpr double continueSigmas = 4.;
// Least steps, in grey levels, worth following in a noise-free image; 4 is the Sobel gain of a sharp step.
constexpr double leastStartStep = 7.;
constexpr double leastContinueStep = 4.;
constexpr double sobelStepGain = 4.;
// Every 8th pixel of every 8th row: 19 thousand samples of a 1280 x 960 image fix the noise to 1 %.
constexpr int noiseSampling = 8;
} // namespace

double estimateNoise(const cv::Mat &image)
{
  constexpr int largest = 16 * 255; // of the absolute response: the weights' absolute values sum to 16
  std::array<int, largest + 1> histogram{};
  int samples = 0;
  for (int y = 1; y < image.rows - 1; y += noiseSampling) {
    const unsigned char *above = image.ptr<unsigned char>(y - 1);
    const unsigned char *here = image.ptr<unsigned char>(y);
    const unsigned char *below = image.ptr<unsigned char>(y + 1);
    for (int x = 1; x < image.cols - 1; x += noiseSampling) {
      const int response = above[x - 1] - 2 * above[x] + above[x + 1] - 2 * here[x - 1] + 4 * here[x] -
                           2 * here[x + 1] + below[x - 1] - 2 * below[x] + below[x + 1];
      ++histogram[static_cast<std::size_t>(std::abs(response))];
      ++samples;
    }
  }
  int below = 0;
  int median = 0;
  while (median < largest && 2 * (below + histogram[static_cast<std::size_t>(median)]) < samples) {
    below += histogram[static_cast<std::size_t>(median)];
    ++median;
  }
  // Responses are whole numbers: the median is placed inside its own, half a unit to either side (0: to one side), or
  // a noise of one grey level, whose median response is 4, would be known to 12 % only.
  const int here = histogram[static_cast<std::size_t>(median)];
  const double share = here > 0 ? (0.5 * samples - below) / here : 0.;
  const double placed = median > 0 ? median - 0.5 + share : 0.5 * share;
  // The response of unit noise has standard deviation 6; the median of |x| of a normal x is 0.6745 sigma.
  return placed / (6. * 0.6745);
}

void computeGradient(const vpImage<unsigned char> &I, Gradient &gradient)
{
  const cv::Mat image(static_cast<int>(I.getHeight()), static_cast<int>(I.getWidth()), CV_8U,
                      const_cast<unsigned char *>(I.bitmap));
  cv::spatialGradient(image, gradient.dx, gradient.dy);
  gradient.noise = estimateNoise(image);
  const double sigma = sobelNoiseGain * gradient.noise;
  gradient.startAt = static_cast<int>(std::lround(std::max(startSigmas * sigma, sobelStepGain * leastStartStep)));
  gradient.continueAbove =
      static_cast<int>(std::lround(std::max(continueSigmas * sigma, sobelStepGain * leastContinueStep)));
}
} // namespace circle_marker
END_VISP_NAMESPACE
