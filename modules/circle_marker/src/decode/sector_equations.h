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
 * Grey levels of the sectors of a code track, whose samples are mixtures of them.
 */

#ifndef VP_CIRCLE_MARKER_SECTOR_EQUATIONS_H
#define VP_CIRCLE_MARKER_SECTOR_EQUATIONS_H

#include <array>

#include <Eigen/Core>

#include "decode/code_track.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! A grey level for each sector, as CodeTrack::grey. */
using SectorGreys = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, mostSectors, 1>;

/*! Sum of weights below which nothing is seen of a track. */
constexpr double leastTrackWeight = 1e-6;

/*!
  Least-squares grey levels of the sectors: each sample is a mixture of its own sector and those beside it, under the
  blur.
  \param track : The samples.
  \param sectors : Number of the sectors.
  \param phase : Angle at which the first of them starts, rad.
  \param greys : The result.
  \return The weighted sum of squares of what they leave of the samples.
*/
double solveSectors(const CodeTrack &track, unsigned int sectors, double phase, SectorGreys &greys);

/*! What such grey levels leave of each sample; of what is not seen nought. */
void findResiduals(const CodeTrack &track, double phase, const SectorGreys &greys,
                   std::array<double, mostSamples> &residuals);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
