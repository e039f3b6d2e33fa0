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

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <sstream>

#include <visp3/core/vpException.h>

#include "circle_marker/common/parse.h"
#include "command_line.h"

namespace create {
namespace {
constexpr double smallestSize = 0.001;    // Metres; below, no printer draws the sectors of a code.
constexpr double largestSize = 100;       // Metres; above, millimetres must have been meant.
constexpr double mostDotsPerInch = 10000; // Four times the finest film exposure.

/*! The arguments as they were given. */
struct Arguments
{
  std::string family = "golay23";
  std::string ids;
  std::string id;
  double size = 0.18; // The default print: with its quiet zone as wide as a4 paper.
  std::string output;
  std::string sheet = "a4";
  double dotsPerInch = 600; // Usual for laser printers.
  double ratio = 0;
  bool ratioGiven = false;
  std::string perSheet = "1";
  bool isInverse = false;
  bool listFamilies = false;
};

std::string listOfFamilies()
{
  std::ostringstream out;
  out << "family   sectors    ids  distance  ring    code track  quiet zone\n";
  for (const vpCircleMarkerFamily &family : vpCircleMarkerFamily::all()) {
    const vpCircleMarkerLayout &layout = family.getLayout();
    out << std::left << std::setw(9) << family.getName() << std::right << std::fixed << std::setprecision(2);
    if (family.isCoded()) {
      out << std::setw(7) << family.getNbSectors() << std::setw(7) << family.getNbIds() << std::setw(10)
          << family.getMinimumDistance();
    }
    else {
      out << std::setw(7) << "-" << std::setw(7) << "-" << std::setw(10) << "-";
    }
    out << "  " << layout.ringInner << "-1  ";
    if (family.isCoded()) {
      out << layout.codeInner << "-" << layout.codeOuter;
    }
    else {
      out << std::setw(9) << "-";
    }
    out << "  " << std::setprecision(4) << std::setw(10) << layout.quietZone << "\n";
  }
  out << "Radii and quiet zone are in units of the outer radius; the size of a marker is its outer diameter.\n";
  return out.str();
}

Format formatOf(const std::string &output)
{
  std::string extension = std::filesystem::path(output).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  if (extension == ".pdf") {
    return Format::Pdf;
  }
  if (extension == ".png") {
    return Format::Png;
  }
  if (extension == ".svg") {
    return Format::Svg;
  }
  throw UsageError("the name of the output, \"" + output + "\", must end in .svg, .pdf or .png");
}

vpCircleMarkerFamily familyOf(const Arguments &arguments)
{
  const vpCircleMarkerFamily family = vpCircleMarkerFamily::fromName(arguments.family);
  if (!arguments.ratioGiven) {
    return family;
  }
  if (family.getType() != vpCircleMarkerFamily::RING) {
    throw UsageError("--ratio is for the family ring; leave it out or add --family ring");
  }
  return vpCircleMarkerFamily::ring(arguments.ratio);
}

std::vector<int> idsOf(const Arguments &arguments, const vpCircleMarkerFamily &family)
{
  if (!arguments.id.empty() && !arguments.ids.empty()) {
    throw UsageError("--id and --ids exclude each other; use --ids for several markers");
  }
  const std::string &list = arguments.id.empty() ? arguments.ids : arguments.id;
  if (!family.isCoded()) {
    // The detector calls them -1, and 0 is what a script that goes through all families has at hand.
    if (list.empty() || list == "-1" || list == "0") {
      return {noId};
    }
    throw UsageError("the family " + family.getName() + " has no ids; leave --id and --ids out");
  }
  if (list.empty()) {
    throw UsageError("no marker is named; add --id N or --ids 0-9, N up to " + std::to_string(family.getNbIds() - 1) +
                     " in the family " + family.getName());
  }
  const std::vector<int> ids = parseIds(list);
  if (!arguments.id.empty() && ids.size() > 1) {
    throw UsageError("--id takes one id, not \"" + list + "\"; use --ids for several markers");
  }
  for (const int id : ids) {
    family.getCodeword(id); // Throws and says which ids exist.
  }
  return ids;
}

/*! How many markers a page takes, after checking that at least one fits. */
unsigned int markersPerPageOf(const Arguments &arguments, const std::optional<Sheet> &sheet, double side,
                              double largestDiameter)
{
  unsigned int wanted = 0; // As many as fit.
  if (arguments.perSheet != "auto") {
    const std::string &text = arguments.perSheet;
    const bool isNumber = !text.empty() && text.size() < 6 && text.find_first_not_of("0123456789") == std::string::npos;
    wanted = isNumber ? static_cast<unsigned int>(std::stoul(text)) : 0;
    if (wanted == 0) {
      throw UsageError("--per-sheet takes auto or a number from 1, not \"" + text + "\"");
    }
  }
  if (!sheet) {
    if (wanted > 1) {
      throw UsageError("--sheet none holds one marker; leave --per-sheet out or name a sheet");
    }
    return 1;
  }
  const unsigned int fitting = capacity(*sheet, side);
  if (fitting == 0) {
    // Rounded down to 0.1 mm, so that the size that is advised fits.
    const double advised = std::floor(largestDiameter * 10 + 1e-6) / 10;
    std::ostringstream message;
    message << "a marker of " << arguments.size << " m with its quiet zone is " << millimetres(side)
            << " mm wide and does not fit the sheet " << sheet->name << "; the largest size that fits is "
            << advised / 1000 << " m";
    throw UsageError(message.str());
  }
  if (wanted > fitting) {
    throw UsageError(std::to_string(wanted) + " markers of this size do not fit the sheet " + sheet->name +
                     "; use --per-sheet " + std::to_string(fitting) + " or less, or smaller markers");
  }
  return wanted == 0 ? fitting : wanted;
}

Order orderOf(const Arguments &arguments)
{
  if (arguments.output.empty()) {
    throw UsageError("no output is named; add --output FILE.svg, FILE.pdf or FILE.png");
  }
  if (!(arguments.size >= smallestSize && arguments.size <= largestSize)) {
    throw UsageError("--size is the outer diameter of the ring in metres, from 0.001 to 100, for instance 0.18");
  }
  if (!(arguments.dotsPerInch >= 1 && arguments.dotsPerInch <= mostDotsPerInch)) {
    throw UsageError("--dpi is a number of pixels per inch, from 1 to 10000, for instance 600");
  }
  const std::optional<Sheet> sheet = sheetOfName(arguments.sheet);
  if (!sheet && arguments.sheet != "none") {
    throw UsageError("no sheet is named \"" + arguments.sheet + "\"; use a4, a3, letter or none");
  }
  const Format format = formatOf(arguments.output);
  const vpCircleMarkerFamily family = familyOf(arguments);
  const std::vector<int> ids = idsOf(arguments, family);
  const double diameter = arguments.size * 1000;
  const double largest = sheet ? diameterInSquare(family, largestSquare(*sheet)) : diameter;
  const unsigned int perPage = markersPerPageOf(arguments, sheet, squareSide(family, diameter), largest);
  return Order{family,           ids,   diameter, arguments.isInverse, sheet, perPage, arguments.dotsPerInch,
               arguments.output, format};
}
} // namespace

Request parseCommandLine(int argc, const char *const argv[])
{
  Arguments arguments;
  CLI::App app("Makes printable circular markers in true millimetres, as SVG, PDF or PNG.\n"
               "Writes one line of JSON for each marker to the standard output.",
               "circle-marker-create");
  app.add_option("--family", arguments.family, "Family: golay23, bch31, bch31r, ring or disc")->capture_default_str();
  app.add_option("--id", arguments.id, "Marker of a family with a code");
  app.add_option("--ids", arguments.ids,
                 "Several markers: 0-9 or 1,4,7; pages of one PDF, or one SVG or PNG file a page with the ids in the "
                 "name");
  app.add_option("--size", arguments.size, "Outer diameter of the ring, metres")->capture_default_str();
  app.add_option("--output", arguments.output, "File to write: .svg, .pdf or .png");
  app.add_option("--sheet", arguments.sheet,
                 "Paper: a4, a3, letter, or none for just the square of marker and quiet zone")
      ->capture_default_str();
  app.add_option("--per-sheet", arguments.perSheet, "Markers on each sheet: a number, or auto for as many as fit")
      ->capture_default_str();
  app.add_option("--dpi", arguments.dotsPerInch, "Pixels per inch of a PNG")->capture_default_str();
  const CLI::Option *ratio = app.add_option("--ratio", arguments.ratio, "Inner over outer radius of the family ring");
  app.add_flag("--inverse", arguments.isInverse,
               "White on black, for detectors whose polarity is \"white on black\" or \"both\"");
  app.add_flag("--list-families", arguments.listFamilies, "List the families and quit");
  app.footer("\"picture_m\" is the size of the page, metres; \"pixels\" that of the PNG, and for SVG and PDF of a "
             "rendering at --dpi.\nWith --sheet none a PNG covers the square with whole pixels, so its density may "
             "differ from --dpi by half a pixel over the picture.");
  if (!tutorial::parse(app, argc, argv)) {
    return Request{std::nullopt, app.help()};
  }
  if (arguments.listFamilies) {
    return Request{std::nullopt, listOfFamilies()};
  }
  arguments.ratioGiven = ratio->count() > 0;
  try {
    return Request{orderOf(arguments), ""};
  }
  catch (const vpException &e) {
    throw UsageError(e.what());
  }
}
} // namespace create
