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
 * The work on lanes, compiled for AVX2 and FMA.
 */

#include "refine/wide_lanes.h"

#if defined(__x86_64__) && defined(__GNUC__)
#include "refine/without_lanes.h"

#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2,fma"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2,fma")
#endif
#define CIRCLE_MARKER_WIDE_LANES

#include "refine/fit_pixels.cpp"
#include "refine/fitting_on_lanes.h"
#include "refine/selecting_fitter.h"

#if defined(__clang__)
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif

BEGIN_VISP_NAMESPACE
namespace circle_marker {
std::unique_ptr<Fitter> makeWideFitter()
{
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) {
    return nullptr;
  }
  return std::make_unique<wide_lanes::SelectingFitter>();
}
} // namespace circle_marker
END_VISP_NAMESPACE

#else
BEGIN_VISP_NAMESPACE
namespace circle_marker {
std::unique_ptr<Fitter> makeWideFitter()
{
  return nullptr;
}
} // namespace circle_marker
END_VISP_NAMESPACE
#endif
