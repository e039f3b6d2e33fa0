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
 * Names, sizes, payloads and places of circular markers, as a JSON file.
 */

#ifndef VP_CIRCLE_MARKER_DATABASE_FILE_H
#define VP_CIRCLE_MARKER_DATABASE_FILE_H

#include <string>

#include <visp3/circle_marker/vpCircleMarkerDatabase.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Throws vpException::badValue unless a marker can be: an id that its family has, a positive size, a finite pose.
*/
void checkEntry(const vpCircleMarkerEntry &entry);

/*! \return "golay23 id 5", or "ring" for a family without code. */
std::string describe(const vpCircleMarkerFamily &family, int id);

/*!
  \exception vpException::ioError : If the file cannot be read.
  \exception vpException::badValue : If it is not such a file: names the file, the line and what is wrong.
  \exception vpException::functionNotImplementedError : Without nlohmann-json.
*/
vpCircleMarkerDatabase readDatabase(const std::string &filename);

/*! Writes a file that readDatabase() reads, whole or not at all. */
void writeDatabase(const std::string &filename, const vpCircleMarkerDatabase &database);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
