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

#ifndef VP_SIMULATOR_LAYERS_H
#define VP_SIMULATOR_LAYERS_H

#include <vector>

#include <visp3/circle_marker_simulator/vpSceneOccluder.h>
#include <visp3/circle_marker_simulator/vpSimulatedMarker.h>

#include "lens.h"
#include "outline.h"

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

//! A region on a layer's body that differs from it by `change` grey levels.
struct Patch
{
  Outline outline;
  double change;
};

//! An opaque body (a sheet of paper, an occluder) with what is printed on it.
struct Layer
{
  Outline body;
  double grey;
  std::vector<Patch> patches;
};

//! A marker's sheet of paper, projected, from the front or from behind.
Outline sheetImage(const vpSimulatedMarker &marker, const vpHomogeneousMatrix &cMo, const Lens &lens);

//! A marker's sheet and print, projected; from behind, a blank sheet. Throws a vpException where it cannot be seen.
Layer layerOf(const vpSimulatedMarker &marker, const vpHomogeneousMatrix &cMo, const Lens &lens, double paperGrey,
              double ink);

//! An occluder.
Layer layerOf(const vpSceneOccluder &occluder);

//! Displaces the layer of the given index by multiples of 1e-7 pixels, so that no edges of two layers coincide.
void setApart(std::size_t index, Outline &outline);

/*!
  Takes from each layer what later layers hide, so that the layers that are left do not overlap and an image of them is
  a plain sum, exact also where edges of different layers meet in a pixel. Sets the layers apart first.
*/
void hideCoveredParts(std::vector<Layer> &layers);

} // namespace marker_simulator
END_VISP_NAMESPACE

#endif
