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
 * Command line of circle-marker-bound.
 */

#ifndef VP_BOUND_COMMAND_LINE_H
#define VP_BOUND_COMMAND_LINE_H

#include "circle_marker/common/arguments.h"
#include "plan.h"

namespace planner {
using Request = tutorial::RequestFor<Settings>;

/*!
  \exception UsageError : If the arguments are wrong.
  \exception std::runtime_error : If the camera cannot be read.
*/
Request parseCommandLine(int argc, const char *const argv[]);
} // namespace planner

#endif
