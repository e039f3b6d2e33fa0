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
 * The object's pose from an image, by the circular marker or the AprilTag.
 */

#ifndef VP_TUTORIAL_POSE_SOURCE_H
#define VP_TUTORIAL_POSE_SOURCE_H

#include <optional>

#include <visp3/circle_marker/vpDetectorCircleMarker.h>
#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/core/vpImage.h>
#include <visp3/detection/vpDetectorAprilTag.h>

#include "../detection/detector_options.h"
#include "../visp_names.h"
#include "servo_scene.h"

namespace tutorial {
/*! Pose of the object, z into the markers, from the marker that was seen. */
struct ObjectSighting
{
  std::optional<vpHomogeneousMatrix> byCircle;
  std::optional<vpHomogeneousMatrix> byAprilTag;

  /*! The pose, if there is one. */
  const std::optional<vpHomogeneousMatrix> &best() const { return byCircle ? byCircle : byAprilTag; }
  /*! Which marker it is from: circle, apriltag or none. */
  const char *usedDetector() const { return byCircle ? "circle" : (byAprilTag ? "apriltag" : "none"); }
};

/*!
  Sees the object's markers.
*/
class PoseSource
{
public:
  /*!
    \param object : What is looked for.
    \param cam : The camera.
    \param settings : How the circular marker is looked for; its size is the object's.
  */
  PoseSource(const ServoObject &object, const vpCameraParameters &cam, const DetectorSettings &settings);

  /*!
    \return The object's pose from what is seen in an image. The tag is looked for where the circular marker is not
    seen: it takes more time and is less accurate.
  */
  ObjectSighting look(const vpImage<unsigned char> &I);

private:
  std::optional<vpHomogeneousMatrix> lookForCircle(const vpImage<unsigned char> &I);
  std::optional<vpHomogeneousMatrix> lookForTag(const vpImage<unsigned char> &I);

  ServoObject m_object;                    //!< What is looked for.
  vpCameraParameters m_cam;                //!< The camera.
  vpCameraParameters m_tagCam;             //!< The camera, for AprilTag's pixels.
  vpDetectorCircleMarker m_circleDetector; //!< Finds the circular marker.
  vpDetectorAprilTag m_tagDetector;        //!< Finds the AprilTag.
};
} // namespace tutorial

#endif
