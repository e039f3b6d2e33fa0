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
 * The plots, as a script for gnuplot that holds its data.
 */

#ifndef VP_COMPARE_PLOTS_H
#define VP_COMPARE_PLOTS_H

#include <string>
#include <vector>

#include "experiment.h"
#include "trial.h"

namespace compare {
/*! The files the script writes into its own folder. */
inline const std::vector<std::string> plotFiles = {"position-error.svg", "normal-error.svg", "detection-rate.svg"};

/*! A script for gnuplot that draws all plots: `gnuplot compare.gp` in its folder draws them anew. */
std::string plotScript(const Settings &settings, const std::vector<Trial> &trials);
} // namespace compare

#endif
