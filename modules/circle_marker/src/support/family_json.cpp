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
 * Families of markers in JSON files.
 */

#include "support/family_json.h"

#ifdef VISP_CIRCLE_MARKER_HAVE_JSON
#include <array>
#include <utility>

#include <visp3/core/vpException.h>

#include "support/same_family.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
using Json = nlohmann::json;

// A layout's radii by their names in files.
std::array<std::pair<const char *, double *>, 4> radiiOf(vpCircleMarkerLayout &layout)
{
  return {{{"ringInner", &layout.ringInner},
           {"codeOuter", &layout.codeOuter},
           {"codeInner", &layout.codeInner},
           {"quietZone", &layout.quietZone}}};
}
} // namespace

vpCircleMarkerFamily familyFromJson(const nlohmann::json &value)
{
  if (!value.is_object()) {
    return vpCircleMarkerFamily::fromName(value.get<std::string>());
  }
  const bool isRing = value.size() == 2 && value.contains("ratio") && value.at("name") == "ring";
  const bool hasLayout = value.size() == 2 && value.contains("layout") && value.at("layout").size() == 4;
  if (!isRing && !hasLayout) {
    throw vpException(
        vpException::badValue,
        "a family must be a name, or {\"name\": \"ring\", \"ratio\": ...}, or {\"name\": ..., \"layout\": "
        "{\"ringInner\": ..., \"codeOuter\": ..., \"codeInner\": ..., \"quietZone\": ...}}, not %s",
        value.dump().c_str());
  }
  if (isRing) {
    return vpCircleMarkerFamily::ring(value.at("ratio").get<double>());
  }
  const vpCircleMarkerFamily family = vpCircleMarkerFamily::fromName(value.at("name").get<std::string>());
  vpCircleMarkerLayout layout;
  for (const auto &[name, radius] : radiiOf(layout)) {
    *radius = value.at("layout").at(name).get<double>();
  }
  return family.withLayout(layout);
}

nlohmann::json familyToJson(const vpCircleMarkerFamily &family)
{
  vpCircleMarkerLayout layout = family.getLayout();
  if (isSameLayout(layout, vpCircleMarkerFamily(family.getType()).getLayout())) {
    return family.getName();
  }
  if (family.getType() == vpCircleMarkerFamily::RING &&
      isSameLayout(layout, vpCircleMarkerFamily::ring(layout.ringInner).getLayout())) {
    return Json{{"name", family.getName()}, {"ratio", layout.ringInner}};
  }
  Json radii = Json::object();
  for (const auto &[name, radius] : radiiOf(layout)) {
    radii[name] = *radius;
  }
  return Json{{"name", family.getName()}, {"layout", radii}};
}
} // namespace circle_marker
END_VISP_NAMESPACE
#endif
