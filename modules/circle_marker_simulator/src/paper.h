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
 * Where the points of a printed sheet are in space, flat or bent.
 */

#ifndef VP_SIMULATOR_PAPER_H
#define VP_SIMULATOR_PAPER_H

#include <visp3/circle_marker_simulator/vpSimulatedMarker.h>

#include "lens.h"
#include "outline.h"

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

/*!
  A marker's sheet in space. A bent one lies on a cylinder: with s the coordinate across its axis, c its curvature and
  l the lift of vpSimulatedMarker::setBow(), the flat sheet's point at s comes to
    s' = sin(c s) / c,  z' = (1 - cos(c s)) / c - l.
*/
class Paper
{
public:
  Paper(const vpSimulatedMarker &marker, const vpHomogeneousMatrix &cMo);

  bool isFlat() const { return m_curvature == 0.; }

  //! Image, in pixels, of a point of the sheet given as if it were flat, in metres; throws as Lens::project().
  PlanePoint project(const PlanePoint &p, const Lens &lens) const;

  //! Whether the printed side faces the camera; throws a vpException if it does so in part.
  bool showsItsFace() const;

private:
  bool facesCamera(double s) const;

  vpHomogeneousMatrix m_cMo;             //!< Pose, z into the marker, metres.
  double m_curvature = 0.;               //!< Of the cylinder, 1/m; positive: edges away from the viewer.
  double m_lift = 0.;                    //!< Of the whole sheet toward the viewer, metres.
  double m_acrossX = 1., m_acrossY = 0.; //!< Direction across the axis.
  double m_reach = 0.;                   //!< Greatest s of the sheet, metres.
};

} // namespace marker_simulator
END_VISP_NAMESPACE

#endif
