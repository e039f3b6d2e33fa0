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
 * What a robot's way was like: table, JSON, map.
 */

#ifndef VP_NAVIGATION_REPORT_H
#define VP_NAVIGATION_REPORT_H

#include <string>

#include "drive.h"

namespace navigation {
/*! What a person wants to know. */
std::string tableOf(const Journey &journey);

/*! The same as numbers. */
std::string jsonOf(const Settings &settings, const Journey &journey);

/*! A line for each image. */
std::string csvOf(const Journey &journey);

/*! The room from above with the way as it was, as the robot believed, and as the wheels alone have it; SVG. */
std::string mapOf(const common::Room &room, const Journey &journey);
} // namespace navigation

#endif
