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

#include <optional>

#include <Eigen/Core>

#include "decode/photometry.h"
#include "decode/uneven_light.h"
#include "pose/marker_plane.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! A ring whose pose, light and blur are measured. */
struct MeasuredRing
{
  MarkerPlane plane;
  ImageFrame frame = {Eigen::Vector2d::Zero(), 1.}; //!< Coordinates of the light.
  Photometry photometry;
  double noise = 0.;                 //!< Standard deviation, grey levels.
  std::optional<UnevenLight> uneven; //!< The light, if that of the photometry is what is left in even light.

  /*! Grey level of white paper at a pixel, in even light. */
  double whiteAt(const Eigen::Vector2d &place) const { return photometry.whiteAt((place - frame.center) / frame.size); }

  /*! The photometry in other coordinates of the light: without a shadow, and of nothing around the ring. */
  Photometry photometryIn(const ImageFrame &other) const;

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
