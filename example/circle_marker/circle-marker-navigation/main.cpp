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
 * A robot that is told by markers where to go, and finds its way by them.
 */

/*!
  \example circle-marker-navigation/main.cpp
  A simulated robot that drives through a room with ten circular markers: it localises itself by all that it sees,
  weighted by their covariances, and follows the tasks that they carry.
*/

#include <iostream>

#include <visp3/io/vpImageIo.h>

#include "circle_marker/common/program.h"
#include "circle_marker/common/whole_file.h"
#include "common/arguments.h"
#include "common/files.h"
#include "common/progress.h"
#include "drive.h"
#include "report.h"

using namespace navigation;

namespace {
const tutorial::Program program("circle-marker-navigation");

tutorial::RequestFor<Settings> parseCommandLine(int argc, const char *const argv[])
{
  Settings settings;
  CLI::App app("A simulated robot with a camera drives through a room. It reads its tasks from the payloads of the "
               "markers before it, and\nlocalises itself by all markers that it sees: their poses from the database, "
               "fused by the covariances.",
               "circle-marker-navigation");
  app.add_option("--output", settings.output, "Folder for track.csv, navigation.json, map.svg and station-*.png")
      ->required();
  app.add_option("--database", settings.database,
                 "Markers of the room: JSON of vpCircleMarkerDatabase; ten markers on four walls unless told "
                 "(circle-marker-simulator --save-room)");
  app.add_option("--most-tasks", settings.mostTasks, "Number of tasks after which to end")
      ->check(CLI::Range(1U, 10000U))
      ->capture_default_str();
  app.add_option("--speed-error", settings.speedError, "Constant error of the wheels' speed, share")
      ->check(common::numberIn(-0.2, 0.2))
      ->capture_default_str();
  app.add_option("--turn-error", settings.turnError, "Constant error of the wheels' turn, share")
      ->check(common::numberIn(-0.2, 0.2))
      ->capture_default_str();
  app.add_option("--seed", settings.seed, "Of all noise")->check(common::wholeNumber())->capture_default_str();
  app.footer(
      "Payloads: {\"task\": \"go\", \"to\": [x, z], \"look_deg\": d}, metres on the floor, degrees from z toward "
      "x; {\"task\": \"stop\"}.\nThe robot starts at x = 0, z = 3.8 and looks along z. Ends with 0 only if all "
      "tasks were done.");
  if (!common::parse(app, argc, argv)) {
    return {std::nullopt, app.help()};
  }
  return {settings, ""};
}

int carryOut(const Settings &settings)
{
  common::makeFolder(settings.output);
  const common::Room room = settings.database.empty() ? common::makeRoom() : common::readRoom(settings.database);
  Journey journey;
  {
    common::ProgressLine line("tasks");
    journey = drive(room, settings, [&line](std::size_t done, std::size_t all) { line.show(done, all); });
  }
  std::cout << tableOf(journey) << std::flush;
  common::writeWhole(settings.output, "track.csv", csvOf(journey));
  common::writeWhole(settings.output, "navigation.json", jsonOf(settings, journey));
  common::writeWhole(settings.output, "map.svg", mapOf(room, journey));
  for (std::size_t i = 0; i < journey.stations.size(); ++i) {
    const std::string file = settings.output + "/station-" + std::to_string(i) + ".png";
    tutorial::writeWhole(file,
                         [&](const std::string &temporary) { vpImageIo::write(journey.stations[i].view, temporary); });
  }
  if (!journey.isComplete) {
    program.complain(journey.problem + "; see " + settings.output + "/map.svg");
  }
  return journey.isComplete ? 0 : 1;
}
} // namespace

int main(int argc, const char *argv[])
{
  return program.run(parseCommandLine, argc, argv, carryOut);
}
