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
 * The lines that tell how an experiment's data were made.
 */

#include <sstream>
#include <stdexcept>

#include "common/version.h"
#include "common/visp_names.h"
#include "run_header.h"

namespace experiments {
namespace {
std::string textOf(double value)
{
  std::ostringstream out;
  out.precision(17); // All a double has.
  out << value;
  return out.str();
}

std::string textOf(const std::optional<double> &value)
{
  return value ? textOf(*value) : ownRange;
}

std::optional<double> rangeFrom(const std::string &text)
{
  return text == ownRange ? std::nullopt : std::optional<double>(std::stod(text));
}
} // namespace

std::vector<HeaderLine> headerOf(const Settings &settings)
{
  return {{"version", std::string(projectVersion) + " on ViSP " + vispVersion()},
          {"seed", std::to_string(settings.seed)},
          {"size_m", textOf(settings.size)},
          {"noise_grey_levels", textOf(settings.noise)},
          {"blur_px", textOf(settings.blur)},
          {"max_distance_m", textOf(settings.maximumDistance)},
          {"max_angle_deg", textOf(settings.maximumAngle)}};
}

Settings settingsOf(const std::vector<HeaderLine> &lines, const Settings &given)
{
  Settings settings = given;
  for (const HeaderLine &line : lines) {
    if (line.key == "seed") {
      settings.seed = std::stoull(line.value);
    }
    else if (line.key == "size_m") {
      settings.size = std::stod(line.value);
    }
    else if (line.key == "noise_grey_levels") {
      settings.noise = std::stod(line.value);
    }
    else if (line.key == "blur_px") {
      settings.blur = std::stod(line.value);
    }
    else if (line.key == "max_distance_m") {
      settings.maximumDistance = rangeFrom(line.value);
    }
    else if (line.key == "max_angle_deg") {
      settings.maximumAngle = rangeFrom(line.value);
    }
  }
  return settings;
}
} // namespace experiments
