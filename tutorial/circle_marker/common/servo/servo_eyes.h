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
 * What a servo looks through: a camera, simulated or real.
 */

#ifndef VP_TUTORIAL_SERVO_EYES_H
#define VP_TUTORIAL_SERVO_EYES_H

#include <functional>
#include <optional>

#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/core/vpImage.h>
#include <visp3/robot/vpSimulatorCamera.h>

#include "../visp_names.h"
#include "servo_scene.h"

namespace tutorial {
/*! An image for the servo, and what is known of it. */
struct ServoView
{
  vpImage<unsigned char> image;
  double time = 0.;                         //!< Seconds since the start.
  std::optional<vpHomogeneousMatrix> truth; //!< True pose of the object, if it is known.
  Covers covers;                            //!< What is covered, as far as it is known.
};

/*! Gives a servo its images. */
class ServoEyes
{
public:
  virtual ~ServoEyes() = default;

  /*!
    \param stop : Stops the robot; to be called when the next image is late: a robot must not go on blindly.
    \return The newest image; nothing when there will be no more.
    \exception std::runtime_error : If the camera has failed.
  */
  virtual std::optional<ServoView> look(const std::function<void()> &stop) = 0;
};

/*!
  The simulated camera on a simulated robot, whose world is the object's frame. Where the object has two markers, each
  is covered for a part of the way.
*/
class SimulatedEyes : public ServoEyes
{
public:
  /*!
    \param camera : The camera.
    \param object : What it looks at.
    \param robot : Carries the camera; must live as long as this.
    \param cdMo : The desired pose, the end of the way.
    \param seed : Of the noise.
    \param isRealTime : Whether images come no faster than the robot's sampling time, for those who watch, or as fast as
    they are asked for.
  */
  SimulatedEyes(const ServoCamera &camera, const ServoObject &object, const vpSimulatorCamera &robot,
                const vpHomogeneousMatrix &cdMo, std::uint64_t seed, bool isRealTime);

  std::optional<ServoView> look(const std::function<void()> &stop) override;

private:
  ServoCamera m_camera;             //!< The camera.
  ServoObject m_object;             //!< What it looks at.
  const vpSimulatorCamera &m_robot; //!< Carries it.
  vpHomogeneousMatrix m_cdMo;       //!< The desired pose.
  std::uint64_t m_seed;             //!< Of the noise.
  bool m_isRealTime;                //!< Whether images come at their time.
  double m_wholeWay;                //!< Length of the way from the start.
  unsigned int m_images = 0;        //!< Images so far.
  double m_last = 0.;               //!< When the last one came, ms.
};

/*! Makes a simulated robot fit for a servo, and puts the camera at a pose. */
void prepareRobot(vpSimulatorCamera &robot, const vpHomogeneousMatrix &cMo);

/*! Length of the way that is left: metres and radians count alike. */
double remainingWay(const vpHomogeneousMatrix &cdMo, const vpHomogeneousMatrix &cMo);
} // namespace tutorial

#endif
