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
 * Position-based visual servo of a simulated camera on a circular marker, an AprilTag or both.
 */

/*!
  \example tutorial-circle-marker-pbvs/main.cpp
  Position-based visual servo of a simulated camera on a circular marker, an AprilTag or both.
*/

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "../common/program.h"
#include "../common/servo/live_view.h"
#include "../common/servo/servo_loop.h"
#include "../common/servo/servo_progress.h"
#include "../common/servo/servo_report.h"
#include "../common/servo/servo_scene.h"
#include "../common/visp_names.h"
#include "../common/whole_file.h"
#include "command_line.h"

using namespace tutorial;

namespace {
const Program program("tutorial-circle-marker-pbvs");

/*! A servo to be run. */
struct ServoProblem
{
  ServoGoal goal;            //!< Where it goes.
  vpHomogeneousMatrix start; //!< Pose of the object at the start.
  std::uint64_t seed = 0;    //!< Of the noise.
};

ServoProblem makeProblem(const Order &order, unsigned int run)
{
  StartRange range;
  if (order.distance) {
    range.nearest = range.farthest = *order.distance;
  }
  ServoProblem problem;
  problem.seed = order.seed + run;
  problem.goal.camera = servoCamera(order.cameraFile, order.cameraName);
  problem.goal.object = makeObject(order.markers);
  problem.goal.cdMo = desiredPose();
  problem.start = randomStart(problem.goal.camera, problem.goal.object, range, problem.seed);
  return problem;
}

ServoRecord runSimulated(const ServoProblem &problem, bool isRealTime, const Observer &observer)
{
  const ServoGoal &goal = problem.goal;
  vpSimulatorCamera robot;
  prepareRobot(robot, problem.start);
  SimulatedEyes eyes(goal.camera, goal.object, robot, goal.cdMo, problem.seed, isRealTime);
  return runServo(eyes, robot, goal, observer);
}

ServoRecord runWithoutDisplay(const ServoProblem &problem)
{
  ServoProgress progress(problem.goal);
  return runSimulated(problem, false, [&progress](const vpImage<unsigned char> &, const ServoStep &step) {
    progress.show(step);
    return ServoWish::Go;
  });
}

ServoRecord runWithDisplay(const ServoProblem &problem)
{
  std::optional<LiveView> view;
  try {
    view.emplace(problem.goal);
  }
  catch (const vpException &e) {
    program.complain(std::string("no window can be opened (") + e.what() +
                     "); going on without, --display-off does so silently");
    return runWithoutDisplay(problem);
  }
  const ServoRecord record = runSimulated(
      problem, true, [&view](const vpImage<unsigned char> &I, const ServoStep &step) { return view->show(I, step); });
  const bool quitByClick = !record.converged && record.reason.find("click") != std::string::npos;
  if (!quitByClick) {
    view->showEnd(record);
  }
  return record;
}

/*! A run's line of the table on the standard output and in runs.csv. */
std::string runLine(const ServoProblem &problem, const ServoRecord &record)
{
  const ServoError &error = *record.steps.back().trueError;
  std::ostringstream out;
  out << problem.seed << ',' << problem.start.getTranslationVector().frobeniusNorm() << ',' << record.steps.size()
      << ',' << 1e3 * error.distance() << ',' << error.angle() * 180. / M_PI << ',' << 1e3 * error.object << ','
      << record.converged << '\n';
  return out.str();
}

void printRun(const ServoProblem &problem, const ServoRecord &record)
{
  const ServoError &error = *record.steps.back().trueError;
  std::cout << "seed " << problem.seed << ": from " << std::fixed << std::setprecision(3)
            << problem.start.getTranslationVector().frobeniusNorm() << " m, " << record.steps.size()
            << " images, true pose at the end " << 1e3 * error.distance() << " mm and " << std::setprecision(4)
            << error.angle() * 180. / M_PI
            << " deg from the desired one: " << (record.converged ? "converged" : "not converged, " + record.reason)
            << std::endl;
}

/*! How far a run is from what is accepted; 1 is the limit. */
double badness(const ServoProblem &problem, const ServoRecord &record)
{
  const double acceptedDistance = problem.goal.acceptedDistance, acceptedAngle = problem.goal.acceptedAngle;
  const ServoError &error = *record.steps.back().trueError;
  return std::max(
      {error.distance() / acceptedDistance, error.object / acceptedDistance, error.angle() / acceptedAngle});
}

/*! \return Whether all servos converged. */
bool carryOut(const Order &order)
{
  prepareReport(order.folder);
  std::string table = "seed,start_distance_m,images,distance_mm,angle_deg,object_mm,converged\n";
  std::optional<std::pair<ServoProblem, ServoRecord>> worst;
  unsigned int converged = 0;
  double worstDistance = 0., worstAngle = 0.;
  for (unsigned int run = 0; run < order.runs; ++run) {
    const ServoProblem problem = makeProblem(order, run);
    const ServoRecord record = order.display ? runWithDisplay(problem) : runWithoutDisplay(problem);
    printRun(problem, record);
    table += runLine(problem, record);
    converged += record.converged ? 1 : 0;
    worstDistance = std::max(worstDistance, record.steps.back().trueError->distance());
    worstAngle = std::max(worstAngle, record.steps.back().trueError->angle());
    if (!worst || badness(problem, record) > badness(worst->first, worst->second)) {
      worst.emplace(problem, record);
    }
  }
  if (order.runs > 1) {
    std::cout << converged << " of " << order.runs << " converged; worst at the end " << std::setprecision(3)
              << 1e3 * worstDistance << " mm and " << std::setprecision(4) << worstAngle * 180. / M_PI << " deg"
              << std::endl;
    writeWholeText((std::filesystem::path(order.folder) / "runs.csv").string(), table);
  }
  writeReport(order.folder, worst->first.goal, worst->second);
  return converged == order.runs;
}
} // namespace

int main(int argc, const char *argv[])
{
  return program.run(parseCommandLine, argc, argv, [](const Order &order) {
    if (!carryOut(order)) {
      program.complain("not every servo reached the desired pose; see servo.csv for the worst");
      return 1;
    }
    return 0;
  });
}
