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

#include <visp3/robot/vpSimulatorCamera.h>

namespace tutorial {
namespace {
// The servo ends when the measured error of this many images in a row is within these bounds, half of what the true
// pose is judged with: one good measurement may be chance.
constexpr unsigned int goodImages = 10;
constexpr double goodDistance = 0.5 * acceptedDistance;
constexpr double goodAngle = 0.5 * acceptedAngle;
// Without a marker the camera stands still, and this many images (2 s) are waited for.
constexpr unsigned int mostBlindImages = 50;
// From 4 m it takes some 130 images; more than this (40 s) means that the servo does not end.
constexpr unsigned int mostImages = 1000;

/*! Markers are covered on these parts of the way, counted from 0 at the start to 1 at the goal. */
constexpr double circleCoveredFrom = 0.40, circleCoveredTo = 0.60;
constexpr double tagCoveredFrom = 0.70, tagCoveredTo = 0.90;

/*! Length of the way that is left: metres and radians count alike. */
double remaining(const ServoError &error)
{
  return error.distance() + error.angle();
}

/*! Only with two markers can one be covered. */
Covers coversAt(const ServoObject &object, double progress)
{
  if (!object.circle || !object.aprilTag) {
    return Covers{};
  }
  return Covers{progress >= circleCoveredFrom && progress < circleCoveredTo,
                progress >= tagCoveredFrom && progress < tagCoveredTo};
}

/*! The camera that moves; its world is the object's frame. */
class MovingCamera
{
public:
  explicit MovingCamera(const vpHomogeneousMatrix &cMo)
  {
    m_robot.setSamplingTime(samplingTime);
    // ServoTask keeps these limits; the robot, which reports what it cuts, must not cut for a rounding.
    m_robot.setMaxTranslationVelocity(1.001 * greatestSpeed);
    m_robot.setMaxRotationVelocity(1.001 * greatestTurn);
    m_robot.setPosition(cMo.inverse());
  }

  vpHomogeneousMatrix cMo() const { return m_robot.getPosition().inverse(); }
  void move(const vpColVector &velocity) { m_robot.setVelocity(vpRobot::CAMERA_FRAME, velocity); }

private:
  vpSimulatorCamera m_robot; //!< Integrates the velocities.
};

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
  /*! \return Why the servo ends with this step, nothing if it goes on; "" if the desired pose was measured. */
  std::optional<std::string> after(const ServoStep &step)
  {
    const bool isGood = step.measured && step.measured->isWithin(goodDistance, goodAngle);
    m_good = isGood ? m_good + 1 : 0;
    m_blind = step.measured ? 0 : m_blind + 1;
    if (m_good == goodImages) {
      return "";
    }
    if (m_blind == mostBlindImages) {
      return "no marker was seen in " + std::to_string(mostBlindImages) + " images";
    }
    if (step.iteration + 1 == mostImages) {
      return "the measured error was not small in " + std::to_string(mostImages) + " images";
    }
    return std::nullopt;
  }

private:
  unsigned int m_good = 0;  //!< Images in a row with a small error.
  unsigned int m_blind = 0; //!< Images in a row without a marker.
};

/*! The verdict on a servo whose measured error is small. */
void judge(ServoRecord &record)
{
  const ServoError &error = record.steps.back().trueError;
  record.converged = error.isWithin(acceptedDistance, acceptedAngle);
  if (!record.converged) {
    std::ostringstream reason;
    reason << "the measured error is small, but the true pose is " << std::fixed << std::setprecision(3)
           << 1e3 * error.distance() << " mm and " << error.angle() * 180. / M_PI << " degrees from the desired one";
    record.reason = reason.str();
  }
}

/*! Noise of its own for each image: 0x9e3779b97f4a7c15 spreads the seeds (Knuth's multiplicative hashing). */
std::uint64_t noiseSeed(std::uint64_t seed, unsigned int iteration)
{
  return (seed + 1) * 0x9e3779b97f4a7c15ULL + iteration;
}
} // namespace

vpHomogeneousMatrix desiredPose()
{
  return vpHomogeneousMatrix(vpTranslationVector(0., 0., 0.5), vpRotationMatrix());
}

//! [Servo loop]
ServoRecord runServo(const ServoProblem &problem, const Observer &observer)
{
  const vpHomogeneousMatrix cdMo = desiredPose();
  ServoTask task(cdMo);
  PoseSource eyes(problem.object, problem.camera.parameters);
  MovingCamera camera(problem.start);
  const double wholeWay = remaining(ServoError(cdMo, problem.start));
  ServoRecord record;
  SnapshotKeeper keeper(record.snapshots);
  EndOfServo end;
  for (unsigned int iteration = 0;; ++iteration) {
    const vpHomogeneousMatrix truth = camera.cMo();
    ServoStep step{iteration, iteration * samplingTime, Covers{},     ObjectSighting{},
                   truth,     ServoError(cdMo, truth),  std::nullopt, vpColVector(6, 0.)};
    const double progress = 1. - remaining(step.trueError) / wholeWay;
    step.covers = coversAt(problem.object, progress);
    const vpImage<unsigned char> I =
        renderScene(problem.camera, problem.object, truth, step.covers, noiseSeed(problem.seed, iteration));
    step.sighting = eyes.look(I);
    if (const auto &cMo = step.sighting.best()) {
      step.measured = ServoError(cdMo, *cMo);
      step.velocity = task.velocity(*cMo);
    }
    keeper.consider(step, I, progress);
    record.steps.push_back(step);

    std::optional<std::string> reason = end.after(step);
    if (observer && !observer(I, step) && !reason) {
      reason = "stopped by a right click before the desired pose was reached";
    }
    if (reason) {
      record.snapshots.push_back(Snapshot{"final", step, I});
      record.reason = *reason;
      break;
    }
    camera.move(step.velocity);
  }
  if (record.reason.empty()) {
    judge(record);
  }
  return record;
}
//! [Servo loop]
} // namespace tutorial
