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
 * Reads recorded images of a marker at several places.
 */

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include <nlohmann/json.hpp>

#include "recording.h"
#include "run_data.h"

namespace fs = std::filesystem;

namespace experiments {
namespace {
using Json = nlohmann::json;

constexpr const char *linesFile = "poses.jsonl";
constexpr double millimetres = 1e3; // In a metre.

/*! "2m" and "2.5m" are distances; nothing for a slide. */
std::optional<double> distanceFrom(const std::string &name)
{
  std::istringstream in(name);
  double metres = 0.;
  std::string unit, rest;
  const bool isDistance = in >> metres && in >> unit && unit == "m" && !(in >> rest) && metres > 0.;
  if (isDistance) {
    return metres;
  }
  if (name.rfind("slide", 0) == 0) {
    return std::nullopt;
  }
  throw DataError("the station \"" + name +
                  "\" is named neither after its distance, such as 2m or 2.5m, nor slide; rename its folder");
}

std::vector<Json> linesOf(const fs::path &file)
{
  std::vector<Json> lines;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    try {
      lines.push_back(Json::parse(line));
    }
    catch (const Json::exception &) {
      throw DataError("line " + std::to_string(lines.size() + 1) + " of \"" + file.string() +
                      "\" is not JSON; make it again with tutorial-circle-marker-detector --json");
    }
  }
  return lines;
}

/*!
  Covariance of the marker's centre from that of delta with cMo_true = exp(delta) cMo: a point p moves by
  upsilon + omega x p, so J = [1, -[p]x].
*/
Square covarianceOfCentre(const std::vector<double> &delta, const Triple &p)
{
  const std::array<std::array<double, 6>, 3> J = {
      {{1., 0., 0., 0., p[2], -p[1]}, {0., 1., 0., -p[2], 0., p[0]}, {0., 0., 1., p[1], -p[0], 0.}}};
  Square result = {};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 6; ++k) {
        for (std::size_t l = 0; l < 6; ++l) {
          result[i][j] += J[i][k] * delta.at(6 * k + l) * J[j][l];
        }
      }
    }
  }
  return result;
}

Sight sightOf(const Json &marker)
{
  const auto cMo = marker.at("cMo").get<std::vector<double>>();
  const Triple centre = {cMo.at(3), cMo.at(7), cMo.at(11)}; // metres
  Sight sight;
  sight.covariance = covarianceOfCentre(marker.at("covariance").get<std::vector<double>>(), centre);
  for (std::size_t i = 0; i < 3; ++i) {
    sight.centre[i] = millimetres * centre[i];
    sight.normal[i] = -cMo.at(4 * i + 2); // z points into the marker
    for (double &element : sight.covariance[i]) {
      element *= millimetres * millimetres;
    }
  }
  return sight;
}

using LinesOfStations = std::vector<std::pair<Station, std::vector<Json>>>;

LinesOfStations readStations(const std::string &folder)
{
  LinesOfStations stations;
  std::error_code error;
  for (const fs::directory_entry &entry : fs::directory_iterator(folder, error)) {
    if (fs::exists(entry.path() / linesFile)) {
      Station station;
      station.name = entry.path().filename().string();
      station.distance = distanceFrom(station.name);
      stations.emplace_back(station, linesOf(entry.path() / linesFile));
    }
  }
  if (stations.empty()) {
    throw DataError("\"" + folder + "\" holds no recording: it takes a folder such as 2m with a file " + linesFile +
                    "; doc/experiments/experiment-1.md tells how to record");
  }
  std::sort(stations.begin(), stations.end(), [](const auto &a, const auto &b) {
    return std::make_pair(a.first.distance.value_or(HUGE_VAL), a.first.name) <
           std::make_pair(b.first.distance.value_or(HUGE_VAL), b.first.name);
  });
  return stations;
}

/*! The id that is found in most images. */
std::optional<int> commonestId(const LinesOfStations &stations)
{
  std::map<int, std::size_t> counts;
  for (const auto &station : stations) {
    for (const Json &line : station.second) {
      for (const Json &marker : line.at("markers")) {
        ++counts[marker.at("id").get<int>()];
      }
    }
  }
  const auto most =
      std::max_element(counts.begin(), counts.end(), [](const auto &a, const auto &b) { return a.second < b.second; });
  return most == counts.end() ? std::nullopt : std::optional<int>(most->first);
}

Picture pictureOf(const Json &line, Recording &recording)
{
  Picture picture;
  picture.cpuTime = line.at("cpu_ms").get<double>();
  picture.markers = line.at("markers").size();
  for (const Json &marker : line.at("markers")) {
    if (!picture.sight && marker.at("id").get<int>() == recording.id) {
      picture.sight = sightOf(marker);
      recording.family = marker.at("family").get<std::string>();
      recording.size = marker.at("size_m").get<double>();
    }
  }
  return picture;
}
} // namespace

Recording recordingIn(const std::string &folder, std::optional<int> id)
{
  const LinesOfStations stations = readStations(folder);
  Recording recording;
  try {
    const std::optional<int> wanted = id ? id : commonestId(stations);
    if (!wanted) {
      throw DataError("no marker was found in \"" + folder + "\"; check --family and the light");
    }
    recording.id = *wanted;
    for (const auto &[empty, lines] : stations) {
      Station station = empty;
      for (const Json &line : lines) {
        station.pictures.push_back(pictureOf(line, recording));
      }
      recording.stations.push_back(station);
    }
  }
  catch (const std::exception &e) {
    if (dynamic_cast<const DataError *>(&e) != nullptr) {
      throw;
    }
    throw DataError("the lines in \"" + folder + "\" are not those of tutorial-circle-marker-detector (" + e.what() +
                    "); make them again");
  }
  return recording;
}
} // namespace experiments
