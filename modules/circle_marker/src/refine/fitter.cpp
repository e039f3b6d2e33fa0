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
 * Chooses the fitter that the processor can do.
 */

#include "refine/fitter.h"

#include "refine/selecting_fitter.h"
#include "refine/wide_lanes.h"
#include "refine/widest_lanes.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
std::unique_ptr<Fitter> makeFitter(Instructions instructions)
{
  switch (instructions) {
  case Instructions::WIDEST:
    return makeWidestFitter();
  case Instructions::WIDE:
    return makeWideFitter();
  case Instructions::PLAIN:
    break;
  }
  return std::make_unique<SelectingFitter>();
}

std::unique_ptr<Fitter> makeFitter()
{
  for (const Instructions instructions : {Instructions::WIDEST, Instructions::WIDE}) {
    if (std::unique_ptr<Fitter> fitter = makeFitter(instructions)) {
      return fitter;
    }
  }
  return makeFitter(Instructions::PLAIN);
}
} // namespace circle_marker
END_VISP_NAMESPACE
