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
 * The shadow that falls on what stands in a scene, before the lens.
 */

#ifndef VP_SIMULATOR_SHADE_H
#define VP_SIMULATOR_SHADE_H

#include <vector>

#include <visp3/core/vpImage.h>

#include <visp3/circle_marker_simulator/vpScenePhotometry.h>

#include "outline.h"

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

//! A sharp shadow: the dark side of a straight line, which takes a part of the light.
struct SharpShadow
{
  Outline darkSide;
  double taken;
};

/*!
  A shadow with a penumbra as the sum of sharp ones: light falls on paper and print before the lens blurs them, and a
  lens may be applied to regions that are cut by a line.

  \param shadow : the shadow.
  \param blur : standard deviation of what blurs the image, at least, in pixels: the sharp shadows lie as far apart as
  leaves 1e-5 of the light behind it.
*/
std::vector<SharpShadow> sharpShadows(const vpSceneShadow &shadow, double blur);

/*!
  Multiplies each pixel of a background that is even but for the shadow with what a pixel sees of that.

  \param shadow : the shadow.
  \param blur : standard deviation of lens blur and pixel together, in pixels.
  \param defocusRadius : of the disc that blurs the image as well, in pixels; 0: none.
  \param I : the background.
*/
void castShadow(const vpSceneShadow &shadow, double blur, double defocusRadius, vpImage<float> &I);

} // namespace marker_simulator
END_VISP_NAMESPACE

#endif
