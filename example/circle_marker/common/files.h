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
 * Files that appear whole or not at all, and gnuplot.
 */

#ifndef VP_COMMON_FILES_H
#define VP_COMMON_FILES_H

#include <string>
#include <vector>

namespace common {
/*!
  Makes a folder unless it is there, and tries whether it can be written to.
  \exception std::runtime_error : If it cannot: why, and what to do.
*/
void makeFolder(const std::string &folder);

/*!
  Writes a file under another name and renames it when it is complete.
  \exception std::runtime_error : If it cannot be written.
*/
void writeWhole(const std::string &folder, const std::string &name, const std::string &content);

/*!
  Has gnuplot draw a script's plots in the folder of the script.
  \e script: Name of the script, which adds the variable `suffix` to the names of the files it writes.
  \e plots: Names of these files; older ones are replaced.
  \exception std::runtime_error : If gnuplot is missing or fails.
*/
void drawPlots(const std::string &folder, const std::string &script, const std::vector<std::string> &plots);
} // namespace common

#endif
