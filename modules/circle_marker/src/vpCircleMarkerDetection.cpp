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
 * One detected circular marker.
 */

#include <visp3/circle_marker/vpCircleMarkerDetection.h>

BEGIN_VISP_NAMESPACE
/*!
  Covariance of where the marker is and how it is turned: of \f$ (dt, \omega) \f$ in the camera frame with
  \f$ t^{true} = t + dt \f$ and \f$ R^{true} = \exp([\omega]_\times) R \f$. With \f$ \delta = (\upsilon, \omega) \f$ of
  vpCircleMarkerDetection::covariance, to first order \f$ dt = \upsilon + \omega \times t \f$. The square root of its
  third diagonal element is the standard deviation of the marker's distance along the camera's axis; that of
  vpCircleMarkerDetection::covariance is that of a turn about the camera besides, and much larger beside the axis.

  \return The 6 x 6 matrix, metres and radians.
*/
vpMatrix vpCircleMarkerDetection::getCovarianceOfCenter() const
{
  vpMatrix toCenter(6, 6);
  toCenter.eye();
  toCenter.insert(-1. * cMo.getTranslationVector().skew(), 0, 3);
  return toCenter * covariance * toCenter.t();
}
END_VISP_NAMESPACE
