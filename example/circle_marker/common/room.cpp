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
 * A room with markers on its walls.
 */

#include "room.h"

#include <cmath>
#include <set>
#include <sstream>

#include <visp3/core/vpException.h>
#include <visp3/core/vpThetaUVector.h>

#include "footprint.h"

namespace common {
namespace {
/*! A marker's place on the walls, and what people call it. */
struct Place
{
  const char *name;
  double x, z;
  double direction; // In which someone looks who stands in front of it, degrees.
};

constexpr double degree = M_PI / 180.;
constexpr double standOff = 1.2; // Metres from the wall to where a robot reads a marker.

/*! A task: the place in front of a marker. */
std::string taskTo(const Place &place)
{
  const double direction = place.direction * degree;
  const auto rounded = [](double value) { return std::round(1e3 * value) / 1e3 + 0.; }; // no negative zero
  std::ostringstream text;
  text << "{\"task\":\"go\",\"to\":[" << rounded(place.x - standOff * std::sin(direction)) << ","
       << rounded(place.z - standOff * std::cos(direction)) << "],\"look_deg\":" << place.direction << "}";
  return text.str();
}

/*! Whether the camera's model has an image of the whole sheet: beyond where a lens folds over there is none. */
bool isWithinLens(const vpHomogeneousMatrix &cMo, double size, const vpMarkerSceneSimulator &scene)
{
  constexpr double half = 0.6; // of a sheet with its quiet zone, by the ring's size
  try {
    for (const double x : {-half * size, 0., half * size}) {
      for (const double y : {-half * size, 0., half * size}) {
        const vpColVector point = cMo * vpColVector(std::vector<double>{x, y, 0., 1.});
        scene.project(point[0], point[1], point[2]);
      }
    }
  }
  catch (const vpException &) {
    return false;
  }
  return true;
}
} // namespace

vpHomogeneousMatrix lookingAlong(double x, double y, double z, double direction)
{
  return vpHomogeneousMatrix(vpTranslationVector(x, y, z), vpThetaUVector(0., direction, 0.));
}

Room makeRoom()
{
  Room room;
  const double w = room.halfWidth, d = room.depth;
  const std::vector<Place> places{{"shelf", -2., d, 0.},    {"window", 0., d, 0.},    {"desk", 2., d, 0.},
                                  {"charger", w, 3.6, 90.}, {"lift", w, 1.2, 90.},    {"door", 2., 0., 180.},
                                  {"sink", 0., 0., 180.},   {"plant", -2., 0., 180.}, {"board", -w, 1.2, -90.},
                                  {"copier", -w, 3.6, -90.}};
  // To and fro through the room, from one marker to the next.
  const std::vector<std::size_t> tour{1, 4, 9, 6, 2, 8, 3, 7, 0, 5};
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Place &place = places[i];
    vpCircleMarkerEntry entry;
    entry.id = static_cast<int>(i);
    entry.size = defaultRing;
    entry.name = place.name;
    entry.isPayloadJson = true;
    entry.payload = "{\"task\":\"stop\"}";
    for (std::size_t k = 0; k + 1 < tour.size(); ++k) {
      if (tour[k] == i) {
        entry.payload = taskTo(places[tour[k + 1]]);
      }
    }
    // Not all at one height, as people would hang them.
    const double height = 0.15 * std::sin(2.4 * static_cast<double>(i));
    entry.wMo = lookingAlong(place.x, height, place.z, place.direction * degree);
    room.markers.add(entry);
  }
  return room;
}

Room readRoom(const std::string &file)
{
  Room room;
  room.markers.load(file);
  for (const vpCircleMarkerEntry &entry : room.markers.getEntries()) {
    if (entry.wMo) {
      return room;
    }
  }
  throw vpException(vpException::badValue, "no marker of \"%s\" has a pose; add \"pose\" to those on the walls",
                    file.c_str());
}

std::vector<vpCircleMarkerFamily> familiesOf(const Room &room)
{
  std::vector<vpCircleMarkerFamily> families;
  std::set<std::string> names;
  for (const vpCircleMarkerEntry &entry : room.markers.getEntries()) {
    const bool isNew = names.insert(entry.family.getName()).second;
    const bool isFirst = entry.family.getType() == vpCircleMarkerFamily::BCH31R;
    if (isNew) {
      families.insert(isFirst ? families.begin() : families.end(), entry.family);
    }
  }
  return families;
}

void addMarkers(const Room &room, const vpHomogeneousMatrix &wMc, vpMarkerSceneSimulator &scene)
{
  const vpHomogeneousMatrix cMw = wMc.inverse();
  for (const vpCircleMarkerEntry &entry : room.markers.getEntries()) {
    if (!entry.wMo) {
      continue;
    }
    const vpHomogeneousMatrix cMo = cMw * *entry.wMo;
    // Nearer than its own size a marker is larger than the image, or partly behind the camera.
    const bool isFront = cMo[2][3] > entry.size && cMo[2][3] > 0.2 * std::abs(cMo[0][3]);
    if (!isFront || !isWithinLens(cMo, entry.size, scene)) {
      continue;
    }
    const std::string family = entry.family.getName();
    const double ratio = entry.family.getLayout().ringInner;
    vpSimulatedMarker marker = family == "disc"   ? vpSimulatedMarker::disc(entry.size)
                               : family == "ring" ? vpSimulatedMarker::ring(entry.size, ratio)
                                                  : vpSimulatedMarker::circle(family, entry.id, entry.size);
    scene.addMarker(marker.setPose(cMo));
  }
}

std::vector<std::array<std::array<double, 3>, 2>> edgesOf(const Room &room)
{
  const double x[2] = {-room.halfWidth, room.halfWidth};
  const double y[2] = {room.ceiling, room.floor};
  const double z[2] = {0., room.depth};
  std::vector<std::array<std::array<double, 3>, 2>> edges;
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      edges.push_back({{{x[0], y[i], z[j]}, {x[1], y[i], z[j]}}});
      edges.push_back({{{x[i], y[0], z[j]}, {x[i], y[1], z[j]}}});
      edges.push_back({{{x[i], y[j], z[0]}, {x[i], y[j], z[1]}}});
    }
  }
  return edges;
}
} // namespace common
