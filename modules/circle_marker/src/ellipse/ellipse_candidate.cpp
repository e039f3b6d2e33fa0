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
 * An outline that is taken from an ellipse.
 */

#include "ellipse/ellipse_candidate.h"

#include "ellipse/ellipse_walk.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
void setOutline(const EllipseParameters &ellipse, int points, EllipseCandidate &candidate)
{
  candidate.ellipse = ellipse;
  candidate.conic = conicFromEllipse(ellipse);
  candidate.support = 1.;
  candidate.points.clear();
  EllipseWalk walk(ellipse, points);
  for (int i = 0; i < points; ++i, walk.next()) {
    candidate.points.push_back(walk.here());
  }
}
} // namespace circle_marker
END_VISP_NAMESPACE
