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
 * The work on lanes, compiled for AVX-512.
 */

#ifndef VP_CIRCLE_MARKER_WIDEST_LANES_H
#define VP_CIRCLE_MARKER_WIDEST_LANES_H

#include <memory>

#include "refine/fitter.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! A fitter with AVX-512; nothing if the processor does not have them or the compiler cannot be told of them. */
std::unique_ptr<Fitter> makeWidestFitter();
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
