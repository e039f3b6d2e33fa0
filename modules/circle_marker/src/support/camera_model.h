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

  /*!
    The pixel whose normalised coordinates are \e meter: inverse of toMeter(). Without distortion a formula; with kdu
    Newton's method for the radius alone, from a side from which it cannot miss; of Kannala and Brandt's model at most
    ten steps of Newton's method from ViSP's inverse, until one is shorter than 1e-9 pixels.

    - Where kdu < 0 no pixel on its side of the principal point has a normalised radius beyond 2 / (3 sqrt(-3 kdu)), at
      the pixel radius 1 / sqrt(-3 kdu), where the lens folds over: beyond it the result is not a number.
    - Where kdu >= 0 each direction has one pixel.
    - Of Kannala and Brandt's model the start is the pixel, wherever its polynomial grows; toMeter() ends before 90
      degrees off the axis. Beyond it may be anywhere, in the image too, infinite or not a number.

    Those who sample the image need not ask: what is outside of it, or not a number, has no grey level (bilinear()), and
    a wrong place inside of it comes only of directions that are far beyond the field of view.
  */
  Eigen::Vector2d toPixel(const Eigen::Vector2d &meter) const;

  /*! The parameters. */
  const vpCameraParameters &getParameters() const { return m_camera; }

  bool isLinear() const { return m_camera.get_projModel() == vpCameraParameters::perspectiveProjWithoutDistortion; }

private:
  vpCameraParameters m_camera; //!< Intrinsic parameters.
};
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
