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

#include <Eigen/Core>

#include "refine/lanes.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
/*! Normal equations of a few unknowns of the light, on which a grey level depends linearly. */
template <std::size_t unknowns> class LightEquations
{
public:
  using Matrix = Eigen::Matrix<double, static_cast<int>(unknowns), static_cast<int>(unknowns)>;
  using Vector = Eigen::Matrix<double, static_cast<int>(unknowns), 1>;

  LightEquations()
  {
    for (Lanes &lanes : m_sums) {
      lanes.setZero();
    }
  }

  /*! Adds pixels. row: what each unknown makes of their grey level, if it is 1. */
  void add(const std::array<Lanes, unknowns> &row, const Lanes &grey, const Lanes &weight)
  {
    std::size_t k = 0;
    for (std::size_t i = 0; i < unknowns; ++i) {
      const Lanes weighted = weight * row[i];
      for (std::size_t j = 0; j <= i; ++j) {
        m_sums[k++] += weighted * row[j];
      }
      m_sums[rightAt + i] += weighted * grey;
    }
  }

  /*! Their matrix, as far as the pixels fix it. */
  Matrix matrix() const
  {
    Matrix whole;
    std::size_t k = 0;
    for (Eigen::Index i = 0; i < whole.rows(); ++i) {
      for (Eigen::Index j = 0; j <= i; ++j) {
        whole(i, j) = whole(j, i) = static_cast<double>(m_sums[k++].sum());
      }
    }
    return whole;
  }

  /*! Their right-hand side. */
  Vector right() const
  {
    Vector sums;
    for (Eigen::Index i = 0; i < sums.size(); ++i) {
      sums[i] = static_cast<double>(m_sums[rightAt + static_cast<std::size_t>(i)].sum());
    }
    return sums;
  }

private:
  static constexpr std::size_t rightAt = unknowns * (unknowns + 1) / 2;

  std::array<Lanes, rightAt + unknowns> m_sums; //!< Lower triangle of the matrix, row by row, and the right-hand side.
};
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
