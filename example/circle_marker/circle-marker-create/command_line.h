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
 * The command line of circle-marker-create.
 */

#ifndef VP_CREATE_COMMAND_LINE_H
#define VP_CREATE_COMMAND_LINE_H

#include <optional>
#include <string>
#include <vector>

#include <visp3/circle_marker/vpCircleMarkerFamily.h>

#include "circle_marker/common/arguments.h"
#include "marker_shapes.h"
#include "sheet_layout.h"

namespace create {
using tutorial::UsageError;

enum class Format
{
  Pdf,
  Png,
  Svg
};

/*! What is to be printed; every field has been checked, and the markers fit the sheet. */
struct Order
{
  vpCircleMarkerFamily family;
  std::vector<int> ids;        //!< At least one; noId alone for a family without a code.
  double diameter;             //!< Of the ring, millimetres.
  bool isInverse;              //!< White on black.
  std::optional<Sheet> sheet;  //!< Nothing: just the square of marker and quiet zone.
  unsigned int markersPerPage; //!< At least 1.
  double dotsPerInch;
  std::string output; //!< As given; several pages as SVG or PNG get names of their own, see pageFile().
  Format format;
};

using Request = tutorial::RequestFor<Order>;

/*! \exception UsageError : If the arguments are wrong. */
Request parseCommandLine(int argc, const char *const argv[]);

/*!
  Reads a list of ids: "5", "0-9", "1,4,7", "0-3,8".
  \exception UsageError : If it is no such list, or names an id twice.
*/
std::vector<int> parseIds(const std::string &list);

/*!
  The name of the file of one page among several: "markers.png" becomes "markers-5.png", or "markers-5-8.png" if the
  page holds more than one id.
*/
std::string pageFile(const std::string &output, int firstId, int lastId);
} // namespace create

#endif
