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
 * What is photographed: a plane with points whose places are known.
 */

#include "target.h"

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include <nlohmann/json.hpp>

namespace calibrate {
namespace {
TargetPoint pointOf(const nlohmann::json &line, vpCircleMarkerFamily &family)
{
  family = vpCircleMarkerFamily::fromName(line.at("family").get<std::string>());
  if (!family.isCoded()) {
    throw std::runtime_error("the family " + family.getName() +
                             " has no ids; print golay23 markers, or use --target circles");
  }
  if (line.value("inverse", false)) {
    throw std::runtime_error("the sheet is white on black; make one without --inverse");
  }
  TargetPoint point;
  point.place = Eigen::Vector2d(line.at("center_m").at(0).get<double>(), line.at("center_m").at(1).get<double>());
  point.radius = 0.5 * line.at("size_m").get<double>();
  point.id = line.at("id").get<int>();
  family.getCodeword(point.id); // throws and says which ids exist
  if (!(point.radius > 0.)) {
    throw std::runtime_error("\"size_m\" must be positive");
  }
  return point;
}

void add(const TargetPoint &point, Target &target)
{
  for (const TargetPoint &other : target.points) {
    if (other.id == point.id) {
      throw std::runtime_error("the marker " + std::to_string(point.id) + " is there twice");
    }
    if ((other.place - point.place).norm() < other.radius + point.radius) {
      throw std::runtime_error("the markers " + std::to_string(other.id) + " and " + std::to_string(point.id) +
                               " overlap; give the lines of one page alone");
    }
  }
  target.points.push_back(point);
}
} // namespace

std::string Target::name() const
{
  switch (kind) {
  case TargetKind::Chessboard:
    return "chessboard";
  case TargetKind::Grid:
    return "circles";
  case TargetKind::Asymmetric:
    return "asymmetric";
  default:
    return "markers";
  }
}

Target makeGrid(TargetKind kind, int columns, int rows, double spacing, double diameter)
{
  Target target;
  target.kind = kind;
  target.columns = columns;
  target.rows = rows;
  target.family = vpCircleMarkerFamily::DISC;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      TargetPoint point;
      const double x = kind == TargetKind::Asymmetric ? 2 * column + row % 2 : column;
      point.place = spacing * Eigen::Vector2d(x, row);
      point.radius = kind == TargetKind::Chessboard ? 0. : 0.5 * diameter;
      target.points.push_back(point);
    }
  }
  return target;
}

Target readSheet(const std::string &file)
{
  std::ifstream in(file);
  if (!in) {
    throw std::runtime_error("the sheet \"" + file +
                             "\" cannot be read; save what circle-marker-create wrote to its "
                             "standard output and name that file");
  }
  Target target;
  target.kind = TargetKind::Markers;
  std::string text;
  for (int number = 1; std::getline(in, text); ++number) {
    if (text.find_first_not_of(" \t\r") == std::string::npos) {
      continue;
    }
    try {
      vpCircleMarkerFamily family;
      const TargetPoint point = pointOf(nlohmann::json::parse(text), family);
      if (!target.points.empty() && family.getName() != target.family.getName()) {
        throw std::runtime_error("another family than that of the lines before; a sheet has one");
      }
      target.family = family;
      add(point, target);
    }
    catch (const std::exception &e) {
      throw std::runtime_error("the sheet \"" + file + "\", line " + std::to_string(number) + ": " + e.what());
    }
  }
  if (target.points.size() < 4) {
    throw std::runtime_error("the sheet \"" + file + "\" has " + std::to_string(target.points.size()) +
                             " markers; at least 4 are needed, print them with --per-sheet auto");
  }
  return target;
}
} // namespace calibrate
