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
 * A ring whose pose, light and blur are measured: what the pixels of its code are compared with.
 */

#ifndef VP_CIRCLE_MARKER_MEASURED_RING_H
#define VP_CIRCLE_MARKER_MEASURED_RING_H

#include <Eigen/Core>

#include "pose/marker_plane.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! A ring whose pose, light and blur are measured. */
struct MeasuredRing
{
  MarkerPlane plane;
  Eigen::Vector2d origin = Eigen::Vector2d::Zero(); //!< Pixel at which the light is told.
  double light = 0.;                                //!< Grey level of white paper there.
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();  //!< Change of the light by the pixel, share of it.
  double absorption = 0.;                           //!< Share of the light that ink takes.
  double gamma = 1.;                                //!< The camera's: grey levels are the light to that power.
  double growth = 0.;                               //!< By which black is printed, or looks, larger, outer radii.
  double blur = 0.;                                 //!< Standard deviation, geometric mean over directions, pixels.
  Eigen::Matrix2d blurShape = Eigen::Matrix2d::Identity(); //!< Of determinant 1: along n it is blur |blurShape n|.
  double noise = 0.;                                       //!< Standard deviation, grey levels.
  double shade = 1.;                                       //!< Light that is left in a shadow on it.
  Eigen::Vector2d toShade = Eigen::Vector2d::Zero(); //!< Into the shadow, 1 / (softness of its edge) by the pixel.
  double shadeEdge = 0.;                             //!< Where its edge lies along that.

  /*! Grey level of white paper at a pixel. */
  double whiteAt(const Eigen::Vector2d &place) const;

  /*! What a grey level at a pixel is between ink, 0, and paper, 1: linear in the light, as the blur mixes them. */
  double levelAt(const Eigen::Vector2d &place, double grey) const;

  /*! Whether a grey level at a pixel says no more than that it is as bright as a sensor tells, or brighter. */
  bool isCutOff(const Eigen::Vector2d &place, double grey) const;

  /*! Standard deviation of such a level by the noise: on ink or on paper, where it is larger. */
  double noiseOfLevel() const;
};
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
