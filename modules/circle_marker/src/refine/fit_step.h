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
 * One step of a fit: what it leads to, and whether that can be.
 */

/*!
  \file fit_step.h
  \brief One step of a fit: what it leads to, and whether that can be.
*/

#ifndef VP_CIRCLE_MARKER_FIT_STEP_H
#define VP_CIRCLE_MARKER_FIT_STEP_H

#include "refine/maximum_likelihood.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
/*! Matrix of the parameters that any pixel depends on. */
using UsedMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, parameters, parameters>;

using UsedVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, parameters, 1>;

/*! Rows and columns of these parameters, one after another. */
UsedMatrix usedPart(const ParameterMatrix &matrix, const UsedParameters &used);
UsedVector usedPart(const ParameterVector &vector, const UsedParameters &used);

/*! Solves the equations of these parameters; the others stay as they are. */
ParameterVector solveEquations(const ParameterMatrix &matrix, const ParameterVector &right, const UsedParameters &used);

/*! Changes pose and light by a step of the parameters; what has bounds stays within them. */
void applyStep(const ParameterVector &step, MarkerPlane &plane, Photometry &photometry);

/*! Whether light and blur are so much alike that the equations' matrix of one serves for the other. */
bool isAlike(const Photometry &p, const Photometry &q);

/*! Whether paper is lit and ink darker: the negative of a marker is none, however well it correlates. */
bool isPrint(const Photometry &photometry);
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
