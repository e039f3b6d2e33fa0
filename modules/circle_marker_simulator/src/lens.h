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
 * Projection of points that vpPixelMeterConversion undoes exactly.
 */

#ifndef VP_SIMULATOR_LENS_H
#define VP_SIMULATOR_LENS_H

#include <array>

#include <visp3/core/vpCameraParameters.h>

#include "outline.h"

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

/*!
  Projection from the camera frame to pixels, as the inverse of ViSP's model from pixel to metre.

  ViSP's radial model has one coefficient for each direction, kud and kdu, and the two are no exact inverses. Pixel to
  metre, x = x_d (1 + kdu r_d^2), is what an estimator applies to what it measures, so it is taken for the truth and
  inverted numerically; kud is not used. Of the model of Kannala and Brandt ViSP inverts the direction used here.
*/
class Lens
{
public:
  explicit Lens(const vpCameraParameters &cam);

  //! Image, in pixels, of a point of the camera frame; throws a vpException for a point that cannot be seen.
  PlanePoint project(double X, double Y, double Z) const;

  //! Whether straight lines stay straight in the image.
  bool keepsLines() const { return m_model == vpCameraParameters::perspectiveProjWithoutDistortion; }

private:
  double imageRadius(double radius) const;

  vpCameraParameters::vpCameraParametersProjType m_model; //!< Camera model.
  double m_px, m_py, m_u0, m_v0;                          //!< Focal lengths and principal point, in pixels.
  double m_kdu;                                           //!< Radial distortion from pixel to metre.
  std::array<double, 4> m_fisheye = {0., 0., 0., 0.};     //!< Coefficients of Kannala and Brandt.
};

} // namespace marker_simulator
END_VISP_NAMESPACE

#endif
