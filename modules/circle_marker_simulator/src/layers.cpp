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
 * A scene's markers and occluders as layers of regions in the image.
 */

#include "layers.h"
#include "print.h"

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

namespace {

// Displacement from layer to layer, in pixels: 2e-5 grey levels at an edge, yet far above rounding. The two
// coordinates differ so that sloping edges do not stay on one another either.
constexpr double DISPLACEMENT_U = 1.0e-7;
constexpr double DISPLACEMENT_V = 0.7e-7;

} // namespace

Outline sheetImage(const vpSimulatedMarker &marker, const vpHomogeneousMatrix &cMo, const Lens &lens)
{
  const Paper paper(marker, cMo);
  Outline sheet = project(sheetOf(marker), paper, lens);
  if (!paper.showsItsFace()) {
    reverse(sheet);
  }
  return sheet;
}

Layer layerOf(const vpSimulatedMarker &marker, const vpHomogeneousMatrix &cMo, const Lens &lens, double paperGrey,
              double ink)
{
  const Paper paper(marker, cMo);
  Layer layer = {sheetImage(marker, cMo, lens), paperGrey, {}};
  if (!paper.showsItsFace()) {
    return layer;
  }
  for (const PrintedRegion &region : printOn(marker)) {
    layer.patches.push_back({project(region, paper, lens), (1. - region.whiteness) * (ink - paperGrey)});
  }
  return layer;
}

Layer layerOf(const vpSceneOccluder &occluder)
{
  Layer layer = {{}, occluder.getGrey(), {}};
  const std::vector<vpImagePoint> &corners = occluder.getCorners();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const vpImagePoint &from = corners[i];
    const vpImagePoint &to = corners[(i + 1) % corners.size()];
    layer.body.push_back({{from.get_u(), from.get_v()}, {to.get_u(), to.get_v()}});
  }
  return layer;
}

void setApart(std::size_t index, Outline &outline)
{
  const double u = static_cast<double>(index) * DISPLACEMENT_U;
  const double v = static_cast<double>(index) * DISPLACEMENT_V;
  for (Segment &s : outline) {
    s = {{s.from.x + u, s.from.y + v}, {s.to.x + u, s.to.y + v}};
  }
}

void hideCoveredParts(std::vector<Layer> &layers)
{
  for (std::size_t i = 0; i < layers.size(); ++i) {
    setApart(i, layers[i].body);
    for (Patch &patch : layers[i].patches) {
      setApart(i, patch.outline);
    }
  }
  for (std::size_t i = 0; i < layers.size(); ++i) { // the layers after i are still whole
    for (std::size_t j = i + 1; j < layers.size(); ++j) {
      layers[i].body = subtract(layers[i].body, layers[j].body);
      for (Patch &patch : layers[i].patches) {
        patch.outline = subtract(patch.outline, layers[j].body);
      }
    }
  }
}

} // namespace marker_simulator
END_VISP_NAMESPACE
