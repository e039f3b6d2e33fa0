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
 * The lines that tell how an experiment's data were made.
 */

#ifndef VP_EXPERIMENTS_RUN_HEADER_H
#define VP_EXPERIMENTS_RUN_HEADER_H

#include <string>
#include <vector>

#include "settings.h"

namespace experiments {
/*! Value of a range that is the experiment's own. */
constexpr const char *ownRange = "-";

/*! A setting as text. */
struct HeaderLine
{
  std::string key, value;
};

/*! What must be the same for frames to belong together: versions, seed and all that changes an image. */
std::vector<HeaderLine> headerOf(const Settings &settings);

/*!
  The settings of such lines; those that are not among the lines are as given.
  \exception std::invalid_argument : If a value is not a number.
*/
Settings settingsOf(const std::vector<HeaderLine> &lines, const Settings &given);
} // namespace experiments

#endif
