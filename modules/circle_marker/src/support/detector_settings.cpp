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

#include "support/detector_settings.h"

#include <visp3/core/vpException.h>

#ifdef VISP_CIRCLE_MARKER_HAVE_JSON
#include <cstdio>
#include <fstream>

#include <nlohmann/json.hpp>
#endif

BEGIN_VISP_NAMESPACE
namespace circle_marker
{
#ifdef VISP_CIRCLE_MARKER_HAVE_JSON
namespace
{
using Json = nlohmann::json;

void read(const Json &json, DetectorSettings &settings)
{
  // Each key with what takes its value, so that a misspelt key is an error and not silently ignored.
  for (const auto &[key, value] : json.items()) {
    if (key == "families") {
      settings.families.clear();
      for (const std::string &name : value.get<std::vector<std::string>>()) {
        settings.families.push_back(vpCircleMarkerFamily::fromName(name));
      }
    }
    else if (key == "sizes") {
      settings.sizes.clear();
      for (const auto &[id, size] : value.items()) {
        settings.sizes[std::stoi(id)] = size.get<double>();
      }
    }
    else if (key == "maximumHammingDistance") {
      settings.decode.maximumHamming = value.get<unsigned int>();
    }
    else if (key == "minimumMargin") {
      settings.decode.minimumMargin = value.get<double>();
    }
    else if (key == "refinePose") {
      settings.refinePose = value.get<bool>();
    }
    else if (key == "zAlignedWithCameraAxis") {
      settings.zAlignedWithCameraAxis = value.get<bool>();
    }
    else if (key == "threads") {
      settings.threads = value.get<unsigned int>();
    }
    else {
      throw vpException(vpException::badValue, "unknown setting \"%s\"; known are families, sizes, "
                                               "maximumHammingDistance, minimumMargin, refinePose, "
                                               "zAlignedWithCameraAxis, threads", key.c_str());
    }
  }
}
} // namespace

DetectorSettings readSettings(const std::string &filename, const DetectorSettings &settings)
{
  std::ifstream file(filename);
  if (!file) {
    throw vpException(vpException::ioError, "cannot read the settings file \"%s\"", filename.c_str());
  }
  DetectorSettings result = settings;
  try {
    read(Json::parse(file), result);
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
    json["families"].push_back(family.getName());
  }
  json["sizes"] = Json::object();
  for (const auto &[id, size] : settings.sizes) {
    json["sizes"][std::to_string(id)] = size;
  }
  json["maximumHammingDistance"] = settings.decode.maximumHamming;
  json["minimumMargin"] = settings.decode.minimumMargin;
  json["refinePose"] = settings.refinePose;
  json["zAlignedWithCameraAxis"] = settings.zAlignedWithCameraAxis;
  json["threads"] = settings.threads;
  const std::string temporary = filename + ".tmp";
  {
    std::ofstream file(temporary);
    file << json.dump(2) << "\n";
    file.close();
    if (!file) {
      std::remove(temporary.c_str());
      throw vpException(vpException::ioError, "cannot write the settings file \"%s\"", filename.c_str());
    }
  }
  if (std::rename(temporary.c_str(), filename.c_str()) != 0) {
    std::remove(temporary.c_str());
    throw vpException(vpException::ioError, "cannot write the settings file \"%s\"", filename.c_str());
  }
}
#else
DetectorSettings readSettings(const std::string &filename, const DetectorSettings &)
{
  throw vpException(vpException::functionNotImplementedError,
                    "cannot read \"%s\": this build is without nlohmann-json; install it and build again",
                    filename.c_str());
}

void writeSettings(const std::string &filename, const DetectorSettings &)
{
  throw vpException(vpException::functionNotImplementedError,
                    "cannot write \"%s\": this build is without nlohmann-json; install it and build again",
                    filename.c_str());
}
#endif
} // namespace circle_marker
END_VISP_NAMESPACE
