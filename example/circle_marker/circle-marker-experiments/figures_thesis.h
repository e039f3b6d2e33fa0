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
 * Figures that the thesis has of both of its simulated experiments.
 */

#ifndef VP_EXPERIMENTS_FIGURES_THESIS_H
#define VP_EXPERIMENTS_FIGURES_THESIS_H

#include <functional>
#include <string>

#include "figures.h"
#include "summary.h"

namespace experiments {
/*! True and estimated centres of each series, seen from above. */
Figure cloudFigure(const std::string &file, unsigned int columns, const Experiment &experiment, const RunData &data);

/*! Something of the estimates against the true depth, in a panel for each series. */
struct DepthPlot
{
  std::string file, title, yLabel;
  std::string setup; //!< Of the panels.
  std::function<double(const Sample &, const Deviation &)> y;
};
Figure depthFigure(const DepthPlot &plot, unsigned int columns, const Experiment &experiment, const RunData &data);

/*! The estimated depth, metres: eCz against Cz. */
DepthPlot estimatedDepth(const std::string &file);
} // namespace experiments

#endif
