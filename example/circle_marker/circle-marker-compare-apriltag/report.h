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
 * The results as text: rows of CSV, JSON, and a table for people.
 */

#ifndef VP_COMPARE_REPORT_H
#define VP_COMPARE_REPORT_H

#include <string>
#include <vector>

#include "experiment.h"
#include "summary.h"
#include "trial.h"

namespace compare {
/*! One row for each frame and method. The last column is time. */
std::string csvOf(const std::vector<Trial> &trials);

/*! The settings and the statistics of each cell and method; null where there was no frame to take them over. */
std::string jsonOf(const Settings &settings, const Summary &summary);

/*! The statistics for people. */
std::string tableOf(const Settings &settings, const Summary &summary);
} // namespace compare

#endif
