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
 * What every program's main does: errors to the standard error, and the exit status.
 */

#ifndef VP_COMMON_RUN_PROGRAM_H
#define VP_COMMON_RUN_PROGRAM_H

#include <functional>
#include <string>

namespace common {
/*!
  Runs a program's work.

  \e name: The program's name, which begins what it says about errors.
  \return The exit status: what \e work returns (0 done, 1 an input could not be used), 1 after an exception, 2 after a
  UsageError.
*/
int runProgram(const std::string &name, const std::function<int()> &work);
} // namespace common

#endif
