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
 * Ground truth of a marker in a simulated image.
 */

/*!
  \file vpMarkerTruth.h
  \brief Ground truth of a marker in a simulated image.
*/

#ifndef VP_MARKER_TRUTH_H
#define VP_MARKER_TRUTH_H

#include <optional>
#include <string>

#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/core/vpImagePoint.h>

#include <visp3/circle_marker_simulator/vpConfigCircleMarkerSimulator.h>

BEGIN_VISP_NAMESPACE

/*!
  \struct vpEllipseTruth
  \ingroup group_circle_marker_simulator
  \brief Image of a circle, in pixels: the ellipse with the area, centroid and second moments of the disc's image.

  Without lens distortion this is the image itself, which is an ellipse; with distortion it is the nearest notion.
*/
struct vpEllipseTruth
{
  vpImagePoint center;   //!< Centre, which is not the image of the circle's centre, in pixels.
  double semiAxisA = 0.; //!< Greater semi-axis, in pixels.
  double semiAxisB = 0.; //!< Lesser semi-axis, in pixels.
  double angle = 0.;     //!< Direction of the greater axis from +u toward +v, in (-pi/2, pi/2] radians.
};

/*!
  \struct vpMarkerTruth
  \ingroup group_circle_marker_simulator
  \brief What is true of a marker in one simulated image.
*/
struct vpMarkerTruth
{
  std::string family;                    //!< Family of the marker.
  int id = -1;                           //!< Number in the family, -1 without.
  double size = 0.;                      //!< Size of the marker, in metres.
  vpHomogeneousMatrix cMo;               //!< Pose, z into the marker; at the middle of the exposure; if bent: setBow().
  vpImagePoint center;                   //!< Image of the marker's origin, in pixels.
  double tilt = 0.;                      //!< Angle between the normal and the line of sight, in radians.
  std::optional<vpEllipseTruth> ellipse; //!< Image of the outer edge of a circular marker.
  double visibleEdge =
      1.; //!< Share of the outer edge (by length on the marker) that is seen: in the image, not covered.
  double coveredArea = 0.; //!< Share of the marker's image that is covered or outside of the frame.
};

END_VISP_NAMESPACE

#endif
