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
 * What circle-marker-bound tells: tables for people, CSV and JSON for programs, a plot.
 */

#ifndef VP_BOUND_REPORT_H
#define VP_BOUND_REPORT_H

#include <string>
#include <vector>

#include "plan.h"

namespace planner {
/*! The limits for people; a table for each angle. */
std::string tableOf(const Settings &settings, const std::vector<Row> &rows);

/*! What is possible, for people; nothing if no accuracy is wanted. */
std::string answerOf(const Settings &settings, const std::vector<Reach> &reaches);

/*! One row for each angle and distance. */
std::string csvOf(const std::vector<Row> &rows);

/*! Settings, rows and reaches. */
std::string jsonOf(const Settings &settings, const std::vector<Row> &rows, const std::vector<Reach> &reaches);

/*! What gnuplot draws: bound.svg. */
std::string plotScript(const Settings &settings, const std::vector<Row> &rows);
} // namespace planner

#endif
