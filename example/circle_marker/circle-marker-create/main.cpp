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
 * Makes printable circular markers in true millimetres, as SVG, PDF or PNG.
 */

/*!
  \example circle-marker-create/main.cpp
  Makes printable circular markers in true millimetres, as SVG, PDF or PNG.
*/

#include <algorithm>
#include <cmath>
#include <exception>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "circle_marker/common/program.h"
#include "command_line.h"
#include "encode.h"
#include "page.h"
#include "whole_files.h"

using namespace create;

namespace {
// The most cairo's pictures can have in each direction.
constexpr double mostPixels = 32767;

std::vector<Page> makePages(const Order &order)
{
  std::vector<Page> pages;
  for (std::size_t first = 0; first < order.ids.size(); first += order.markersPerPage) {
    const std::size_t last = std::min<std::size_t>(first + order.markersPerPage, order.ids.size());
    const std::vector<int> ids(order.ids.begin() + static_cast<std::ptrdiff_t>(first),
                               order.ids.begin() + static_cast<std::ptrdiff_t>(last));
    pages.push_back(order.sheet ? sheetPage(order.family, ids, order.diameter, order.isInverse, *order.sheet)
                                : squarePage(order.family, ids.front(), order.diameter, order.isInverse));
  }
  return pages;
}

/*!
  The pixels of a page. A sheet has exactly the density that was asked for, and its last row and column of pixels may
  reach beyond the paper or not quite to its edge. The square alone is covered exactly by whole pixels instead, so that
  its picture can be used as a texture of the stated size.
*/
Raster rasterOf(const Picture &picture, const Order &order)
{
  const double density = order.dotsPerInch / 25.4;
  const double width = std::max(1., std::round(picture.width * density));
  const double height = std::max(1., std::round(picture.height * density));
  if (order.format == Format::Png && (width > mostPixels || height > mostPixels)) {
    std::ostringstream message;
    message << "the picture would have more than " << mostPixels << " pixels in a row or column; use --dpi "
            << std::floor(mostPixels / std::max(picture.width, picture.height) * 25.4) << " or less";
    throw UsageError(message.str());
  }
  return Raster{static_cast<int>(width), static_cast<int>(height), order.sheet ? density : width / picture.width};
}

/*! What was made, one line of JSON a marker; on sheets also where on the page it stands. */
std::string describe(const Order &order, const Page &page, const Raster &raster)
{
  const bool isPng = order.format == Format::Png;
  const double width = isPng ? raster.width / raster.pixelsPerMillimetre : page.picture.width;
  const double height = isPng ? raster.height / raster.pixelsPerMillimetre : page.picture.height;
  std::ostringstream out;
  out << std::setprecision(12);
  for (const PlacedMarker &marker : page.markers) {
    out << "{\"family\": \"" << order.family.getName() << "\", \"id\": " << marker.id
        << ", \"size_m\": " << order.diameter / 1000 << ", \"picture_m\": [" << width / 1000 << ", " << height / 1000
        << "], \"pixels\": [" << raster.width << ", " << raster.height << "]";
    if (order.sheet) {
      out << ", \"center_m\": [" << marker.x / 1000 << ", " << marker.y / 1000 << "]";
    }
    if (order.isInverse) {
      out << ", \"inverse\": true";
    }
    out << "}\n";
  }
  return out.str();
}

/*! Writes all files of an order, and tells what was made. */
std::string carryOut(const Order &order)
{
  const std::vector<Page> pages = makePages(order);
  WholeFiles files;
  std::string description;
  std::vector<Picture> pictures;
  for (const Page &page : pages) {
    const Raster raster = rasterOf(page.picture, order);
    description += describe(order, page, raster);
    if (order.format == Format::Pdf) {
      pictures.push_back(page.picture);
      continue;
    }
    const std::string name =
        pages.size() == 1 ? order.output : pageFile(order.output, page.markers.front().id, page.markers.back().id);
    files.add(name, order.format == Format::Png ? encodePng(page.picture, raster) : encodeSvg(page.picture));
  }
  if (order.format == Format::Pdf) {
    files.add(order.output, encodePdf(pictures));
  }
  files.commit();
  return description;
}
} // namespace

int main(int argc, const char *argv[])
{
  return tutorial::Program("circle-marker-create").run(parseCommandLine, argc, argv, [](const Order &order) {
    std::cout << carryOut(order);
    return 0;
  });
}
