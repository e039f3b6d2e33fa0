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
 * The code on lanes that fits poses.
 */

/*!
  \file fitting_on_lanes.h
  \brief All code on lanes that fits poses to pixels, to be compiled for one more set of instructions.
*/

// Without a guard: it belongs to the one file that includes it.
#include "refine/coherence.cpp"
#include "refine/fit_conclusion.cpp"
#include "refine/fit_preparation.cpp"
#include "refine/fit_progress.cpp"
#include "refine/fit_step.cpp"
#include "refine/image_model.cpp"
#include "refine/lanes_fitter.h"
#include "refine/likelihood.cpp"
#include "refine/line_model.cpp"
#include "refine/maximum_likelihood.cpp"
#include "refine/pixel_blocks.cpp"
#include "refine/plane_lanes.cpp"
#include "refine/residuals.cpp"
#include "refine/shaded_edges.cpp"
