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
 * Settings of the circular marker detector, as a JSON file.
 */

#include "detector_settings.h"

#include <cmath>

#include <Eigen/Eigenvalues>

#include <visp3/core/vpException.h>

#include "support/family_json.h"
#include "support/json_file.h"
#include "support/json_lines.h"
#ifdef VISP_CIRCLE_MARKER_HAVE_JSON
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>
#endif

BEGIN_VISP_NAMESPACE
namespace circle_marker {
void checkCameraCovariance(const Eigen::Matrix4d &covariance)
{
  constexpr double rounding = 1e-9; // of what was written as text
  const double largest = covariance.cwiseAbs().maxCoeff();
  const bool isSymmetric = (covariance - covariance.transpose()).cwiseAbs().maxCoeff() <= rounding * largest;
  if (!covariance.allFinite() || !isSymmetric ||
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d>(covariance, Eigen::EigenvaluesOnly).eigenvalues().minCoeff() <
          -rounding * largest) {
    throw vpException(vpException::badValue,
                      "the camera's covariance must be a symmetric matrix of pixels^2 of (px, py, u0, v0), with no "
                      "direction in which the variance is negative");
  }
}

#ifdef VISP_CIRCLE_MARKER_HAVE_JSON
namespace {
using Json = nlohmann::json;

[[noreturn]] void refuse(const std::string &key, const std::string &wanted)
{
  throw vpException(vpException::badValue, "\"%s\" must be %s", key.c_str(), wanted.c_str());
}

// The library would turn -1 and 1.5 into whole numbers of its own.
unsigned int readCount(const std::string &key, const Json &value, unsigned int least,
                       unsigned int most = std::numeric_limits<unsigned int>::max())
{
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() < least || value.get<std::uint64_t>() > most) {
    refuse(key, "a whole number from " + std::to_string(least) + " to " + std::to_string(most));
  }
  return value.get<unsigned int>();
}

std::vector<vpCircleMarkerFamily> readFamilies(const std::string &key, const Json &value)
{
  if (!value.is_array() || value.empty()) {
    refuse(key, "a list of at least one family");
  }
  std::vector<vpCircleMarkerFamily> families;
  for (const Json &family : value) {
    families.push_back(familyFromJson(family));
  }
  return families;
}

std::map<int, double> readSizes(const std::string &key, const Json &value)
{
  if (!value.is_object()) {
    refuse(key, "an object with ids as keys and metres as values");
  }
  std::map<int, double> sizes;
  for (const auto &[name, size] : value.items()) {
    constexpr std::size_t mostDigits = 9; // an int holds any of them
    const bool isNumber =
        !name.empty() && name.size() <= mostDigits && name.find_first_not_of("0123456789") == std::string::npos;
    const bool isId = isNumber || name == "-1"; // without a code
    if (!isId || !size.is_number() || !(size.get<double>() > 0.)) {
      refuse(key, "an object with ids as keys and positive metres as values, not \"" + name + "\": " + size.dump());
    }
    if (!sizes.emplace(std::stoi(name), size.get<double>()).second) {
      refuse(key, "an object with each id once, not " + std::to_string(std::stoi(name)) + " again as \"" + name + "\"");
    }
  }
  return sizes;
}

Eigen::Matrix4d readCameraCovariance(const std::string &key, const Json &value)
{
  const std::string wanted = "four lists of four numbers: the covariance of px, py, u0 and v0, pixels^2";
  Eigen::Matrix4d covariance;
  if (!value.is_array() || value.size() != 4) {
    refuse(key, wanted);
  }
  for (int i = 0; i < 4; ++i) {
    const Json &row = value.at(static_cast<std::size_t>(i));
    if (!row.is_array() || row.size() != 4) {
      refuse(key, wanted);
    }
    for (int j = 0; j < 4; ++j) {
      covariance(i, j) = row.at(static_cast<std::size_t>(j)).get<double>();
    }
  }
  checkCameraCovariance(covariance);
  return covariance;
}

Json written(const Eigen::Matrix4d &covariance)
{
  Json rows = Json::array();
  for (int i = 0; i < 4; ++i) {
    rows.push_back({covariance(i, 0), covariance(i, 1), covariance(i, 2), covariance(i, 3)});
  }
  return rows;
}

// Names of the polarities in their order.
constexpr std::array<const char *, 3> polarities = {"black on white", "white on black", "both"};

vpCircleMarkerPolarity readPolarity(const std::string &key, const Json &value)
{
  const auto name = std::find(polarities.begin(), polarities.end(), value.get<std::string>());
  if (name == polarities.end()) {
    refuse(key, "\"black on white\", \"white on black\" or \"both\"");
  }
  return static_cast<vpCircleMarkerPolarity>(name - polarities.begin());
}

void readSetting(const std::string &key, const Json &value, DetectorSettings &settings)
{
  if (key == "families") {
    settings.families = readFamilies(key, value);
  }
  else if (key == "sizes") {
    settings.sizes = readSizes(key, value);
  }
  else if (key == "maximumHammingDistance") {
    settings.decode.maximumHamming = readCount(key, value, 0);
  }
  else if (key == "minimumMargin") {
    settings.decode.minimumMargin = value.get<double>();
    if (!(settings.decode.minimumMargin >= 0. && settings.decode.minimumMargin <= 1.)) {
      refuse(key, "from 0 to 1");
    }
  }
  else if (key == "refinePose") {
    settings.refinePose = value.get<bool>();
  }
  else if (key == "zAlignedWithCameraAxis") {
    settings.zAlignedWithCameraAxis = value.get<bool>();
  }
  else if (key == "polarity") {
    settings.polarity = readPolarity(key, value);
  }
  else if (key == "threads") {
    settings.threads = readCount(key, value, 1, mostThreads);
  }
  else if (key == "tracking") {
    settings.tracking = value.get<bool>();
  }
  else if (key == "fullSearchPeriod") {
    settings.fullSearchPeriod = readCount(key, value, 1);
  }
  else if (key == "cameraCovariance") {
    settings.cameraCovariance = readCameraCovariance(key, value);
  }
  else {
    throw vpException(vpException::badValue,
                      "unknown setting \"%s\"; known are families, sizes, maximumHammingDistance, minimumMargin, "
                      "refinePose, zAlignedWithCameraAxis, polarity, threads, tracking, fullSearchPeriod, "
                      "cameraCovariance",
                      key.c_str());
  }
}

void read(const Json &json, DetectorSettings &settings)
{
  if (!json.is_object()) {
    throw vpException(vpException::badValue, "it must hold one JSON object");
  }
  // Each key with what takes its value, so that a misspelt key is an error and not silently ignored.
  for (const auto &[key, value] : json.items()) {
    try {
      readSetting(key, value, settings);
    }
    catch (const Json::exception &error) { // which tells of the type, but not of what
      throw vpException(vpException::badValue, "\"%s\" is %s: %s", key.c_str(), value.dump().c_str(), error.what());
    }
  }
}
} // namespace

DetectorSettings readSettings(const std::string &filename, const DetectorSettings &settings)
{
  const std::optional<std::string> text = readWhole(filename);
  if (!text) {
    throw vpException(vpException::ioError, "cannot read the settings file \"%s\"", filename.c_str());
  }
  DetectorSettings result = settings;
  try {
    read(valueOf(parseWithLines(*text)), result); // which refuses keys that are there twice
  }
  catch (const std::exception &error) { // parse and type errors of the JSON library, std::stoi's and our own
    throw vpException(vpException::badValue, "settings file \"%s\": %s", filename.c_str(), error.what());
  }
  return result;
}

void writeSettings(const std::string &filename, const DetectorSettings &settings)
{
  Json json;
  json["families"] = Json::array();
  for (const vpCircleMarkerFamily &family : settings.families) {
    json["families"].push_back(familyToJson(family));
  }
  json["sizes"] = Json::object();
  for (const auto &[id, size] : settings.sizes) {
    json["sizes"][std::to_string(id)] = size;
  }
  json["maximumHammingDistance"] = settings.decode.maximumHamming;
  json["minimumMargin"] = settings.decode.minimumMargin;
  json["refinePose"] = settings.refinePose;
  json["zAlignedWithCameraAxis"] = settings.zAlignedWithCameraAxis;
  json["polarity"] = polarities[static_cast<std::size_t>(settings.polarity)];
  json["threads"] = settings.threads;
  json["tracking"] = settings.tracking;
  json["fullSearchPeriod"] = settings.fullSearchPeriod;
  json["cameraCovariance"] = written(settings.cameraCovariance);
  if (!writeWhole(filename, json.dump(2) + "\n")) {
    throw vpException(vpException::ioError, "cannot write the settings file \"%s\"; is its folder there and writable?",
                      filename.c_str());
  }
}
#else
DetectorSettings readSettings(const std::string &filename, const DetectorSettings &)
{
  refuseWithoutJson("read", filename);
}

void writeSettings(const std::string &filename, const DetectorSettings &)
{
  refuseWithoutJson("write", filename);
}
#endif
} // namespace circle_marker
END_VISP_NAMESPACE
