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
 * The picture with what was found, what is true, and the room's edges.
 */

#include "picture.h"

#include <cmath>
#include <iomanip>
#include <sstream>

#include <nlohmann/json.hpp>

#include "circle_marker/common/detection/marker_overlay.h"
#include "circle_marker/common/draw.h"

namespace simulator {
namespace {
constexpr double degree = M_PI / 180.;

/*! The room's edges in pieces, so that those behind the camera are left out. */
void drawEdges(vpImage<vpRGBa> &picture, const World &world, const vpHomogeneousMatrix &wMc)
{
  constexpr int pieces = 60; // 10 cm of the longest edge
  const vpHomogeneousMatrix cMw = wMc.inverse();
  for (const auto &edge : common::edgesOf(world.room())) {
    std::vector<vpImagePoint> before;
    for (int i = 0; i <= pieces; ++i) {
      double X[3], C[3];
      for (unsigned int k = 0; k < 3; ++k) {
        X[k] = edge[0][k] + (edge[1][k] - edge[0][k]) * i / pieces;
      }
      for (unsigned int k = 0; k < 3; ++k) {
        C[k] = cMw[k][0] * X[0] + cMw[k][1] * X[1] + cMw[k][2] * X[2] + cMw[k][3];
      }
      constexpr double nearest = 0.2; // metres
      std::vector<vpImagePoint> here;
      if (C[2] > nearest) {
        here.push_back(tutorial::imageOf(C[0], C[1], C[2], vpHomogeneousMatrix(), world.camera()));
      }
      if (!before.empty() && !here.empty()) {
        tutorial::drawPath(picture, {before.front(), here.front()}, vpColor(150, 190, 240), 1, false);
      }
      before = here;
    }
  }
}

std::string stateLine(const Controls &controls)
{
  const Knobs &k = controls.knobs;
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << "noise " << k.noise << "  blur " << k.blur << "  light " << k.light
       << "  gradient " << k.gradient << "  cover " << 10 * k.cover << " %  step " << std::setprecision(3)
       << controls.step << (controls.isServoing ? "  SERVO" : "");
  return text.str();
}

std::string errorLine(const Comparison &marker)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(2) << marker.id << " " << marker.name << ": " << marker.distance << " m "
       << std::setprecision(0) << marker.tilt / degree << " deg: ";
  if (marker.error) {
    text << std::setprecision(2) << "error " << 1e3 * *marker.error << " mm, " << std::setprecision(3)
         << marker.normalError / degree << " deg (" << std::setprecision(1) << marker.sigmas << " sigma)";
  }
  else {
    text << (marker.isWhole ? "not found" : "not found, a part of it is not seen");
  }
  return text.str();
}
} // namespace

vpImage<vpRGBa> pictureOf(const World &world, const Shot &shot, const Controls &controls)
{
  vpImage<vpRGBa> picture = tutorial::markerOverlay(shot.image, shot.detections, world.camera());
  drawEdges(picture, world, controls.wMc);
  const double lineHeight = picture.getWidth() > 1000 ? 28. : 20.; // pixels; see drawText
  double v = picture.getHeight() - 6. - lineHeight;
  tutorial::drawText(picture, stateLine(controls), vpImagePoint(v, 10.), vpColor::white);
  if (shot.phantoms > 0) {
    v -= lineHeight;
    tutorial::drawText(picture, std::to_string(shot.phantoms) + " found that are not there", vpImagePoint(v, 10.),
                       vpColor::red);
  }
  constexpr std::size_t mostLines = 5;
  for (std::size_t i = std::min(mostLines, shot.markers.size()); i > 0; --i) {
    v -= lineHeight;
    tutorial::drawText(picture, errorLine(shot.markers[i - 1]), vpImagePoint(v, 10.),
                       shot.markers[i - 1].error ? vpColor::green : vpColor::orange);
  }
  v = 50.;
  for (const std::string &line : controls.showsHelp ? keyHelp() : std::vector<std::string>()) {
    tutorial::drawText(picture, line, vpImagePoint(v, 10.), vpColor::white);
    v += lineHeight;
  }
  return picture;
}

std::string jsonLineOf(const Shot &shot, const Controls &controls, unsigned long number)
{
  nlohmann::json json{{"image", number},
                      {"wMc", std::vector<double>(controls.wMc.data, controls.wMc.data + 16)},
                      {"noise", controls.knobs.noise},
                      {"blur_pixels", controls.knobs.blur},
                      {"light", controls.knobs.light},
                      {"gradient", controls.knobs.gradient},
                      {"covered", 0.1 * controls.knobs.cover},
                      {"servo", controls.isServoing},
                      {"phantoms", shot.phantoms},
                      {"markers", nlohmann::json::array()}};
  for (const Comparison &marker : shot.markers) {
    nlohmann::json entry{{"id", marker.id},         {"name", marker.name},     {"distance_m", marker.distance},
                         {"tilt_rad", marker.tilt}, {"whole", marker.isWhole}, {"error_m", nullptr}};
    if (marker.error) {
      entry["error_m"] = *marker.error;
      entry["normal_error_rad"] = marker.normalError;
      entry["error_in_sigmas"] = marker.sigmas;
    }
    json["markers"].push_back(entry);
  }
  return json.dump();
}
} // namespace simulator
