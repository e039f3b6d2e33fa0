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
 * What happens on the simulated bus.
 */

#include "scenario.h"

#include <cstdlib>
#include <fstream>
#include <mutex>

#include <nlohmann/json.hpp>

namespace simulated_bus {
namespace {
using Json = nlohmann::json;

vpHomogeneousMatrix matrixOf(const Json &elements)
{
  vpHomogeneousMatrix matrix;
  for (unsigned int i = 0; i < 16; ++i) {
    matrix[i / 4][i % 4] = elements.at(i).get<double>();
  }
  return matrix;
}

std::optional<long> numberOf(const Json &json, const char *name)
{
  return json.contains(name) ? std::optional<long>(json[name].get<long>()) : std::nullopt;
}

Scenario read()
{
  Scenario result;
  const char *path = std::getenv("CIRCLE_MARKER_SIMULATED_BUS");
  if (path == nullptr) {
    return result;
  }
  std::ifstream file(path);
  const Json json = Json::parse(file);
  const auto frames = [&json](const char *name) { return json.value(name, std::set<long>()); };
  result.libraryFails = json.value("library_fails", false);
  result.listFails = json.value("list_fails", false);
  result.openFails = json.value("open_fails", false);
  result.setupFails = json.value("setup_fails", false);
  result.isUsb = json.value("usb", false);
  result.isSameNoise = json.value("same_noise", false);
  result.isRealTime = json.value("real_time", false);
  for (const Json &camera : json.value("cameras", Json::array())) {
    result.cameras.push_back(CameraEntry{camera["guid"], camera["vendor"], camera["model"]});
  }
  result.unplugAt = numberOf(json, "unplug_at");
  result.silentAt = numberOf(json, "silent_at");
  result.corrupt = frames("corrupt");
  result.truncated = frames("truncated");
  result.undeliverable = frames("undeliverable");
  result.afterGap = frames("after_gap");
  result.focalLength = json.value("focal_length", result.focalLength);
  result.family = json.value("family", result.family);
  result.id = json.value("id", result.id);
  result.size = json.value("size", result.size);
  for (const Json &marker : json.value("sheet", Json::array())) {
    const Json &center = marker.at("center_m");
    result.sheet.push_back(SheetMarker{marker.at("id"), marker.at("size_m"), center.at(0), center.at(1)});
  }
  for (const Json &pose : json.value("poses", Json::array())) {
    result.poses.push_back(matrixOf(pose));
  }
  result.poseFile = json.value("pose_file", "");
  result.log = json.value("log", "");
  return result;
}
} // namespace

const Scenario &scenario()
{
  static const Scenario *const result = new Scenario(read());
  return *result;
}

void log(const std::string &line)
{
  static auto *const mutex = new std::mutex;
  const std::lock_guard<std::mutex> lock(*mutex);
  if (!scenario().log.empty()) {
    std::ofstream(scenario().log, std::ios::app) << line << std::endl;
  }
}
} // namespace simulated_bus
