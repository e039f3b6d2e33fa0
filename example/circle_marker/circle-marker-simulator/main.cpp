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
 * A camera to be moved through a room with circular markers.
 */

/*!
  \example circle-marker-simulator/main.cpp
  A camera to be moved through a room with circular markers by mouse and keys; the detector's true errors.
*/

#include <algorithm>
#include <iostream>
#include <optional>

#include <visp3/io/vpImageIo.h>
#include <visp3/robot/vpSimulatorCamera.h>

#include "circle_marker/common/program.h"
#include "circle_marker/common/numbered_name.h"
#include "circle_marker/common/servo/servo_eyes.h"
#include "circle_marker/common/servo/servo_loop.h"
#include "circle_marker/common/servo/servo_task.h"
#include "circle_marker/common/whole_file.h"
#include "common/progress.h"

#include "command_line.h"
#include "controls.h"
#include "picture.h"
#include "simulator_window.h"
#include "world.h"

using namespace simulator;

namespace {
const tutorial::Program program("circle-marker-simulator");

/*!
  The servo whose camera this is: it goes in front of the nearest marker that was seen when it began, by what the
  detector measures.
*/
class Servo
{
public:
  explicit Servo(double distance)
      : m_desired(tutorial::desiredPose(distance)), m_task(m_desired, tutorial::ServoLimits())
  {
  }

  void step(const Shot &shot, Controls &controls)
  {
    if (!m_id) {
      const auto seen =
          std::find_if(shot.markers.begin(), shot.markers.end(), [](const Comparison &m) { return m.error; });
      if (seen == shot.markers.end()) {
        controls.isServoing = false; // there is nothing to go to
        return;
      }
      m_id = seen->id;
    }
    for (const vpCircleMarkerDetection &detection : shot.detections) {
      if (detection.id == *m_id) {
        vpSimulatorCamera robot;
        tutorial::prepareRobot(robot, controls.wMc.inverse());
        robot.setRobotState(vpRobot::STATE_VELOCITY_CONTROL);
        robot.setVelocity(vpRobot::CAMERA_FRAME, m_task.velocity(detection.cMo));
        controls.wMc = robot.getPosition();
        const tutorial::ServoError error(m_desired, detection.cMo);
        controls.isServoing = !error.isWithin(0.5e-3, 0.05 * M_PI / 180.); // half a millimetre, as the tutorial's servo
        return;
      }
    }
    // Not seen in this image: the camera stands still.
  }

private:
  vpHomogeneousMatrix m_desired; //!< Of the marker.
  tutorial::ServoTask m_task;    //!< The control law.
  std::optional<int> m_id;       //!< The marker that it goes to.
};

/*! Everything at once. */
class Run
{
public:
  explicit Run(const Order &order)
      : m_order(order), m_world(order.room, order.camera, order.width, order.height, order.seed)
  {
    // The camera is level and sees the wall with most markers.
    m_controls.wMc = common::lookingAlong(0., 0., 0.2 * m_order.room.depth, 0.);
    m_controls.start = m_controls.wMc;
    if (order.display) {
      m_window.emplace();
    }
  }

  void all()
  {
    image();
    common::ProgressLine line("events");
    for (std::size_t i = 0; i < m_order.script.size() && !m_controls.isOver; ++i) {
      carryOut(m_order.script[i]);
      line.show(i + 1, m_order.script.size());
    }
    while (!m_order.hasScript && !m_controls.isOver && m_window) {
      const bool hasChanged = m_window->readInput(m_controls, m_order.camera.get_px());
      // Noise goes on even where nothing moves; but not so fast that nothing else gets done.
      if (!hasChanged) {
        m_window->pause();
      }
      image();
    }
    if (!m_order.json.empty()) {
      tutorial::writeWholeText(m_order.json, m_lines);
    }
  }

private:
  void carryOut(const ScriptEvent &event)
  {
    switch (event.kind) {
    case ScriptEvent::Kind::Key:
      for (unsigned int i = 0; i < event.count; ++i) {
        pressKey(m_controls, event.key);
      }
      image();
      break;
    case ScriptEvent::Kind::Drag:
      drag(m_controls, event.button, event.du, event.dv, m_order.camera.get_px());
      image();
      break;
    case ScriptEvent::Kind::Wait:
      for (unsigned int i = 0; i < event.count && !m_controls.isOver; ++i) {
        image();
      }
      break;
    default:
      save(event.file);
      break;
    }
  }

  /*! One image: looked at, shown, noted; then the servo moves. */
  void image()
  {
    m_shot = m_world.look(m_controls.wMc, m_controls.knobs);
    m_picture = pictureOf(m_world, m_shot, m_controls);
    if (!m_order.json.empty()) {
      m_lines += jsonLineOf(m_shot, m_controls, m_images) + "\n";
    }
    ++m_images;
    if (m_window) {
      m_window->show(m_picture);
    }
    for (; m_controls.wantedShots > 0; --m_controls.wantedShots) {
      save((*tutorial::NumberedName::parse(m_order.shots))(m_saved++));
    }
    if (!m_controls.isServoing) {
      m_servo.reset();
      return;
    }
    if (!m_servo) {
      m_servo.emplace(m_order.distance);
    }
    m_servo->step(m_shot, m_controls);
  }

  void save(const std::string &file) const
  {
    tutorial::writeWhole(file, [this](const std::string &temporary) { vpImageIo::write(m_picture, temporary); });
  }

  Order m_order;                           //!< What to do.
  World m_world;                           //!< Room, camera, detector.
  Controls m_controls;                     //!< What the user has changed.
  std::optional<SimulatorWindow> m_window; //!< Shows it.
  std::optional<Servo> m_servo;            //!< Moves the camera, if it is asked to.
  Shot m_shot;                             //!< The last image.
  vpImage<vpRGBa> m_picture;               //!< With overlays.
  std::string m_lines;                     //!< Of the results so far.
  unsigned long m_images = 0;              //!< So far.
  long m_saved = 0;                        //!< Pictures saved by the key.
};
} // namespace

int main(int argc, const char *argv[])
{
  return program.run(parseCommandLine, argc, argv, [](const Order &order) {
    Run run(order);
    run.all();
    return 0;
  });
}
