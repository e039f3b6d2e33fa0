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
 * Where a camera is, from all markers that it sees.
 */

#ifndef VP_NAVIGATION_LOCALISE_H
#define VP_NAVIGATION_LOCALISE_H

#include <optional>
#include <vector>

#include <visp3/circle_marker/vpCircleMarkerDatabase.h>
#include <visp3/circle_marker/vpCircleMarkerDetection.h>
#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/core/vpMatrix.h>

#include "common/visp_names.h"

namespace navigation {
/*! A camera's pose in the world with its covariance. */
struct Location
{
  vpHomogeneousMatrix wMc;
  vpMatrix covariance;      //!< 6 x 6, of delta in the camera's frame: wMc_true = wMc exp(delta); metres, radians.
  unsigned int markers = 0; //!< That it was made of.
};

/*!
  Fuses the poses of all markers of a database that were seen, weighted by their covariances.

  Each marker says wMc = wMo cMo^-1; from cMo_true = exp(delta) cMo follows wMc_true = wMc exp(-delta), so the
  covariances of the detections are those of the camera's pose in its own frame, and the most likely pose is that which
  makes the sum of d_i' S_i^-1 d_i least, with d_i = log(wMc^-1 wMc_i): iterated least squares on the group.

  Of a marker's two poses the one is taken that is nearer to what is expected, unless the first is far likelier. A
  marker that contradicts what is expected, or the others, by far more than its covariance says is left out.

  \param database : Poses of the markers in the world.
  \param detections : What was seen, z into the marker.
  \param expected : Where the camera should be, to some decimetres.
  \return Nothing if no marker of the database with a pose was seen.
*/
std::optional<Location> locate(const vpCircleMarkerDatabase &database,
                               const std::vector<vpCircleMarkerDetection> &detections,
                               const vpHomogeneousMatrix &expected);
} // namespace navigation

#endif
