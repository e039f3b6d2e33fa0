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
 * Families of markers in JSON files.
 */

/*!
  \file family_json.h
  \brief Families of markers in JSON files: a family is its name; a ring of its own ratio is {"name": "ring", "ratio":
  0.65}; a family with other radii is {"name": "golay23", "layout": {"ringInner": 0.75, ...}}, with all four of them.
*/

#ifndef VP_CIRCLE_MARKER_FAMILY_JSON_H
#define VP_CIRCLE_MARKER_FAMILY_JSON_H

#include <visp3/circle_marker/vpConfigCircleMarker.h>

#ifdef VISP_CIRCLE_MARKER_HAVE_JSON
#include <nlohmann/json.hpp>

#include <visp3/circle_marker/vpCircleMarkerFamily.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  \exception vpException::badValue : If it is no family; the message says what it must be.
  \exception nlohmann::json::exception : If a name or a radius is of another type.
*/
vpCircleMarkerFamily familyFromJson(const nlohmann::json &value);

/*! \return The family as familyFromJson() reads it: all of it, its layout too. */
nlohmann::json familyToJson(const vpCircleMarkerFamily &family);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
#endif
