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
 * Ranges and groups of records.
 */

#ifndef VP_ACCURACY_RANGES_H
#define VP_ACCURACY_RANGES_H

#include <string>
#include <vector>

#include "summary.h"

namespace accuracy {
/*! A range of one thing, with its name for a table. */
struct Range
{
  std::string name;
  Filter filter;
};

/*! Of the diameter, from parts.h; the first and the last are open. */
std::vector<Range> octaveRanges();
/*! Of the minor axis: 8 pixels and more, 4 to 8, less. */
std::vector<Range> minorRanges();
std::vector<Range> tiltRanges();

Filter inPart(const std::string &part);
Filter inGroup(const std::string &group);
Filter byMethod(const std::string &method);

/*! The names of the methods, each once, in the order of their first record. */
std::vector<std::string> methodsOf(const Records &records);

/*! The records of those images (group and frame) in which every method found its marker, with the right pose first. */
Records commonImages(const Records &records);

/*! The records with none taken for a mirrored pose. */
Records withoutMirror(Records records);
} // namespace accuracy

#endif
