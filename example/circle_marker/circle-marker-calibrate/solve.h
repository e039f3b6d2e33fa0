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
 * The camera that explains the pictures.
 */

#ifndef VP_CALIBRATE_SOLVE_H
#define VP_CALIBRATE_SOLVE_H

#include <string>

#include "adjust.h"

namespace calibrate {
/*! What is taken for the image of a circle's centre. */
enum class Centers
{
  True,   //!< The projected centre: the ellipse's centre less what the camera makes of it.
  Ellipse //!< The ellipse's centre itself.
};

/*! A calibration with one model. */
struct Calibration
{
  Adjustment adjustment;
  std::vector<View> views;    //!< With the centres of circles where they were taken to be.
  std::size_t leftOut = 0;    //!< Points that did not belong to the rest.
  double greatestOffset = 0.; //!< Of an ellipse's centre from the projected centre, pixels.
};

/*!
  Calibrates. The offset between an ellipse's centre and the image of the circle's centre follows from camera and pose,
  so both are computed in turn until they agree. Points whose residual is beyond six times the others' are left out.

  \param target : What was seen.
  \param views : As seen; each with at least four points.
  \param model : Of the lens.
  \param centers : What the points of circles are taken for.
  \param start : To begin with; none: a first guess is made.
*/
Calibration calibrate(const Target &target, const std::vector<View> &views, LensModel model, Centers centers,
                      const Adjustment *start = nullptr);

/*!
  \return Centre of the image of a circle (of the area within it) less the image of its centre, pixels; zero where the
  camera does not see the circle whole.
*/
Eigen::Vector2d centerOffset(const Lens &lens, const TargetPose &pose, const TargetPoint &circle);

/*! \return Centre of the area within a closed line. */
Eigen::Vector2d centroidOf(const std::vector<Eigen::Vector2d> &outline);
} // namespace calibrate

#endif
