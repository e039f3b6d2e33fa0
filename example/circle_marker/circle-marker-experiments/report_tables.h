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
 * Tables that stand methods beside the thesis.
 */

#ifndef VP_EXPERIMENTS_REPORT_TABLES_H
#define VP_EXPERIMENTS_REPORT_TABLES_H

#include "common/document.h"
#include "experiment.h"
#include "summary.h"

namespace experiments {
/*! All statistics of a series: the thesis's figures, where there are some, beside those of the views. */
void addComparison(const Series &series, const std::vector<std::optional<FrameSamples>> &frames,
                   const std::vector<View> &views, Document &document);

/*! One row for each series: frames, mean errors of the views and their detection rates. */
void addOverview(const std::string &caption, const Experiment &experiment, const RunData &data,
                 const std::vector<View> &views, Document &document);
} // namespace experiments

#endif
