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
 * Names, sizes, payloads and places of circular markers, as a JSON file.
 */

#include "support/database_file.h"

#include <cmath>

#include <visp3/core/vpException.h>
#include <visp3/core/vpPoseVector.h>

#include "support/family_json.h"
#include "support/json_file.h"
#include "support/marker_size.h"
#ifdef VISP_CIRCLE_MARKER_HAVE_JSON
#include <limits>
#include <optional>

#include "support/json_lines.h"
#endif

BEGIN_VISP_NAMESPACE
namespace circle_marker {
void checkEntry(const vpCircleMarkerEntry &entry)
{
  checkMarkerSize(entry.size);
  if (entry.family.isCoded()) {
    entry.family.getCodeword(entry.id); // throws and says which ids exist
  }
  else if (entry.id != -1) {
    throw vpException(vpException::badValue, "the family %s has no ids; leave the id out",
                      entry.family.getName().c_str());
  }
  for (unsigned int i = 0; entry.wMo && i < 16; ++i) {
    if (!std::isfinite(entry.wMo->data[i])) {
      throw vpException(vpException::badValue, "the pose of %s is not finite",
                        describe(entry.family, entry.id).c_str());
    }
  }
#ifdef VISP_CIRCLE_MARKER_HAVE_JSON
  if (entry.isPayloadJson && !entry.payload.empty()) {
    constexpr std::size_t around =
        3; // the file's object, its list of markers, and the marker: what is saved can be read
    try {
      parseWithLines(entry.payload, deepestJson - around);
    }
    catch (const vpException &e) {
      throw vpException(vpException::badValue,
                        "the payload of %s is said to be JSON and cannot be saved as that (%s); mend it, or leave "
                        "isPayloadJson false",
                        describe(entry.family, entry.id).c_str(), e.getStringMessage().c_str());
    }
  }
#endif
}

std::string describe(const vpCircleMarkerFamily &family, int id)
{
  return family.isCoded() ? family.getName() + " id " + std::to_string(id) : family.getName();
}

#ifdef VISP_CIRCLE_MARKER_HAVE_JSON
namespace {
using Kind = JsonNode::Kind;

double readNumber(const JsonNode &node, const std::string &what)
{
  if (!node.scalar.is_number()) {
    refuseAtLine(node.line, what);
  }
  return node.scalar.get<double>();
}

std::string readText(const JsonNode &node, const std::string &what)
{
  if (!node.scalar.is_string()) {
    refuseAtLine(node.line, what);
  }
  return node.scalar.get<std::string>();
}

vpCircleMarkerFamily familyOf(const JsonNode &node)
{
  if (node.kind != Kind::Object) {
    readText(node, "\"family\" must be a name, such as \"golay23\"");
  }
  try {
    return familyFromJson(valueOf(node));
  }
  catch (const std::exception &e) { // our own, and the library's where a type is wrong
    refuseAtLine(node.line, e.what());
  }
}

int readId(const JsonNode &node)
{
  // The library would turn 1.5 into a whole number of its own.
  if (!node.scalar.is_number_integer() || node.scalar.get<double>() < -1. ||
      node.scalar.get<double>() > std::numeric_limits<int>::max()) {
    refuseAtLine(node.line, "\"id\" must be a whole number from 0");
  }
  return node.scalar.get<int>();
}

vpHomogeneousMatrix readPose(const JsonNode &node)
{
  const std::string what = "\"pose\" must be six numbers: x, y, z in metres, then theta u in radians";
  if (node.kind != Kind::Array || node.children.size() != 6) {
    refuseAtLine(node.line, what);
  }
  vpPoseVector pose;
  for (unsigned int i = 0; i < 6; ++i) {
    pose[i] = readNumber(node.children[i].second, what);
  }
  return vpHomogeneousMatrix(pose);
}

void readPayload(const JsonNode &node, vpCircleMarkerEntry &entry)
{
  entry.isPayloadJson = node.kind != Kind::Scalar || !node.scalar.is_string();
  entry.payload = entry.isPayloadJson ? valueOf(node).dump() : node.scalar.get<std::string>();
}

vpCircleMarkerEntry readEntry(const JsonNode &node)
{
  if (node.kind != Kind::Object) {
    refuseAtLine(node.line, "a marker must be an object, such as {\"family\": \"golay23\", \"id\": 5, \"size\": 0.18}");
  }
  vpCircleMarkerEntry entry;
  // Each key with what takes its value, so that a misspelt key is an error and not silently ignored.
  for (const auto &[key, value] : node.children) {
    if (key == "family") {
      entry.family = familyOf(value);
    }
    else if (key == "id") {
      entry.id = readId(value);
    }
    else if (key == "size") {
      entry.size = readNumber(value, "\"size\" must be the ring's outer diameter in metres");
      if (!(entry.size > 0.)) {
        refuseAtLine(value.line, "\"size\" must be the ring's outer diameter in metres, and positive");
      }
    }
    else if (key == "name") {
      entry.name = readText(value, "\"name\" must be a text");
    }
    else if (key == "payload") {
      readPayload(value, entry);
    }
    else if (key == "pose") {
      entry.wMo = readPose(value);
    }
    else {
      refuseAtLine(value.line, "unknown key \"" + key + "\"; known are family, id, size, name, payload, pose");
    }
  }
  for (const char *key : {"family", "id", "size"}) {
    const bool isNeeded = key != std::string("id") || entry.family.isCoded();
    if (isNeeded && node.find(key) == nullptr) {
      refuseAtLine(node.line, std::string("a marker without \"") + key + "\"; add it");
    }
  }
  return entry;
}

vpCircleMarkerDatabase read(const JsonNode &root)
{
  const JsonNode *markers = root.find("markers");
  if (markers == nullptr || markers->kind != Kind::Array || root.children.size() != 1) {
    refuseAtLine(markers == nullptr ? root.line : markers->line,
                 "the file must be one object with the list \"markers\" and nothing else");
  }
  vpCircleMarkerDatabase database;
  for (const auto &[name, node] : markers->children) {
    (void)name;
    const vpCircleMarkerEntry entry = readEntry(node);
    try {
      database.add(entry);
    }
    catch (const vpException &e) {
      refuseAtLine(node.line, e.what());
    }
  }
  return database;
}

nlohmann::json written(const vpCircleMarkerEntry &entry)
{
  nlohmann::json json{{"family", familyToJson(entry.family)}, {"size", entry.size}};
  if (entry.family.isCoded()) {
    json["id"] = entry.id;
  }
  if (!entry.name.empty()) {
    json["name"] = entry.name;
  }
  if (!entry.payload.empty()) {
    json["payload"] = entry.isPayloadJson ? nlohmann::json::parse(entry.payload) : nlohmann::json(entry.payload);
  }
  if (entry.wMo) {
    const vpPoseVector pose(*entry.wMo);
    json["pose"] = std::vector<double>(pose.data, pose.data + 6);
  }
  return json;
}
} // namespace

vpCircleMarkerDatabase readDatabase(const std::string &filename)
{
  const std::optional<std::string> text = readWhole(filename);
  if (!text) {
    throw vpException(vpException::ioError, "cannot read the marker database \"%s\"; is it there?", filename.c_str());
  }
  try {
    return read(parseWithLines(*text));
  }
  catch (const vpException &e) {
    throw vpException(vpException::badValue, "marker database \"%s\", %s", filename.c_str(), e.what());
  }
}

void writeDatabase(const std::string &filename, const vpCircleMarkerDatabase &database)
{
  // A line for each marker, so that the lines of errors say which.
  std::string text = "{\n  \"markers\": [";
  for (const vpCircleMarkerEntry &entry : database.getEntries()) {
    try {
      text += (text.back() == '[' ? "\n    " : ",\n    ") + written(entry).dump();
    }
    catch (const nlohmann::json::exception &e) {
      throw vpException(vpException::badValue,
                        "cannot write the marker database \"%s\": of %s the name and the payload must be UTF-8, and a "
                        "payload that is said to be JSON must be: %s",
                        filename.c_str(), describe(entry.family, entry.id).c_str(), e.what());
    }
  }
  text += "\n  ]\n}\n";
  if (!writeWhole(filename, text)) {
    throw vpException(vpException::ioError,
                      "cannot write the marker database \"%s\"; is its folder there and writable?", filename.c_str());
  }
}
#else
vpCircleMarkerDatabase readDatabase(const std::string &filename)
{
  refuseWithoutJson("read", filename);
}

void writeDatabase(const std::string &filename, const vpCircleMarkerDatabase &)
{
  refuseWithoutJson("write", filename);
}
#endif
} // namespace circle_marker
END_VISP_NAMESPACE
