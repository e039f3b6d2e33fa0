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
 * The work on lanes, compiled for AVX-512.
 */

#include "refine/widest_lanes.h"

#include "refine/wide_lanes.h"

#if defined(__x86_64__) && defined(__GNUC__)
#include "refine/without_lanes.h"

#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2,fma,avx512f,avx512dq,avx512vl,avx512bw"))),                   \
                             apply_to = function)
#else
#pragma GCC push_options
// GCC's own functions for these registers start from one that has no value yet (its bug 105593).
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#pragma GCC target("avx2,fma,avx512f,avx512dq,avx512vl,avx512bw")
#endif
#define CIRCLE_MARKER_WIDEST_LANES

#include "refine/fitting_on_lanes.h"

#if defined(__clang__)
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Pixels are chosen eight at a time, in tiles of 8 x 8: of larger ones more are near an edge that is none of theirs.
class WidestFitter final : public widest_lanes::LanesFitter
{
public:
  explicit WidestFitter(std::unique_ptr<Fitter> selector) : m_selector(std::move(selector)) {}

  void selectPixels(const vpImage<unsigned char> &I, const CameraModel &camera, const ImageFrame &frame,
                    const MarkerPlane *planes, std::size_t count, const MarkerPattern &pattern,
                    const PixelChoice &choice, std::vector<FitPixel> &pixels) override
  {
    m_selector->selectPixels(I, camera, frame, planes, count, pattern, choice, pixels);
  }

private:
  std::unique_ptr<Fitter> m_selector;
};
} // namespace

std::unique_ptr<Fitter> makeWidestFitter()
{
  // Processors before those with VBMI2 run slower for a while after each use of such wide registers.
  const bool hasAll = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                      __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw") &&
                      __builtin_cpu_supports("avx512vbmi2");
  std::unique_ptr<Fitter> selector = hasAll ? makeWideFitter() : nullptr;
  return selector ? std::make_unique<WidestFitter>(std::move(selector)) : nullptr;
}
} // namespace circle_marker
END_VISP_NAMESPACE

#else
BEGIN_VISP_NAMESPACE
namespace circle_marker {
std::unique_ptr<Fitter> makeWidestFitter()
{
  return nullptr;
}
} // namespace circle_marker
END_VISP_NAMESPACE
#endif
