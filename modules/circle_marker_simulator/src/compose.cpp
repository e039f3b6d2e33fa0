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
 * Sum of a scene's layers over its background.
 */

#include "compose.h"

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

namespace {

// Takes from a window what shadows take of the light on a region.
void shade(const Outline &region, double weight, const PixelResponse &response, const std::vector<SharpShadow> &shadows,
           CoverageWindow &window)
{
  for (const SharpShadow &shadow : shadows) {
    response.add(intersect(region, shadow.darkSide), -shadow.taken * weight, window);
  }
}

} // namespace

void addLayer(const Layer &layer, const PixelResponse &response, const vpImage<float> &background, double share,
              const std::vector<SharpShadow> &shadows, vpImage<float> &I)
{
  const unsigned int width = I.getWidth();
  const unsigned int height = I.getHeight();
  CoverageWindow body(boundingBox(layer.body), response.reach(), width, height);
  if (body.isEmpty()) {
    return;
  }
  response.add(layer.body, 1., body);
  shade(layer.body, 1., response, shadows, body);
  body.integrateRows();
  CoverageWindow print(boundingBox(layer.body), response.reach(), width, height);
  for (const Patch &patch : layer.patches) {
    response.add(patch.outline, patch.change, print);
    shade(patch.outline, patch.change, response, shadows, print);
  }
  print.integrateRows();
  for (int i = 0; i < body.height(); ++i) {
    const float *behind = background[body.top() + i] + body.left();
    float *image = I[body.top() + i] + body.left();
    const double *covered = body.row(i);
    const double *printed = print.row(i);
    for (int j = 0; j < body.width(); ++j) {
      image[j] += static_cast<float>(share * (covered[j] * (layer.grey - behind[j]) + printed[j]));
    }
  }
}

} // namespace marker_simulator
END_VISP_NAMESPACE
