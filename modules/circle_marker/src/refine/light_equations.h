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
 * Light and contrast by linear least squares, in lanes.
 */

#ifndef VP_CIRCLE_MARKER_LIGHT_EQUATIONS_H
#define VP_CIRCLE_MARKER_LIGHT_EQUATIONS_H

#include <array>
#include <cstddef>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "refine/lanes.h"
#include "refine/sums.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
/*! Light, the two parts of its gradient, and contrast times light. */
constexpr std::size_t lightUnknowns = 4;

/*! Normal equations of these: a grey level depends linearly on them. */
class LightEquations
{
public:
  LightEquations()
  {
    for (Lanes &lanes : m_sums) {
      lanes.setZero();
    }
  }

  /*! Adds pixels. row: what each unknown makes of their grey level, if it is 1. */
  void add(const std::array<Lanes, lightUnknowns> &row, const Lanes &grey, const Lanes &weight)
  {
    std::size_t k = 0;
    for (std::size_t i = 0; i < lightUnknowns; ++i) {
      const Lanes weighted = weight * row[i];
      for (std::size_t j = 0; j <= i; ++j) {
        m_sums[k++] += weighted * row[j];
      }
      m_sums[rightAt + i] += weighted * grey;
    }
  }

  /*! Not finite if the pixels do not fix the unknowns. */
  Eigen::Vector4d solve() const
  {
    const std::array<Lanes, 2> totals = {sumOfEach(m_sums.data()), sumOfEach(m_sums.data() + laneCount)};
    const auto total = [&totals](std::size_t k) {
      return static_cast<double>(totals[k / laneCount][static_cast<std::ptrdiff_t>(k % laneCount)]);
    };
    Eigen::Matrix4d matrix;
    Eigen::Vector4d right;
    std::size_t k = 0;
    for (int i = 0; i < static_cast<int>(lightUnknowns); ++i) {
      for (int j = 0; j <= i; ++j) {
        matrix(i, j) = total(k++);
        matrix(j, i) = matrix(i, j);
      }
      right[i] = total(rightAt + static_cast<std::size_t>(i));
    }
    return matrix.ldlt().solve(right);
  }

private:
  static constexpr std::size_t rightAt = lightUnknowns * (lightUnknowns + 1) / 2;

  std::array<Lanes, 2 * laneCount> m_sums; //!< Lower triangle of the matrix, row by row, and the right-hand side.
};
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
