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
 * Fit of the mirrored pose to the image of a marker.
 */

#ifndef VP_SIMULATOR_MIRROR_FIT_H
#define VP_SIMULATOR_MIRROR_FIT_H

#include "marker_view.h"

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

//! The mirrored pose that is most like the true one.
struct MirrorFit
{
  ViewState state; //!< Mirrored pose, levels and blur.
  double distance; //!< Square root of the weighted sum of the squared differences of the two images.
  bool isDistinct; //!< False: the fit ran back to the true pose; state and distance are with the reflected normal.
};

//! The pose turned by the shortest way so that its normal is reflected about the line of sight to its centre.
vpHomogeneousMatrix mirrored(const vpHomogeneousMatrix &cMo);

/*!
  Fits the mirrored pose to the image of the true one by damped Gauss-Newton steps (Levenberg and Marquardt).

  First centre, spin and nuisances, the normal held; then everything, unless the two images differ by 40 standard
  deviations of the noise, where a few per cent do not matter. Where the second fit runs back to the side of the
  true normal, the two poses have one minimum in common, and the first fit is returned.

  \param view : what the camera sees of the marker.
  \param weights : inverse of each pixel's variance.
  \param truth : the true state.
  \param hasSpin : whether the spin can be seen.
*/
MirrorFit fitMirror(const MarkerView &view, const Eigen::VectorXd &weights, const ViewState &truth, bool hasSpin);

} // namespace marker_simulator
END_VISP_NAMESPACE

#endif
