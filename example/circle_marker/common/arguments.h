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
 * Command lines: as the tutorials have them, and numbers within ranges.
 */

#ifndef VP_COMMON_ARGUMENTS_H
#define VP_COMMON_ARGUMENTS_H

#include <CLI/CLI.hpp>

#include "circle_marker/common/arguments.h"
#include "circle_marker/common/parse.h"

namespace common {
using tutorial::numberIn;
using tutorial::parse;
using tutorial::UsageError;
using tutorial::wholeNumber;
} // namespace common

#endif
