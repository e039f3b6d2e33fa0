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
 * Camera model as an estimator needs it: pixel to metre exactly, and back.
 */

#ifndef VP_CIRCLE_MARKER_CAMERA_MODEL_H
#define VP_CIRCLE_MARKER_CAMERA_MODEL_H

#include <Eigen/Core>

#include <visp3/circle_marker/vpConfigCircleMarker.h>
#include <visp3/core/vpCameraParameters.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  The camera models of ViSP, read from pixel to metre: vpMeterPixelConversion is not the exact inverse of
  vpPixelMeterConversion when the lens distorts (kud and kdu are calibrated apart), and measured pixels are what an
  estimator starts from.
*/
class CameraModel
{
public:
  explicit CameraModel(const vpCameraParameters &camera) : m_camera(camera) {}

  /*! Normalised coordinates (z = 1) of a pixel. */
  Eigen::Vector2d toMeter(const Eigen::Vector2d &pixel) const;

  /*! Derivative of toMeter(). */
  Eigen::Matrix2d meterPerPixel(const Eigen::Vector2d &pixel) const;

  /*! Derivative of toMeter() by (px, py, u0, v0), 1 / pixel. */
  Eigen::Matrix<double, 2, 4> meterByParameters(const Eigen::Vector2d &pixel) const;

  /*! The pixel whose normalised coordinates are \e meter: inverse of toMeter(), by Newton's method. */
  Eigen::Vector2d toPixel(const Eigen::Vector2d &meter) const;

  bool isLinear() const { return m_camera.get_projModel() == vpCameraParameters::perspectiveProjWithoutDistortion; }

private:
  vpCameraParameters m_camera; //!< Intrinsic parameters.
};
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
