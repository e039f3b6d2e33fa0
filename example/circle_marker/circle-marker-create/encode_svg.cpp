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
 * Pictures as SVG files.
 */

#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>

#include "encode.h"

namespace create {
namespace {
const double halfTurn = std::acos(-1.);

/*! Writes shapes as SVG elements; the unit of the coordinates is the millimetre. */
struct Writer
{
  std::ostream &out;

  void point(const char *command, const AnnularSector &sector, double radius, double angle) const
  {
    out << command << sector.x + radius * std::cos(angle) << " " << sector.y + radius * std::sin(angle);
  }

  /*! An arc to an angle; SVG's flags: shorter or longer way, then clockwise or not. */
  void arc(const AnnularSector &sector, double radius, double angle, double sweep) const
  {
    out << " A" << radius << " " << radius << " 0 " << (std::abs(sweep) > halfTurn ? 1 : 0)
        << (sweep > 0 ? " 1" : " 0");
    point(" ", sector, radius, angle);
  }

  void operator()(const AnnularSector &sector) const
  {
    if (sector.sweep > 2 * halfTurn - 1e-9) {
      // A ring is a stroked circle, a disc is one as well.
      const double thickness = sector.outer - sector.inner;
      out << "<circle cx=\"" << sector.x << "\" cy=\"" << sector.y << "\" ";
      if (sector.inner > 0) {
        out << "r=\"" << (sector.outer + sector.inner) / 2 << "\" fill=\"none\" stroke=\"black\" stroke-width=\""
            << thickness << "\"/>\n";
      }
      else {
        out << "r=\"" << sector.outer << "\"/>\n";
      }
      return;
    }
    out << "<path d=\"";
    trace(sector);
    out << "\"/>\n";
  }

  void operator()(const PiercedSquare &square) const
  {
    out << "<path fill-rule=\"evenodd\" d=\"M" << square.left << " " << square.top << " h" << square.side << " v"
        << square.side << " h" << -square.side << " Z";
    for (const AnnularSector &hole : square.holes) {
      if (hole.sweep > 2 * halfTurn - 1e-9) {
        circle(hole, hole.outer);
        if (hole.inner > 0) {
          circle(hole, hole.inner);
        }
      }
      else {
        out << " ";
        trace(hole);
      }
    }
    out << "\"/>\n";
  }

  /*! A whole circle as two halves: an arc of SVG that ends where it begins is none. */
  void circle(const AnnularSector &sector, double radius) const
  {
    point(" M", sector, radius, 0);
    arc(sector, radius, halfTurn, halfTurn);
    arc(sector, radius, 2 * halfTurn, halfTurn);
    out << " Z";
  }

  /*! The border of a sector that is no whole ring. */
  void trace(const AnnularSector &sector) const
  {
    const double end = sector.start + sector.sweep;
    point("M", sector, sector.outer, sector.start);
    arc(sector, sector.outer, end, sector.sweep);
    point(" L", sector, sector.inner, end);
    if (sector.inner > 0) {
      arc(sector, sector.inner, sector.start, -sector.sweep);
    }
    out << " Z";
  }

  void operator()(const Line &line) const
  {
    out << "<line x1=\"" << line.x1 << "\" y1=\"" << line.y1 << "\" x2=\"" << line.x2 << "\" y2=\"" << line.y2
        << "\" stroke=\"black\" stroke-width=\"" << line.thickness << "\"/>\n";
  }

  void operator()(const Text &text) const
  {
    out << "<text x=\"" << text.x << "\" y=\"" << text.y << "\" font-size=\"" << text.height
        << "\" font-family=\"sans-serif\" text-anchor=\"middle\" xml:space=\"preserve\">" << text.text << "</text>\n";
  }
};
} // namespace

std::string encodeSvg(const Picture &picture)
{
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out << std::setprecision(8); // A micrometre in 100 metres: what is lost is far below any print.
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << picture.width << "mm\" height=\"" << picture.height
      << "mm\" viewBox=\"0 0 " << picture.width << " " << picture.height << "\">\n"
      << "<title>" << picture.title << "</title>\n"
      << "<rect width=\"" << picture.width << "\" height=\"" << picture.height << "\" fill=\"white\"/>\n";
  for (const Shape &shape : picture.shapes) {
    std::visit(Writer{out}, shape);
  }
  out << "</svg>\n";
  return out.str();
}
} // namespace create
