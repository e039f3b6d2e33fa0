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
 * JSON values that know the line of the file they stand on.
 */

#ifndef VP_CIRCLE_MARKER_JSON_LINES_H
#define VP_CIRCLE_MARKER_JSON_LINES_H

#include <visp3/circle_marker/vpConfigCircleMarker.h>

#ifdef VISP_CIRCLE_MARKER_HAVE_JSON
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! A value of a JSON text and where it begins. */
struct JsonNode
{
  enum class Kind
  {
    Scalar,
    Array,
    Object
  };

  Kind kind = Kind::Scalar;
  unsigned int line = 1;                                  //!< Line of its first character, from 1.
  nlohmann::json scalar;                                  //!< Value of a scalar.
  std::vector<std::pair<std::string, JsonNode>> children; //!< Members of an object; elements of an array, no names.

  /*! \return The member of a name, if there is one. */
  const JsonNode *find(const std::string &name) const;
};

/*! \return The value as the JSON library has it. */
nlohmann::json valueOf(const JsonNode &node);

/*! Lists and objects in each other that are read: a tree is gone through by functions that call themselves. */
constexpr std::size_t deepestJson = 100;

/*!
  Reads a JSON text.
  \param text : The text.
  \param deepest : How many lists and objects may lie in each other.
  \exception vpException::badValue : If it is none, is nested too deeply, or an object names a member twice: "line N: "
  and what is wrong.
*/
JsonNode parseWithLines(const std::string &text, std::size_t deepest = deepestJson);

/*!
  \param line : Line of the file.
  \param problem : What is wrong there, and what should be.
  \exception vpException::badValue : Always; the message begins with the line.
*/
[[noreturn]] void refuseAtLine(unsigned int line, const std::string &problem);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
#endif
