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
 * The room from above with a robot's way.
 */

#include <cmath>
#include <sstream>

#include "common/numbers.h"
#include "report.h"

namespace navigation {
namespace {
constexpr double scale = 140.; // Units of the SVG to a metre.
constexpr double margin = 100.;

/*! World to picture: x to the right, z up. */
class Map
{
public:
  explicit Map(const common::Room &room) : m_room(room) {}

  double u(double x) const { return margin + scale * (x + m_room.halfWidth); }
  double v(double z) const { return margin + scale * (m_room.depth - z); }
  double width() const { return 2. * margin + 2. * scale * m_room.halfWidth; }
  double height() const { return 2. * margin + scale * m_room.depth + 60.; }

private:
  const common::Room &m_room; //!< What is drawn.
};

void addPath(std::ostream &out, const Map &map, const Journey &journey, FloorPose Step::*pose,
             const std::string &attributes)
{
  out << "<polyline fill=\"none\" " << attributes << " points=\"";
  for (const Step &step : journey.steps) {
    out << map.u((step.*pose).x) << "," << map.v((step.*pose).z) << " ";
  }
  out << "\"/>\n";
}

void addMarkers(std::ostream &out, const Map &map, const common::Room &room)
{
  for (const vpCircleMarkerEntry &entry : room.markers.getEntries()) {
    if (!entry.wMo) {
      continue;
    }
    const vpHomogeneousMatrix &M = *entry.wMo;
    const double u = map.u(M[0][3]), v = map.v(M[2][3]);
    // Along the marker's x axis, three times as long as it is; the name outside of the room.
    const double du = 1.5 * scale * entry.size * M[0][0], dv = -1.5 * scale * entry.size * M[2][0];
    out << "<line x1=\"" << u - du << "\" y1=\"" << v - dv << "\" x2=\"" << u + du << "\" y2=\"" << v + dv
        << "\" stroke=\"black\" stroke-width=\"7\"/>\n"
        << "<text x=\"" << u + 26. * M[0][2] << "\" y=\"" << v - 26. * M[2][2] + 5. << "\" text-anchor=\""
        << (std::abs(M[0][2]) < 0.5 ? "middle" : (M[0][2] > 0. ? "start" : "end")) << "\">"
        << (entry.name.empty() ? std::to_string(entry.id) : entry.name) << "</text>\n";
  }
}

void addStations(std::ostream &out, const Map &map, const Journey &journey)
{
  for (std::size_t i = 0; i < journey.stations.size(); ++i) {
    const FloorPose &p = journey.stations[i].truth;
    const double u = map.u(p.x), v = map.v(p.z);
    out << "<line x1=\"" << u << "\" y1=\"" << v << "\" x2=\"" << u + 22. * std::sin(p.direction) << "\" y2=\""
        << v - 22. * std::cos(p.direction) << "\" stroke=\"#0072b2\" stroke-width=\"3\"/>\n"
        << "<circle cx=\"" << u << "\" cy=\"" << v << "\" r=\"10\" fill=\"white\" stroke=\"#0072b2\"/>\n<text x=\"" << u
        << "\" y=\"" << v + 5. << "\" text-anchor=\"middle\">" << i << "</text>\n";
  }
}
} // namespace

std::string mapOf(const common::Room &room, const Journey &journey)
{
  const Map map(room);
  std::ostringstream out;
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << map.width() << "\" height=\"" << map.height()
      << "\" viewBox=\"0 0 " << map.width() << " " << map.height()
      << "\">\n<style>text{font:14px sans-serif;fill:#222}</style>\n<rect width=\"100%\" height=\"100%\" "
         "fill=\"white\"/>\n"
      << "<rect x=\"" << map.u(-room.halfWidth) << "\" y=\"" << map.v(room.depth) << "\" width=\""
      << 2. * scale * room.halfWidth << "\" height=\"" << scale * room.depth
      << "\" fill=\"#fafafa\" stroke=\"#666\" stroke-width=\"2\"/>\n";
  addMarkers(out, map, room);
  addPath(out, map, journey, &Step::wheels, "stroke=\"#d55e00\" stroke-width=\"1.5\" stroke-dasharray=\"6 4\"");
  addPath(out, map, journey, &Step::truth, "stroke=\"#999\" stroke-width=\"5\"");
  addPath(out, map, journey, &Step::believed, "stroke=\"#0072b2\" stroke-width=\"1.5\"");
  addStations(out, map, journey);
  const double v = map.height() - 40.;
  const struct
  {
    const char *text, *attributes;
  } keys[] = {{"true way", "stroke=\"#999\" stroke-width=\"5\""},
              {"by wheels and markers", "stroke=\"#0072b2\" stroke-width=\"1.5\""},
              {"by the wheels alone", "stroke=\"#d55e00\" stroke-width=\"1.5\" stroke-dasharray=\"6 4\""}};
  double u = margin;
  for (const auto &key : keys) {
    out << "<line x1=\"" << u << "\" y1=\"" << v << "\" x2=\"" << u + 40. << "\" y2=\"" << v << "\" " << key.attributes
        << "/>\n<text x=\"" << u + 50. << "\" y=\"" << v + 5. << "\">" << key.text << "</text>\n";
    u += 230.;
  }
  out << "<line x1=\"" << u << "\" y1=\"" << v << "\" x2=\"" << u + scale << "\" y2=\"" << v
      << "\" stroke=\"black\" stroke-width=\"2\"/>\n<text x=\"" << u + scale + 8. << "\" y=\"" << v + 5.
      << "\">1 m</text>\n</svg>\n";
  return out.str();
}
} // namespace navigation
