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
 * The servo: look, compute, move, until the desired pose is reached.
 */

#include "servo_loop.h"

#include <iomanip>
#include <sstream>
#include <stdexcept>

#include "../interruption.h"

namespace tutorial {
namespace {
// The servo ends when the measured error of this many images in a row is within half of the bounds that the pose is
// judged with: one good measurement may be chance.
constexpr unsigned int goodImages = 10;
constexpr double goodShare = 0.5;
// Without a marker the camera stands still, and this many images (2 s) are waited for.
constexpr unsigned int mostBlindImages = 50;

/*!
  Keeps the first image of each kind.
*/
class SnapshotKeeper
{
public:
  explicit SnapshotKeeper(std::vector<Snapshot> &snapshots) : m_snapshots(snapshots) {}

  void consider(const ServoStep &step, const vpImage<unsigned char> &I, double progress)
  {
    keepFirst("start", step.iteration == 0, step, I);
    keepFirst("halfway", progress >= 0.5 && !step.covers.circle, step, I);
    keepFirst("circle-covered", step.covers.circle, step, I);
    keepFirst("apriltag-covered", step.covers.aprilTag, step, I);
  }

private:
  void keepFirst(const std::string &name, bool isOfThisKind, const ServoStep &step, const vpImage<unsigned char> &I)
  {
    for (const Snapshot &snapshot : m_snapshots) {
      isOfThisKind = isOfThisKind && snapshot.name != name;
    }
    if (isOfThisKind) {
      m_snapshots.push_back(Snapshot{name, step, I});
    }
  }

  std::vector<Snapshot> &m_snapshots; //!< What was kept.
};

/*!
  Counts good and blind images, and says when the servo ends.
*/
class EndOfServo
{
public:
  explicit EndOfServo(const ServoGoal &goal) : m_goal(goal) {}

  /*! \return Why the servo ends with this step, nothing if it goes on; "" if the desired pose was measured. */
  std::optional<std::string> after(const ServoStep &step)
  {
    const bool isGood =
        step.measured && step.measured->isWithin(goodShare * m_goal.acceptedDistance, goodShare * m_goal.acceptedAngle);
    m_good = isGood ? m_good + 1 : 0;
    m_blind = step.measured ? 0 : m_blind + 1;
    if (m_good == goodImages) {
      return "";
    }
    if (m_blind == mostBlindImages) {
      const std::string inTime =
          m_goal.detector.timeout > 0 ? " within " + std::to_string(m_goal.detector.timeout) + " ms each" : "";
      return "no marker was seen in " + std::to_string(mostBlindImages) + " images" + inTime;
    }
    if (step.iteration + 1 == m_goal.mostImages) {
      return "the measured error was not small in " + std::to_string(m_goal.mostImages) + " images";
    }
    return std::nullopt;
  }

private:
  ServoGoal m_goal;         //!< Where the servo goes.
  unsigned int m_good = 0;  //!< Images in a row with a small error.
  unsigned int m_blind = 0; //!< Images in a row without a marker.
};

/*! The verdict on a servo whose measured error is small. */
void judge(ServoRecord &record, const ServoGoal &goal)
{
  const ServoError &error = *record.steps.back().error();
  record.converged = error.isWithin(goal.acceptedDistance, goal.acceptedAngle);
  if (!record.converged) {
    std::ostringstream reason;
    reason << "the measured error is small, but the true pose is " << std::fixed << std::setprecision(3)
           << 1e3 * error.distance() << " mm and " << error.angle() * 180. / M_PI << " degrees from the desired one";
    record.reason = reason.str();
  }
}

/*! Moves a robot, and leaves it standing whatever happens. */
class Mover
{
public:
  explicit Mover(vpRobot &robot) : m_robot(robot) { m_robot.setRobotState(vpRobot::STATE_VELOCITY_CONTROL); }
  Mover(const Mover &) = delete;
  Mover &operator=(const Mover &) = delete;
  ~Mover()
  {
    try {
      stop();
      m_robot.setRobotState(vpRobot::STATE_STOP);
    }
    catch (const std::exception &) {
      // A robot that cannot be reached cannot be stopped from here; its own watchdog must.
    }
  }

  void move(const vpColVector &velocity) { m_robot.setVelocity(vpRobot::CAMERA_FRAME, velocity); }
  void stop() { move(vpColVector(6, 0.)); }

private:
  vpRobot &m_robot; //!< The robot.
};

/*! What is done with one image. */
ServoStep makeStep(const ServoView &view, unsigned int iteration, const ServoGoal &goal, PoseSource &source,
                   ServoTask &task)
{
  ServoStep step;
  step.iteration = iteration;
  step.time = view.time;
  step.covers = view.covers;
  step.cMo = view.truth;
  step.velocity = vpColVector(6, 0.);
  if (view.truth) {
    step.trueError = ServoError(goal.cdMo, *view.truth);
  }
  step.sighting = source.look(view.image);
  if (const auto &cMo = step.sighting.best()) {
    step.measured = ServoError(goal.cdMo, *cMo);
    step.velocity = task.velocity(*cMo);
  }
  return step;
}

/*! How far the servo has come, from 0 at the start to 1 at the goal; the first image says how long the way is. */
class Progress
{
public:
  double at(const ServoStep &step)
  {
    if (const auto &error = step.error()) {
      const double left = error->distance() + error->angle();
      m_wholeWay = m_wholeWay > 0. ? m_wholeWay : left;
      m_last = m_wholeWay > 0. ? 1. - left / m_wholeWay : 1.;
    }
    return m_last;
  }

private:
  double m_wholeWay = 0.; //!< Metres and radians count alike.
  double m_last = 0.;     //!< Where no marker is seen, it is where it was.
};
} // namespace

vpHomogeneousMatrix desiredPose(double distance)
{
  return vpHomogeneousMatrix(vpTranslationVector(0., 0., distance), vpRotationMatrix());
}

//! [Servo loop]
ServoRecord runServo(ServoEyes &eyes, vpRobot &robot, const ServoGoal &goal, const Observer &observer)
{
  ServoTask task(goal.cdMo, goal.limits);
  PoseSource source(goal.object, goal.camera.parameters, goal.detector);
  Mover mover(robot);
  ServoRecord record;
  SnapshotKeeper keeper(record.snapshots);
  EndOfServo end(goal);
  Progress progress;
  while (true) {
    std::optional<ServoView> view;
    try {
      view = eyes.look([&mover] { mover.stop(); });
      record.reason = view ? "" : "there are no more images";
    }
    catch (const std::runtime_error &e) {
      record.reason = e.what();
    }
    if (!view) {
      break;
    }
    const auto iteration = static_cast<unsigned int>(record.steps.size());
    const ServoStep step = makeStep(*view, iteration, goal, source, task);
    const ServoWish wish = observer ? observer(view->image, step) : ServoWish::Go;
    if (wish == ServoWish::Hold) {
      mover.stop();
      source.forget();
      continue;
    }
    keeper.consider(step, view->image, progress.at(step));
    record.steps.push_back(step);

    std::optional<std::string> reason = end.after(step);
    if (wish == ServoWish::Quit && !reason) {
      reason = std::string(isInterrupted() ? "interrupted" : "stopped by a right click") +
               " before the desired pose was reached";
    }
    if (reason) {
      record.snapshots.push_back(Snapshot{"final", step, view->image});
      record.reason = *reason;
      break;
    }
    mover.move(step.velocity);
  }
  if (record.reason.empty()) {
    judge(record, goal);
  }
  return record;
}
//! [Servo loop]
} // namespace tutorial
