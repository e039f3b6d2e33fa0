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
 * The figures of each experiment.
 */

#ifndef VP_EXPERIMENTS_FIGURES_H
#define VP_EXPERIMENTS_FIGURES_H

#include <string>
#include <vector>

#include "common/figure.h"
#include "experiment.h"
#include "run_data.h"

namespace experiments {
/*! A figure and what the report says below it. */
struct CaptionedFigure
{
  Figure figure;
  std::string caption;
};

/*! Those of the thesis's chapter 5.4: 5.4 to 5.6. */
std::vector<CaptionedFigure> figuresOfLines(const Experiment &experiment, const RunData &data);

/*! Those of the thesis's chapter 5.5: 5.7 to 5.12. */
std::vector<CaptionedFigure> figuresOfCells(const Experiment &experiment, const RunData &data);

/*! Rate and errors against each disturbance. */
std::vector<CaptionedFigure> figuresOfResilience(const Experiment &experiment, const RunData &data);

/*! Limits and reach against each measure of the marker. */
std::vector<CaptionedFigure> figuresOfDesign(const Experiment &experiment, const RunData &data);

/*! The still and the moving sequence. */
std::vector<CaptionedFigure> figuresOfRequirements(const Experiment &experiment, const RunData &data);
} // namespace experiments

#endif
