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
 * The statistics as JSON.
 */

#include <cmath>

#include <nlohmann/json.hpp>

#include "report.h"

namespace compare {
namespace {
using nlohmann::ordered_json;

ordered_json number(double value)
{
  return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
}

ordered_json jsonOf(const Statistics &statistics)
{
  return {{"mean", number(statistics.mean)},
          {"median", number(statistics.median)},
          {"p95", number(statistics.p95)},
          {"rms", number(statistics.rms)}};
}

ordered_json jsonOf(const ErrorSummary &errors)
{
  const double share = static_cast<double>(errors.wrongSolutions) / static_cast<double>(errors.frames);
  return {{"frames", errors.frames},
          {"position_mm", jsonOf(errors.position)},
          {"x_mm", jsonOf(errors.x)},
          {"y_mm", jsonOf(errors.y)},
          {"z_mm", jsonOf(errors.z)},
          {"normal_deg", jsonOf(errors.normal)},
          {"rotation_deg", jsonOf(errors.rotation)},
          {"wrong_solutions", errors.wrongSolutions},
          {"wrong_solution_rate", number(share)}};
}

ordered_json jsonOf(const MethodSummary &method, std::size_t frames)
{
  return {{"found", method.found},
          {"detection_rate", static_cast<double>(method.found) / static_cast<double>(frames)},
          {"wrong_ids", method.wrongIds},
          {"cpu_ms", jsonOf(method.cpuTime)},
          {"frames_it_found", jsonOf(method.own)},
          {"frames_all_found", jsonOf(method.common)}};
}

ordered_json jsonOf(const Ratios &ratios)
{
  return {
      {"x", number(ratios.x)}, {"y", number(ratios.y)}, {"z", number(ratios.z)}, {"rotation", number(ratios.rotation)}};
}

ordered_json jsonOf(const Cell &cell, const CellSummary &summary)
{
  ordered_json methods;
  ordered_json ratios;
  for (std::size_t method = 0; method < methodCount; ++method) {
    methods[methodNames[method]] = jsonOf(summary.methods[method], summary.frames);
    if (method != indexOf(Method::Circle)) {
      ratios[methodNames[method]] = jsonOf(circleOver(static_cast<Method>(method), summary));
    }
  }
  return {{"max_tilt_deg", cell.maxTilt}, {"min_depth_m", minDistance},         {"max_depth_m", cell.maxDistance},
          {"frames", summary.frames},     {"frames_all_found", summary.common}, {"methods", methods},
          {"rms_of_circle_over", ratios}};
}

ordered_json jsonOf(const Settings &settings)
{
  const vpCameraParameters cam = referenceCamera();
  return {{"visp", vispVersion()},
          {"seed", settings.seed},
          {"frames", settings.frames},
          {"threads", settings.threads},
          {"camera",
           {{"width", imageWidth},
            {"height", imageHeight},
            {"px", cam.get_px()},
            {"py", cam.get_py()},
            {"u0", cam.get_u0()},
            {"v0", cam.get_v0()}}},
          {"noise_grey_levels", settings.noise},
          {"blur_px", settings.blur},
          {"sheet_m", settings.sheetSide()},
          {"circle", {{"family", circleFamily}, {"size_m", settings.size}}},
          {"apriltag", {{"family", tagFamily}, {"size_m", settings.tagSize()}, {"pose_method", settings.tagPose}}}};
}
} // namespace

std::string jsonOf(const Settings &settings, const Summary &summary)
{
  ordered_json result;
  result["settings"] = jsonOf(settings);
  result["cells"] = ordered_json::array();
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    result["cells"].push_back(jsonOf(cells[cell], summary[cell]));
  }
  return result.dump(2) + "\n";
}
} // namespace compare
