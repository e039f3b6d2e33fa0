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
 * ViSP's camera models as functions of their numbers.
 */

#ifndef VP_CALIBRATE_LENS_H
#define VP_CALIBRATE_LENS_H

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <visp3/core/vpCameraParameters.h>

#include "common/visp_names.h"

namespace calibrate {
enum class LensModel
{
  Plain,        //!< Without distortion.
  Distortion,   //!< One radial coefficient, from pixels to metres (kdu).
  KannalaBrandt //!< For wide angles and fisheyes: four coefficients of the angle.
};

/*! Name as on the command line. */
std::string nameOf(LensModel model);

/*!
  A camera: u = u0 + px xd, v = v0 + py yd with
  - Plain: (xd, yd) = (X/Z, Y/Z)
  - Distortion: (X/Z, Y/Z) = (1 + kdu (xd^2 + yd^2)) (xd, yd), which is vpPixelMeterConversion, the direction an
    estimator uses; its exact inverse here
  - KannalaBrandt: angle theta from the axis, (xd, yd) at theta (1 + k1 theta^2 + ... + k4 theta^8) from the origin
*/
struct Lens
{
  LensModel model = LensModel::Plain;
  Eigen::VectorXd numbers; //!< px, py, u0, v0, then kdu, or k1 to k4.

  static Lens of(LensModel model, double px, double py, double u0, double v0);

  /*! \return Image of a point of the camera's frame, pixels; nothing behind the camera or beyond the model. */
  std::optional<Eigen::Vector2d> project(const Eigen::Vector3d &point) const;

  /*! \return X/Z and Y/Z of a pixel; nothing where the model has none. */
  std::optional<Eigen::Vector2d> normalised(const Eigen::Vector2d &pixel) const;

  /*! \return As ViSP has it; kud is fitted to kdu over an image of this size, pixels. */
  vpCameraParameters parameters(unsigned int width, unsigned int height) const;

  /*! Names of the numbers. */
  std::vector<std::string> names() const;
};
} // namespace calibrate

#endif
