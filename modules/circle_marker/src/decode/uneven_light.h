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
  In even light it would have
  \f[ I' = W_0 - (W(q) - I) S_0 / S(q), \f]
  with the means over the marker as \f$ W_0, S_0 \f$. Both functions are sums of a constant and Gaussians on a grid.
*/

#ifndef VP_CIRCLE_MARKER_UNEVEN_LIGHT_H
#define VP_CIRCLE_MARKER_UNEVEN_LIGHT_H

#include <Eigen/Core>

#include <visp3/circle_marker/vpConfigCircleMarker.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! White, and the step from it to black, where the light on a marker changes smoothly in any way. */
struct UnevenLight
{
  static constexpr int inRow = 5;                 //!< Gaussians in a row of the grid.
  static constexpr int terms = 1 + inRow * inRow; //!< Of either function: a constant and the Gaussians.
  using Terms = Eigen::Matrix<double, terms, 1>;

  /*! The terms at a pixel. */
  Terms termsAt(const Eigen::Vector2d &place) const;

  /*! The grey level that a pixel would have in even light. */
  double evened(const Eigen::Vector2d &place, double grey) const;

  /*! The grey level that it has, from that: the inverse. */
  double uneven(const Eigen::Vector2d &place, double evened) const;

  Eigen::Vector2d center = Eigen::Vector2d::Zero();      //!< Of the marker, pixels.
  Eigen::Matrix2d toSheet = Eigen::Matrix2d::Identity(); //!< From pixels off it to outer radii on the sheet.
  Terms white = Terms::Zero();                           //!< Coefficients of W, grey levels.
  Terms step = Terms::Zero();                            //!< And of S.
  double meanWhite = 0.;                                 //!< W_0, grey levels.
  double meanStep = 0.;                                  //!< S_0, grey levels; positive.

private:
  double stepFrom(const Terms &at) const;
};
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
