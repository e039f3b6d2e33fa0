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
 * Results for programs, and the report page.
 */

#ifndef VP_ACCURACY_REPORT_H
#define VP_ACCURACY_REPORT_H

#include <string>
#include <vector>

#include "tables.h"

namespace accuracy {
/*! Tables, each a list of objects, and every target with its figure. */
std::string jsonOf(const std::vector<std::string> &comments, const std::vector<Table> &tables,
                   const std::vector<Check> &checks);

/*!
  Writes the page README.md and its plots.
  \exception std::runtime_error : If a file cannot be written, or gnuplot is missing or fails.
*/
void writePage(const std::string &folder, const std::vector<std::string> &comments, const Records &records,
               const std::vector<Table> &tables);
} // namespace accuracy

#endif
