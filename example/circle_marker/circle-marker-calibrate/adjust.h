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
 * Least squares over the camera and all poses of the target.
 */

#ifndef VP_CALIBRATE_ADJUST_H
#define VP_CALIBRATE_ADJUST_H

#include <vector>

#include "lens.h"
#include "target.h"
#include "view.h"

namespace calibrate {
/*! A camera that explains the pictures. */
struct Adjustment
{
  Lens lens;
  std::vector<TargetPose> poses; //!< One for each view.
  Eigen::MatrixXd covariance;    //!< Of the lens's numbers, from the residuals' own size.
  double condition = 0.;         //!< Of the normal matrix of the lens's numbers, poses eliminated, columns scaled to 1.
  double cost = 0.;              //!< Sum of squared residuals, pixels^2.
  std::size_t points = 0;        //!< Observations, all views.
  bool converged = false;

  /*! Root of the mean squared distance between seen and computed points, pixels. */
  double rms() const;
  /*! Standard deviation of one coordinate of one point, pixels: as the residuals show it. */
  double sigma() const;
};

/*!
  Minimises the squared distances between the observations and the images of the target's points, by Levenberg's and
  Marquardt's method; poses are eliminated from the normal equations view by view (Schur complement).

  \param target : What was seen.
  \param views : Its points, pixels.
  \param start : Lens and poses to begin with; every point must be in front of the camera.
*/
Adjustment adjust(const Target &target, const std::vector<View> &views, const Adjustment &start);

/*! The same with poses that are known: the lens alone is fitted. */
Adjustment adjustLens(const Target &target, const std::vector<View> &views, const Adjustment &start);

/*! Residuals of an adjustment, view after view: seen minus computed, pixels. */
std::vector<std::vector<Eigen::Vector2d>> residualsOf(const Target &target, const std::vector<View> &views,
                                                      const Adjustment &adjustment);
} // namespace calibrate

#endif
