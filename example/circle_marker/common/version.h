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
 * The version of this project.
 */

#ifndef VP_COMMON_VERSION_H
#define VP_COMMON_VERSION_H

namespace common {
/*! As in the project's own CMakeLists.txt, which a build inside ViSP's tree does not read. */
constexpr const char *projectVersion = "0.1.0";
} // namespace common

#endif
