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
 * Command lines: options as ViSP's tools write them, numbers within ranges.
 */

#ifndef VP_COMMON_ARGUMENTS_H
#define VP_COMMON_ARGUMENTS_H

#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace common {
/*! Wrong arguments: the program ends with 2. */
class UsageError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/*! Arguments in the order CLI11 wants them, last first; options may be written with underscores. */
std::vector<std::string> reversedArguments(int argc, const char *const argv[]);

/*! A number in a range; CLI11's own check lets what is no number (nan) pass. */
CLI::Validator numberIn(double least, double most);

/*!
  Parses arguments.

  \return True: go on; false: help is asked for, app.help().
  \exception UsageError : If the arguments are wrong.
*/
bool parse(CLI::App &app, int argc, const char *const argv[]);
} // namespace common

#endif
