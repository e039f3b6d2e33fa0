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

#include <exception>
#include <iostream>

#include "arguments.h"
#include "run_program.h"

namespace common {
int runProgram(const std::string &name, const std::function<int()> &work)
{
  try {
    return work();
  }
  catch (const UsageError &e) {
    std::cerr << name << ": " << e.what() << std::endl;
    return 2;
  }
  catch (const std::exception &e) {
    std::cerr << name << ": " << e.what() << std::endl;
    return 1;
  }
}
} // namespace common
