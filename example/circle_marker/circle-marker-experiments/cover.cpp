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
 * Something opaque in front of a part of a marker.
 */

#include <cmath>
#include <vector>

#include "cover.h"

namespace experiments {
double chordDistance(double share)
{
  // The segment beyond the distance cos(a) has the share (a - sin(a) cos(a)) / pi, which grows with a from 0 to pi.
  double least = 0.;
  double most = M_PI;
  constexpr int halvings = 60; // To the rounding.
  for (int i = 0; i < halvings; ++i) {
    const double angle = 0.5 * (least + most);
    (angle - std::sin(angle) * std::cos(angle) < share * M_PI ? least : most) = angle;
  }
  return std::cos(0.5 * (least + most));
}

vpSceneOccluder occluderOf(const Cover &cover, const vpMarkerSceneSimulator &camera, const vpHomogeneousMatrix &cMo,
                           double radius)
{
  constexpr double beyond = 2.; // In radii: more than the corners of any sheet.
  const double c = std::cos(cover.direction);
  const double s = std::sin(cover.direction);
  const auto cornerAt = [&](double along, double across) {
    const double x = radius * (c * along - s * across);
    const double y = radius * (s * along + c * across);
    return camera.project(cMo[0][0] * x + cMo[0][1] * y + cMo[0][3], cMo[1][0] * x + cMo[1][1] * y + cMo[1][3],
                          cMo[2][0] * x + cMo[2][1] * y + cMo[2][3]);
  };
  const double line = chordDistance(cover.share);
  const std::vector<vpImagePoint> corners = {cornerAt(line, -beyond), cornerAt(beyond, -beyond),
                                             cornerAt(beyond, beyond), cornerAt(line, beyond)};
  return vpSceneOccluder::polygon(corners, cover.grey);
}
} // namespace experiments
