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
 * What a robot's way was like: table, JSON.
 */

#include "report.h"

#include <cmath>
#include <iomanip>
#include <sstream>

#include <nlohmann/json.hpp>

#include "common/numbers.h"
#include "common/statistics.h"

namespace navigation {
namespace {
constexpr double degree = M_PI / 180.;

double placeError(const FloorPose &a, const FloorPose &b)
{
  return std::hypot(a.x - b.x, a.z - b.z);
}

/*! Errors of all steps. */
struct Errors
{
  std::vector<double> place, direction, sigmas, wheels, camera, cameraSigmas;
};

Errors errorsOf(const Journey &journey)
{
  Errors errors;
  for (const Step &step : journey.steps) {
    errors.place.push_back(1e3 * placeError(step.believed, step.truth));
    errors.direction.push_back(std::abs(wrapped(step.believed.direction - step.truth.direction)) / degree);
    errors.sigmas.push_back(step.sigmas);
    errors.wheels.push_back(1e3 * placeError(step.wheels, step.truth));
    if (step.cameraError) {
      errors.camera.push_back(1e3 * *step.cameraError);
      errors.cameraSigmas.push_back(*step.cameraSigmas);
    }
  }
  return errors;
}

double stationError(const Station &station)
{
  return 1e3 * placeError(station.goal, station.truth);
}
} // namespace

std::string tableOf(const Journey &journey)
{
  const Errors e = errorsOf(journey);
  std::ostringstream out;
  out << "station    marker     off, mm   degrees   task\n";
  for (std::size_t i = 0; i < journey.stations.size(); ++i) {
    const Station &s = journey.stations[i];
    out << std::setw(7) << i << "    " << std::left << std::setw(9) << s.marker << std::right << std::setw(9)
        << common::digits(stationError(s)) << std::setw(10)
        << common::digits(std::abs(wrapped(s.goal.direction - s.truth.direction)) / degree) << "   " << s.task << "\n";
  }
  const auto line = [&out](const std::string &name, const std::vector<double> &values) {
    const common::Statistics s = common::statisticsOf(values);
    out << name << ": rms " << common::digits(s.rms) << ", median " << common::digits(s.median) << ", greatest "
        << common::digits(s.most) << "\n";
  };
  out << journey.steps.size() << " images, in " << e.camera.size() << " of them markers of the database\n";
  line("place by wheels and markers, mm", e.place);
  line("direction by wheels and markers, degrees", e.direction);
  line("the same in standard deviations", e.sigmas);
  line("camera by the markers of one image, mm", e.camera);
  line("the same in standard deviations", e.cameraSigmas);
  line("place by the wheels alone, mm", e.wheels);
  out << (journey.isComplete ? "all tasks done" : "not all tasks done: " + journey.problem) << "\n";
  return out.str();
}

std::string jsonOf(const Settings &settings, const Journey &journey)
{
  const Errors e = errorsOf(journey);
  const auto statistics = [](const std::vector<double> &values) {
    const common::Statistics s = common::statisticsOf(values);
    return nlohmann::json{{"rms", s.rms}, {"median", s.median}, {"p95", s.p95}, {"greatest", s.most}};
  };
  nlohmann::json json{{"seed", settings.seed},
                      {"images", journey.steps.size()},
                      {"images_with_markers", e.camera.size()},
                      {"complete", journey.isComplete},
                      {"problem", journey.problem},
                      {"place_mm", statistics(e.place)},
                      {"direction_deg", statistics(e.direction)},
                      {"belief_sigmas", statistics(e.sigmas)},
                      {"camera_mm", statistics(e.camera)},
                      {"camera_sigmas", statistics(e.cameraSigmas)},
                      {"wheels_mm", statistics(e.wheels)},
                      {"stations", nlohmann::json::array()}};
  for (const Station &s : journey.stations) {
    json["stations"].push_back({{"marker", s.marker},
                                {"task", s.task},
                                {"off_mm", stationError(s)},
                                {"truth", {s.truth.x, s.truth.z, s.truth.direction}}});
  }
  return json.dump(2) + "\n";
}

std::string csvOf(const Journey &journey)
{
  std::ostringstream out;
  out << std::setprecision(9)
      << "time_s,x,z,direction_rad,believed_x,believed_z,believed_direction_rad,wheels_x,wheels_z,wheels_direction_rad,"
         "markers,sigmas,camera_error_m\n";
  for (const Step &s : journey.steps) {
    out << s.time;
    for (const FloorPose *pose : {&s.truth, &s.believed, &s.wheels}) {
      out << "," << pose->x << "," << pose->z << "," << pose->direction;
    }
    out << "," << s.markers << "," << s.sigmas << ",";
    if (s.cameraError) {
      out << *s.cameraError;
    }
    out << "\n";
  }
  return out.str();
}
} // namespace navigation
