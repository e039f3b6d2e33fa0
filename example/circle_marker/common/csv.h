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
 * Lines of CSV files.
 */

#ifndef VP_COMMON_CSV_H
#define VP_COMMON_CSV_H

#include <string>
#include <vector>

namespace common {
/*! What stands between the commas of a line, empty fields too (vpIoTools::splitChain() leaves these out); no quotes. */
std::vector<std::string> fieldsOf(const std::string &line);
} // namespace common

#endif
