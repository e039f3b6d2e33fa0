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
 * The less likely of a marker's two poses: whether it is worth a fit, and how far behind it ends.
 */

#ifndef VP_CIRCLE_MARKER_OTHER_POSE_H
#define VP_CIRCLE_MARKER_OTHER_POSE_H

#include <optional>

#include "refine/coarse_fits.h"
#include "refine/measure.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! A second pose that is not refined. */
struct GivenUp
{
  FittedPose fit;
  double moreCost = 0.; //!< Than that of the first.
};

/*! Takes the second coarse fit out if few pixels say enough against it: all of them would say more. */
std::optional<GivenUp> giveUpHopeless(const MarkerInImage &view, RankedFits &coarse);

/*!
  Takes all but the best coarse fit of a code in doubt out: it is proven at the better pose, and only then is the other
  one worth a fit.
*/
void leaveBest(RankedFits &coarse);

/*!
  Compares the poses once more, if the other one was given up early, and always of a plain ring that something covers:
  an outline of which a part is missing has poses from which the fit may lead anywhere. (Behind a blob over two fifths
  the other one of a ring of 48 pixels was 0.4 m nearer, and the mirrored one came first with odds of e^187.) Few
  pixels tell it; all pixels, if it is not hopeless there.
  \param view : What is looked at; it takes the light.
  \param ranked : The fits on all pixels.
  \param givenUp : The second pose, if it was not refined.
  \param settings : Of the fits.
  \param pattern : The print.
  \param memory : Working memory.
  \return Whether that has led to a better pose, which may have another mirrored one.
*/
bool compareAtTheirEnds(MarkerInImage &view, RankedFits &ranked, std::optional<GivenUp> &givenUp,
                        const FitSettings &settings, MarkerPattern &pattern, MeasureMemory &memory);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
