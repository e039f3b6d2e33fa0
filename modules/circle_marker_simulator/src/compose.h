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

#ifndef VP_SIMULATOR_COMPOSE_H
#define VP_SIMULATOR_COMPOSE_H

#include <visp3/core/vpImage.h>

#include "layers.h"
#include "pixel_response.h"
#include "shade.h"

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

/*!
  Adds `share` of what a layer changes in the background's image; the layer must not overlap with others.

  \param layer : the layer, visible parts only.
  \param response : blur and pixel.
  \param background : grey levels behind the layers. It may be `I` itself: each pixel is read before it is changed.
  \param share : part of the exposure for which the layer is there, 0 to 1.
  \param shadows : that fall on all. \e I has them, \e background has not.
  \param[in,out] I : background plus the changes so far.
*/
void addLayer(const Layer &layer, const PixelResponse &response, const vpImage<float> &background, double share,
              const std::vector<SharpShadow> &shadows, vpImage<float> &I);

} // namespace marker_simulator
END_VISP_NAMESPACE

#endif
