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
 * Whether pictures say enough about a camera.
 */

#ifndef VP_CALIBRATE_CHECKS_H
#define VP_CALIBRATE_CHECKS_H

#include <string>
#include <vector>

#include "solve.h"

namespace calibrate {
/*! What the views are good for. */
struct ViewSpread
{
  double greatestTurn = 0.; //!< Greatest angle between the target's normals in two views, radians.
  double reach = 0.;        //!< Greatest distance of a point from the image's centre, over that of the corner.
};

ViewSpread spreadOf(const std::vector<View> &views, const Adjustment &adjustment);

/*! \return Why views cannot be used before anything is computed; empty: they can. */
std::string problemOfViews(const std::vector<View> &views);

/*! \return Why a calibration is not to be trusted, each with what to do; none: it can be. */
std::vector<std::string> problemsOf(const Calibration &calibration);

/*! \return What the user should know of a calibration that can be used. */
std::vector<std::string> remarksOn(const Calibration &calibration);
} // namespace calibrate

#endif
