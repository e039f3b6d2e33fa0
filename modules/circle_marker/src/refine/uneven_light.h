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
 * Light that is uneven across a marker, such as a soft reflection on glossy paper.
 */

/*!
  \file uneven_light.h
  \brief Light that is uneven across a marker, such as a soft reflection on glossy paper.

  A lamp's reflection lies over paper and ink alike: it adds to both. A spot of light multiplies both. So white is
  \f$ W(q) \f$ at a place q of the sheet and the step from it to black \f$ S(q) \f$, smooth functions both, and a pixel
  that sees the share D of black has the grey level
  \f[ I = W(q) - S(q) D. \f]
  With D of a fit, that is linear in both functions, which are sums of Gaussians on a grid; they are found by least
  squares, with the prior that they are even (a Gaussian process of which the grid is the base). In even light the pixel
  would have
  \f[ I' = W_0 - (W(q) - I) S_0 / S(q), \f]
  with the means over the marker as \f$ W_0, S_0 \f$.
*/

#ifndef VP_CIRCLE_MARKER_UNEVEN_LIGHT_H
#define VP_CIRCLE_MARKER_UNEVEN_LIGHT_H

#include <array>
#include <optional>
#include <vector>

#include "refine/fit_pixel.h"
#include "refine/shadow_split.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! Light that changes smoothly across a marker's sheet, in any way. */
class UnevenLight
{
public:
  /*!
    The light that the pixels around a marker's edges show.
    \param pixels : The pixels, with the share of black that each sees by a fit, whose pose may be off by a pixel.
    \param toSheet : Takes their offsets to the marker's plane, in outer radii.
    \param noise : Standard deviation of the image's noise, grey levels.
    \return Nothing where no print is seen.
  */
  static std::optional<UnevenLight> of(const std::vector<ExplainedPixel> &pixels, const Eigen::Matrix2d &toSheet,
                                       double noise);

  /*! The grey level that a pixel would have in even light. */
  float evened(const Eigen::Vector2f &offset, float grey) const;

  /*! The grey level that it has, from that: the inverse. */
  float uneven(const Eigen::Vector2f &offset, float evened) const;

private:
  static constexpr int across = 5;                   // Gaussians in a row of the grid
  static constexpr int size = 1 + across * across;   // and the mean
  using Base = Eigen::Matrix<double, size, 1>;       // values of all at a place
  using Functions = Eigen::Matrix<double, 2 * size, 1>; // of W and of S

  Base baseAt(const Eigen::Vector2f &offset) const;

  Eigen::Matrix2d m_toSheet;
  Base m_white, m_step;           // coefficients of W and S
  double m_meanWhite, m_meanStep; // grey levels
};

/*! Takes pixels to even light. */
void evenOut(const UnevenLight &light, std::vector<FitPixel> &pixels);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
