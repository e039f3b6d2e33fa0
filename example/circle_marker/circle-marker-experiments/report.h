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
 * The report of the experiments: tables, and what they say.
 */

#ifndef VP_EXPERIMENTS_REPORT_H
#define VP_EXPERIMENTS_REPORT_H

#include <string>

#include "common/document.h"
#include "experiment.h"
#include "figures.h"
#include "run_data.h"

namespace experiments {
/*! How the frames were made, for the head of the report. */
void addConditions(const Settings &settings, Document &document);

/*! A section: what was done, tables, figures. */
void addLines(const Experiment &experiment, const RunData &data, Document &document);
void addCells(const Experiment &experiment, const RunData &data, Document &document);
void addResilience(const Experiment &experiment, const RunData &data, Document &document);
void addRequirements(const Experiment &experiment, const RunData &data, Document &document);
void addDesign(const Experiment &experiment, const RunData &data, Document &document);

void addFigures(const std::vector<CaptionedFigure> &figures, Document &document);

/*! The statistics of each series and view; null where there was nothing to take them over. */
std::string jsonOf(const Experiment &experiment, const Settings &settings, const RunData &data);
} // namespace experiments

#endif
