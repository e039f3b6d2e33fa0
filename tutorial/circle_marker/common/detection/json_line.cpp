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
 * One line of JSON for each image.
 */

#include "json_line.h"

#include <algorithm>
#include <limits>

#include <nlohmann/json.hpp>

namespace tutorial {
namespace {
using Json = nlohmann::ordered_json; // keeps the order of the fields

Json pointOf(const vpImagePoint &point)
{
  return {point.get_u(), point.get_v()};
}

Json elementsOf(const vpArray2D<double> &matrix)
{
  Json elements = Json::array();
  for (unsigned int row = 0; row < matrix.getRows(); ++row) {
    for (unsigned int column = 0; column < matrix.getCols(); ++column) {
      elements.push_back(matrix[row][column]);
    }
  }
  return elements;
}

// Where there is no second pose the odds of the first are infinite, and JSON has no such number.
double finite(double logOdds)
{
  constexpr double largest = std::numeric_limits<double>::max();
  return std::clamp(logOdds, -largest, largest);
}

Json markerOf(const vpCircleMarkerDetection &detection, const vpCircleMarkerEntry *entry)
{
  const vpImageEllipse &ellipse = detection.ellipse;
  Json marker;
  marker["family"] = detection.family.getName();
  marker["id"] = detection.id;
  marker["hamming"] = detection.hamming;
  marker["margin"] = detection.margin;
  marker["dof"] = detection.dof;
  marker["size_m"] = detection.size;
  marker["center"] = pointOf(detection.center);
  marker["ellipse"] = {
      {"center", pointOf(ellipse.center)}, {"semi_axes", {ellipse.a, ellipse.b}}, {"angle", ellipse.angle}};
  marker["cMo"] = elementsOf(detection.cMo);
  marker["cMo2"] = detection.hasSecondPose ? elementsOf(detection.cMo2) : Json();
  marker["log_odds"] = finite(detection.logOdds);
  marker["covariance"] = elementsOf(detection.covariance);
  marker["visible"] = detection.visible;
  if (entry != nullptr && !entry->name.empty()) {
    marker["name"] = entry->name;
  }
  if (entry != nullptr && !entry->payload.empty()) {
    marker["payload"] = entry->isPayloadJson ? Json::parse(entry->payload) : Json(entry->payload);
  }
  return marker;
}
} // namespace

std::string jsonLine(const ImageResult &result)
{
  Json line;
  line["image"] = result.name;
  line["width"] = result.width;
  line["height"] = result.height;
  line["cpu_ms"] = result.cpuMilliseconds;
  if (result.live) {
    const auto numberOrNull = [](const std::optional<double> &value) { return value ? Json(*value) : Json(); };
    line["time_s"] = numberOrNull(result.live->time);
    line["latency_ms"] = numberOrNull(result.live->latencyMilliseconds);
    line["missed"] = result.live->missed;
  }
  line["markers"] = Json::array();
  for (const vpCircleMarkerDetection &detection : result.detections) {
    line["markers"].push_back(markerOf(detection, result.database.find(detection.family, detection.id)));
  }
  // File names need not be UTF-8.
  return line.dump(-1, ' ', false, Json::error_handler_t::replace);
}
} // namespace tutorial
