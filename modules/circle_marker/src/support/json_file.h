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
 * What all files of settings and markers have in common, whatever is in them.
 */

#ifndef VP_CIRCLE_MARKER_JSON_FILE_H
#define VP_CIRCLE_MARKER_JSON_FILE_H

#include <optional>
#include <string>

#include <visp3/circle_marker/vpConfigCircleMarker.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! \return The text of a file; nothing if it cannot be read, or is a folder. */
std::optional<std::string> readWhole(const std::string &filename);

/*!
  Writes a file whole or not at all: beside the old one, under a name that no file has, and then in its place. A link is
  followed, and what is no ordinary file, such as /dev/stdout, is written directly.
  \return Whether it is written.
*/
bool writeWhole(const std::string &filename, const std::string &text);

/*!
  \param action : "read" or "write".
  \param filename : The file.
  \exception vpException::functionNotImplementedError : Always: the module was built without nlohmann-json.
*/
[[noreturn]] void refuseWithoutJson(const std::string &action, const std::string &filename);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
