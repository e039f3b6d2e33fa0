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
// What is declared from here on may use AVX2 and FMA. Whatever else uses as well must not: the linker keeps one copy of
// an inline function, which then runs on any processor. So all headers without lanes come first.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include <immintrin.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include "pose/marker_plane.h"
#include "refine/fit_pixel.h"
#include "refine/fitted_pose.h"
#include "refine/fitter.h"
#include "refine/marker_pattern.h"
#include "refine/paper_end.h"
#include "refine/photometry.h"
#include "refine/plane_point.h"
#include "refine/surround.h"
#include "support/camera_model.h"
#include "support/normal_distribution.h"

#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx2,fma"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2,fma")
#endif
#define CIRCLE_MARKER_WIDE_LANES

#include "refine/coherence.cpp"
#include "refine/fit_conclusion.cpp"
#include "refine/fit_pixels.cpp"
#include "refine/fit_preparation.cpp"
#include "refine/fit_progress.cpp"
#include "refine/fit_step.cpp"
#include "refine/image_model.cpp"
#include "refine/lanes_fitter.h"
#include "refine/likelihood.cpp"
#include "refine/line_model.cpp"
#include "refine/maximum_likelihood.cpp"
#include "refine/pixel_blocks.cpp"
#include "refine/plane_lanes.cpp"
#include "refine/residuals.cpp"

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
  return std::make_unique<wide_lanes::LanesFitter>();
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
