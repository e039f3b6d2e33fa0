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

#include "arguments.h"

namespace common {
CLI::Validator numberIn(double least, double most)
{
  const std::string range = CLI::detail::to_string(least) + " to " + CLI::detail::to_string(most);
  return CLI::Validator(
      [least, most, range](std::string &text) {
        double value = 0.;
        const bool isGood = CLI::detail::lexical_cast(text, value) && value >= least && value <= most;
        return isGood ? std::string() : "\"" + text + "\" is not a number from " + range;
      },
      range);
}
} // namespace common
