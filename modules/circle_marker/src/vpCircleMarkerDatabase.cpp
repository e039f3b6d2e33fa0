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
 * Names, sizes, payloads and places of circular markers.
 */

#include <algorithm>

#include <visp3/circle_marker/vpCircleMarkerDatabase.h>
#include <visp3/core/vpException.h>

#include "support/database_file.h"

BEGIN_VISP_NAMESPACE

/*!
  Reads a file; what was there before is forgotten. If the file cannot be used, nothing changes.

  \param filename : Its path.
  \exception vpException::ioError : If it cannot be read.
  \exception vpException::badValue : If it is not such a file; the message names the line and what is wrong there.
  \exception vpException::functionNotImplementedError : If the module was built without nlohmann-json.
*/
void vpCircleMarkerDatabase::load(const std::string &filename)
{
  *this = circle_marker::readDatabase(filename);
}

/*!
  Writes a file as load() reads it, whole or not at all.

  \param filename : Its path.
  \exception vpException::ioError : If it cannot be written.
  \exception vpException::badValue : If a name or payload is not UTF-8.
  \exception vpException::functionNotImplementedError : If the module was built without nlohmann-json.
*/
void vpCircleMarkerDatabase::save(const std::string &filename) const
{
  circle_marker::writeDatabase(filename, *this);
}

/*!
  Adds a marker.

  \param entry : What is known of it.
  \exception vpException::badValue : If its family has no such id, its size is not positive, its pose not finite, its
  payload not the JSON that it is said to be, or if it is there already.
*/
void vpCircleMarkerDatabase::add(const vpCircleMarkerEntry &entry)
{
  circle_marker::checkEntry(entry);
  if (find(entry.family, entry.id) != nullptr) {
    throw vpException(vpException::badValue, "the marker %s is there twice; each marker has one entry",
                      circle_marker::describe(entry.family, entry.id).c_str());
  }
  m_entries.push_back(entry);
}

/*!
  \param family : Family; its name counts.
  \param id : Identity, -1 for a family without code.
  \return What is known of a marker, nullptr if nothing is; good until the database is changed.
*/
const vpCircleMarkerEntry *vpCircleMarkerDatabase::find(const vpCircleMarkerFamily &family, int id) const
{
  const auto entry = std::find_if(m_entries.begin(), m_entries.end(), [&](const vpCircleMarkerEntry &e) {
    return e.id == id && e.family.getType() == family.getType();
  });
  return entry == m_entries.end() ? nullptr : &*entry;
}

END_VISP_NAMESPACE
