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
 * What circle-marker-bound tells: tables for people, CSV and JSON for programs.
 */

#include <cmath>
#include <cstdio>
#include <iomanip>
#include <sstream>

#include <nlohmann/json.hpp>
#include <visp3/core/vpMath.h>

#include "common/numbers.h"
#include "report.h"

namespace planner {
namespace {
using nlohmann::ordered_json;

constexpr double millimetres = 1000.; // In a metre.

/*! Two or three digits of a number that may be very small. */
std::string shortNumber(double value)
{
  char text[64];
  std::snprintf(text, sizeof(text), value != 0. && std::fabs(value) < 0.01 ? "%.1e" : "%.3g", value);
  return text;
}

std::string conditions(const Settings &settings)
{
  std::ostringstream out;
  out << settings.family;
  if (settings.family == "ring") {
    out << " (ratio " << settings.ratio << ")";
  }
  else if (settings.family != "disc") {
    out << " id " << settings.id;
  }
  out << " of " << millimetres * settings.size << " mm; " << settings.width << " x " << settings.height << " pixels, f "
      << settings.camera.get_px() << " px; contrast " << settings.photometry.paper - settings.photometry.ink
      << ", noise " << settings.photometry.noiseSigma << " grey levels and rounding, blur "
      << settings.photometry.blurSigma << " px; "
      << (settings.surround == vpMarkerPoseBound::WHITE_SURROUND ? "white paper all around"
                                                                 : "beyond a quiet zone of R/6 anything");
  return out.str();
}

ordered_json number(double value)
{
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json number(const std::optional<double> &value, double scale = 1.)
{
  return value ? number(scale * *value) : ordered_json(nullptr);
}

ordered_json jsonOf(const Row &row)
{
  const auto &separation = row.separation;
  return {{"angle_deg", row.angle},
          {"distance_m", row.distance},
          {"diameter_px", number(row.diameter)},
          {"minor_axis_px", number(row.minor)},
          {"in_image", row.isInImage},
          {"x_mm", number(millimetres * row.bound.x)},
          {"y_mm", number(millimetres * row.bound.y)},
          {"z_mm", number(millimetres * row.bound.z)},
          {"normal_deg", number(vpMath::deg(row.bound.normal))},
          {"spin_deg", row.bound.dof == 6 ? number(vpMath::deg(row.bound.spin)) : ordered_json(nullptr)},
          {"separation", separation ? number(separation->separation) : ordered_json(nullptr)},
          {"wrong_choice", separation ? number(separation->wrongChoice) : ordered_json(nullptr)}};
}

ordered_json jsonOf(const Settings &settings)
{
  const Wanted &wanted = settings.wanted;
  return {{"camera",
           {{"width", settings.width},
            {"height", settings.height},
            {"px", settings.camera.get_px()},
            {"py", settings.camera.get_py()},
            {"u0", settings.camera.get_u0()},
            {"v0", settings.camera.get_v0()}}},
          {"family", settings.family},
          {"id", settings.id},
          {"size_m", settings.size},
          {"surround", settings.surround == vpMarkerPoseBound::WHITE_SURROUND ? "white" : "unknown"},
          {"contrast", settings.photometry.paper - settings.photometry.ink},
          {"noise", settings.photometry.noiseSigma},
          {"noise_with_rounding", noiseWithRounding(settings.photometry.noiseSigma)},
          {"blur_px", settings.photometry.blurSigma},
          {"defocus_px", settings.photometry.defocusRadius},
          {"wanted",
           {{"xy_mm", number(wanted.xy, millimetres)},
            {"z_mm", number(wanted.z, millimetres)},
            {"normal_deg", number(wanted.normal, vpMath::deg(1.))},
            {"wrong_choice", number(wanted.wrong)},
            {"reserve", settings.reserve}}}};
}
} // namespace

std::string tableOf(const Settings &settings, const std::vector<Row> &rows)
{
  std::ostringstream out;
  out << "Least errors (standard deviations) of " << conditions(settings) << ".\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row &row = rows[i];
    if (i == 0 || rows[i - 1].angle != row.angle) {
      out << "\nangle " << row.angle << " deg\n"
          << "   distance  diameter         x         y         z    normal  separation    wrong\n"
          << "          m    pixels        mm        mm        mm       deg       sigma        %\n";
    }
    out << std::setw(11) << digits(row.distance) << std::setw(10) << digits(row.diameter) << std::setw(10)
        << shortNumber(millimetres * row.bound.x) << std::setw(10) << shortNumber(millimetres * row.bound.y)
        << std::setw(10) << shortNumber(millimetres * row.bound.z) << std::setw(10)
        << shortNumber(vpMath::deg(row.bound.normal));
    if (row.separation) {
      constexpr double certain = 1e-9; // Less is "never" to a user.
      const double wrong = row.separation->wrongChoice;
      out << std::setw(12) << digits(row.separation->separation) << std::setw(9)
          << (wrong < certain ? std::string("0") : shortNumber(100. * wrong));
    }
    else {
      out << std::setw(12) << "-" << std::setw(9) << "-";
    }
    out << (row.isInImage ? "" : "  (off)") << (settings.wanted.any() && !isEnough(row, settings) ? "  -" : "") << '\n';
  }
  if (settings.wanted.any()) {
    out << "A dash at the end: not the wanted accuracy.\n";
  }
  return out.str();
}

std::string answerOf(const Settings &settings, const std::vector<Reach> &reaches)
{
  std::ostringstream out;
  for (const Reach &reach : reaches) {
    out << "At " << reach.angle << " deg: ";
    if (reach.distance) {
      out << "a marker of " << millimetres * settings.size << " mm keeps the wanted accuracy up to "
          << digits(*reach.distance) << " m (" << digits(*reach.pixels) << " pixels)";
    }
    else {
      out << "a marker of " << millimetres * settings.size << " mm does not keep the wanted accuracy at "
          << settings.minDistance << " m";
    }
    const double distance = settings.sizeFor.value_or(settings.maxDistance);
    if (reach.size) {
      out << "; for " << distance << " m it takes at least " << digits(millimetres * *reach.size) << " mm";
    }
    else {
      out << "; at " << distance << " m no marker up to half the image's width does";
    }
    out << ".\n";
  }
  return out.str();
}

std::string csvOf(const std::vector<Row> &rows)
{
  std::ostringstream out;
  out << "angle_deg,distance_m,diameter_px,minor_axis_px,in_image,x_mm,y_mm,z_mm,normal_deg,spin_deg,separation,"
         "wrong_choice\n"
      << std::setprecision(9);
  for (const Row &row : rows) {
    out << row.angle << ',' << row.distance << ',' << row.diameter << ',' << row.minor << ',' << row.isInImage << ','
        << millimetres * row.bound.x << ',' << millimetres * row.bound.y << ',' << millimetres * row.bound.z << ','
        << vpMath::deg(row.bound.normal) << ',';
    if (row.bound.dof == 6) {
      out << vpMath::deg(row.bound.spin);
    }
    out << ',';
    if (row.separation) {
      out << row.separation->separation << ',' << row.separation->wrongChoice;
    }
    else {
      out << ',';
    }
    out << '\n';
  }
  return out.str();
}

std::string jsonOf(const Settings &settings, const std::vector<Row> &rows, const std::vector<Reach> &reaches)
{
  ordered_json result;
  result["settings"] = jsonOf(settings);
  result["rows"] = ordered_json::array();
  for (const Row &row : rows) {
    result["rows"].push_back(jsonOf(row));
  }
  result["reaches"] = ordered_json::array();
  for (const Reach &reach : reaches) {
    result["reaches"].push_back({{"angle_deg", reach.angle},
                                 {"farthest_m", number(reach.distance)},
                                 {"farthest_px", number(reach.pixels)},
                                 {"size_for_m", settings.sizeFor.value_or(settings.maxDistance)},
                                 {"least_size_m", number(reach.size)}});
  }
  return result.dump(2) + "\n";
}
} // namespace planner
