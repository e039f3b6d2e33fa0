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
 * The noise of an image.
 */

#include "segment/image_noise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "segment/flat_blocks.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Every 8th pixel of every 8th row: 19 thousand samples of a 1280 x 960 image fix the noise to 1 %.
constexpr unsigned int noiseSampling = 8;
// Noise that pixels share is more than what the Laplacians see by this factor: after demosaicing 1.6 to 4. In
// photographs of cubes with letters all over, whose noise is independent, it was 1.5.
constexpr double clearlyMore = 1.5;
// And more than this, grey levels: on slopes without noise rounding makes waves of 0.29, but at edges it is
// independent.
constexpr double leastShared = 0.45;
// Fine texture in more than half of an image, such as a checker of some pixels, is noise for the Laplacians: where the
// flattest blocks have clearly less...
constexpr double clearlyLess = 1. / clearlyMore;
// ...and the median block's variance is more than this times that of such noise. Independent noise that differs from
// place to place, with the light, has 1.
constexpr double mostOfNoise = 3.;
// Edges are noise for the Laplacians, and the flattest blocks have none. Where a fifth of the blocks has edges, since
// their variance is more than this times that of the flattest, those tell, down to this part of what the Laplacians
// say: in frames full of markers they said up to 1.12 times too much (bench-circle-marker's twelve of 640 x 480, noise
// of 0.5 to 10). Elsewhere the flattest may be the darkest: noise that grows with the light has ten times the variance
// at most.
constexpr double leastOfEdgeBlocks = 10.;
constexpr double leastOfLaplacians = 1. / 1.12;
// Pixels beside texture share their noise where it is by so many: of independent noise 25 flat blocks tell 1 +- 0.28,
// behind a colour sensor it is 2.4.
constexpr double clearlySharing = 2.;

// Linear interpolation between pixels, with a phase that changes over the image, makes neighbours this much more alike
// than pixels two apart: by 0.13 to 0.38 with noise of 1 to 10 grey levels; independent noise 0 +- 0.03, by the 25
// blocks or more that are asked.
constexpr double leastLikeness = 0.1;
// Its noise is this many times what the Laplacians see at most; 1.2 to 1.86 times if an undistorted picture is not
// enlarged as well. Behind smoothing and most colour sensors it is more, and not a matter of the place in the image.
constexpr double mostOfResampled = 1.86;

// Of noise that is independent from pixel to pixel.
double independentNoise(const vpImage<unsigned char> &I)
{
  constexpr int largest = 16 * 255; // of the absolute response: the weights' absolute values sum to 16
  std::array<int, largest + 1> histogram{};
  int samples = 0;
  for (unsigned int y = 1; y + 1 < I.getHeight(); y += noiseSampling) {
    const unsigned char *above = I[y - 1];
    const unsigned char *here = I[y];
    const unsigned char *below = I[y + 1];
    for (unsigned int x = 1; x + 1 < I.getWidth(); x += noiseSampling) {
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

// Of noise that is independent most of a block's variance is what the Laplacians say; of texture, little of it. Flat
// blocks with less than rounding makes of slopes are of drawings, and say nothing of what is beside them.
bool isTexture(double laplacians, double flat, double medianVariance)
{
  return flat >= leastShared && clearlyLess * laplacians > flat &&
         medianVariance > mostOfNoise * laplacians * laplacians;
}
} // namespace

ImageNoise estimateNoise(const vpImage<unsigned char> &I)
{
  const double laplacians = independentNoise(I);
  if (const auto blocks = findFlatBlocks(I)) {
    const double flat = std::sqrt(blocks->variance);
    const bool isResampled =
        flat >= leastShared && blocks->likeness > leastLikeness && flat < mostOfResampled * laplacians;
    if (flat > std::max(clearlyMore * laplacians, leastShared)) {
      return {flat, blocks->sharing, isResampled};
    }
    if (isTexture(laplacians, flat, blocks->medianVariance)) {
      return {flat, blocks->sharing > clearlySharing ? blocks->sharing : 1., isResampled};
    }
    const bool isFullOfEdges = flat >= leastShared && blocks->upperVariance > leastOfEdgeBlocks * blocks->variance;
    return {isFullOfEdges ? std::clamp(flat, leastOfLaplacians * laplacians, laplacians) : laplacians, 1., isResampled};
  }
  return {laplacians, 1.};
}
} // namespace circle_marker
END_VISP_NAMESPACE
