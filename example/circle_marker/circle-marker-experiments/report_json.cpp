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
 * The statistics of the experiments as JSON.
 */

#include <cmath>

#include <nlohmann/json.hpp>

#include "curves.h"
#include "report.h"
#include "run_header.h"

namespace experiments {
namespace {
using nlohmann::ordered_json;

ordered_json number(double value)
{
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

// The table's header has text: a number is one here, a range that is the experiment's own is null.
ordered_json settingOf(const std::string &text)
{
  const ordered_json value = ordered_json::parse(text, nullptr, false);
  return value.is_number() ? value : text == ownRange ? ordered_json(nullptr) : ordered_json(text);
}

ordered_json jsonOf(const Statistics &s)
{
  return {{"mean", number(s.mean)},   {"median", number(s.median)}, {"p95", number(s.p95)}, {"rms", number(s.rms)},
          {"sigma", number(s.sigma)}, {"min", number(s.least)},     {"max", number(s.most)}};
}

ordered_json jsonOf(const View &view, const Summary &s)
{
  return {{"method", nameOf(view.method)},
          {"solutions", view.solutions == Solutions::Both ? "both" : "first"},
          {"frames", s.frames},
          {"found", s.found},
          {"false_markers", s.falseMarkers},
          {"mirrored", s.mirrored},
          {"misleading", s.wrong},
          {"outlines_per_frame", number(s.outlines)},
          {"markers_per_frame", number(s.markers)},
          {"position_mm", jsonOf(s.position)},
          {"normal_deg", jsonOf(s.angle)},
          {"c_minus_ec_mm", {number(s.offset[0].mean), number(s.offset[1].mean), number(s.offset[2].mean)}},
          {"cpu_ms", jsonOf(s.cpuTime)}};
}
} // namespace

std::string jsonOf(const Experiment &experiment, const Settings &settings, const RunData &data)
{
  ordered_json result;
  for (const HeaderLine &line : headerOf(settings)) {
    result["settings"][line.key] = settingOf(line.value);
  }
  result["series"] = ordered_json::array();
  for (std::size_t i = 0; i < experiment.series.size(); ++i) {
    const Series &series = experiment.series[i];
    ordered_json views = ordered_json::array();
    for (const View &view : viewsIn(data, {ringBoth, ringFirst, circle, aprilTag, bound})) {
      views.push_back(jsonOf(view, summaryOf(samplesOf(data[i], view.method), view.solutions)));
    }
    result["series"].push_back({{"name", series.name}, {"title", series.title}, {"views", views}});
  }
  return result.dump(2) + "\n";
}
} // namespace experiments
