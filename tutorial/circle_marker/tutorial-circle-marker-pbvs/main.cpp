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
#include <functional>
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

/*! Takes what a servo has recorded. */
using Keep = std::function<void(const ServoRecord &record)>;

void runWithoutDisplay(const ServoProblem &problem, const Keep &keep)
{
  ServoProgress progress(problem.goal);
  keep(runSimulated(problem, false, [&progress](const vpImage<unsigned char> &, const ServoStep &step) {
    progress.show(step);
    return ServoWish::Go;
  }));
}

/*! The record is kept before the window waits for the last click. */
void runWithDisplay(const ServoProblem &problem, const Keep &keep)
{
  std::optional<LiveView> view;
  try {
    view.emplace(problem.goal);
  }
  catch (const vpException &e) {
    program.complain(std::string("no window can be opened (") + e.what() +
                     "); going on without, --display-off does so silently");
    runWithoutDisplay(problem, keep);
    return;
  }
  const ServoRecord record = runSimulated(
      problem, true, [&view](const vpImage<unsigned char> &I, const ServoStep &step) { return view->show(I, step); });
  keep(record);
  const bool quitByClick = !record.converged && record.reason.find("click") != std::string::npos;
  if (!quitByClick) {
    view->showEnd(record);
  }
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

/*! What is reported of all runs. */
class Report
{
public:
  explicit Report(const Order &order) : m_order(order) {}

  /*! Adds a run; with the last one it is written. */
  void add(const ServoProblem &problem, const ServoRecord &record)
  {
    printRun(problem, record);
    m_table += runLine(problem, record);
    ++m_runs;
    m_converged += record.converged ? 1 : 0;
    m_worstDistance = std::max(m_worstDistance, record.steps.back().trueError->distance());
    m_worstAngle = std::max(m_worstAngle, record.steps.back().trueError->angle());
    if (!m_worst || badness(problem, record) > badness(m_worst->first, m_worst->second)) {
      m_worst.emplace(problem, record);
    }
    if (m_runs == m_order.runs) {
      write();
    }
  }

  bool haveAllConverged() const { return m_converged == m_order.runs; }

private:
  void write() const
  {
    if (m_order.runs > 1) {
      std::cout << m_converged << " of " << m_order.runs << " converged; worst at the end " << std::setprecision(3)
                << 1e3 * m_worstDistance << " mm and " << std::setprecision(4) << m_worstAngle * 180. / M_PI << " deg"
                << std::endl;
      writeWholeText((std::filesystem::path(m_order.folder) / "runs.csv").string(), m_table);
    }
    writeReport(m_order.folder, m_worst->first.goal, m_worst->second);
  }

  const Order &m_order; //!< What was asked for.
  std::string m_table = "seed,start_distance_m,images,distance_mm,angle_deg,object_mm,converged\n"; //!< Of runs.csv.
  std::optional<std::pair<ServoProblem, ServoRecord>> m_worst;                                      //!< The worst run.
  unsigned int m_runs = 0;                                                                          //!< So far.
  unsigned int m_converged = 0;                                                                     //!< Of them.
  double m_worstDistance = 0.;                                                                      //!< Metres.
  double m_worstAngle = 0.;                                                                         //!< Radians.
};

/*! \return Whether all servos converged. */
bool carryOut(const Order &order)
{
  makeProblem(order, 0); // what is wrong with the camera is told before a folder is made
  prepareReport(order.folder);
  Report report(order);
  for (unsigned int run = 0; run < order.runs; ++run) {
    const ServoProblem problem = makeProblem(order, run);
    const Keep keep = [&](const ServoRecord &record) { report.add(problem, record); };
    order.display ? runWithDisplay(problem, keep) : runWithoutDisplay(problem, keep);
  }
  return report.haveAllConverged();
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
