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
 * What code on lanes and code without lanes have in common.
 */

/*!
  \file without_lanes.h
  \brief All headers without lanes that code on lanes uses.

  Whatever is declared after the line that allows more instructions may use them. Whatever else uses as well must not:
  the linker keeps one copy of an inline function, which then runs on any processor. So these come before that line.
*/

#ifndef VP_CIRCLE_MARKER_WITHOUT_LANES_H
#define VP_CIRCLE_MARKER_WITHOUT_LANES_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>
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
#include "decode/paper_end.h"
#include "decode/photometry.h"
#include "refine/plane_point.h"
#include "refine/shadow_split.h"
#include "refine/surround.h"
#include "support/camera_model.h"
#include "support/normal_distribution.h"
#include "support/symmetric_eigen.h"

#include <visp3/core/vpImage.h>

#endif
