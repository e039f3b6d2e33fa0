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
 * Outlines of markers at two scales of the image.
 */

#include "ellipse/outlines.h"

#include <algorithm>
#include <future>

#include <opencv2/imgproc.hpp>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// The outline of the smallest marker that can be read, with a minor axis of 4 pixels, has 20 pixels.
constexpr std::size_t shortestChain = 14;
// Of the half-size image only outlines of this semi-minor axis count, pixels of the half: smaller ones are found at
// full size or not worth it.
constexpr double leastHalfSemiMinor = 5.;

void findAt(const vpImage<unsigned char> &I, OutlineMemory::Scale &scale)
{
  computeGradient(I, scale.gradient);
  linkEdgeChains(scale.gradient, shortestChain, scale.chains);
  findEllipses(I, scale.gradient, scale.chains, scale.candidates);
}

void halve(const vpImage<unsigned char> &I, vpImage<unsigned char> &half)
{
  half.resize(I.getHeight() / 2, I.getWidth() / 2);
  // An odd last row or column is left out, so that every pixel of the half is the mean of four.
  const cv::Mat source(static_cast<int>(2 * half.getHeight()), static_cast<int>(2 * half.getWidth()), CV_8U,
                       const_cast<unsigned char *>(I.bitmap), I.getWidth());
  cv::Mat target(static_cast<int>(half.getHeight()), static_cast<int>(half.getWidth()), CV_8U, half.bitmap);
  cv::resize(source, target, target.size(), 0., 0., cv::INTER_AREA);
}

// From pixels of the half-size image: pixel u' covers 2 u' and 2 u' + 1, its centre is at 2 u' + 1/2.
EllipseCandidate enlarged(const EllipseCandidate &half)
{
  const Eigen::Vector2d shift(0.5, 0.5);
  EllipseCandidate full = half;
  full.ellipse.center = 2. * half.ellipse.center + shift;
  full.ellipse.a *= 2.;
  full.ellipse.b *= 2.;
  full.conic = conicFromEllipse(full.ellipse);
  for (EdgePoint &point : full.points) {
    point.position = 2. * point.position + shift;
  }
  return full;
}
} // namespace

const std::vector<EllipseCandidate> &findOutlines(const vpImage<unsigned char> &I, bool parallel, OutlineMemory &memory)
{
  auto half = std::async(parallel ? std::launch::async : std::launch::deferred, [&]() {
    halve(I, memory.halved);
    findAt(memory.halved, memory.half);
  });
  findAt(I, memory.full);
  half.get();
  std::vector<EllipseCandidate> &candidates = memory.full.candidates;
  for (const EllipseCandidate &small : memory.half.candidates) {
    if (small.ellipse.b < leastHalfSemiMinor) {
      continue;
    }
    const EllipseCandidate candidate = enlarged(small);
    const bool known = std::any_of(candidates.begin(), candidates.end(), [&](const EllipseCandidate &other) {
      return isSameOutline(other.ellipse, candidate.ellipse);
    });
    if (!known) {
      candidates.push_back(candidate);
    }
  }
  std::sort(candidates.begin(), candidates.end(),
            [](const EllipseCandidate &p, const EllipseCandidate &q) { return p.ellipse.a > q.ellipse.a; });
  return candidates;
}
} // namespace circle_marker
END_VISP_NAMESPACE
