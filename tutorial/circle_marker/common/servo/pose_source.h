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
#include <string>
#include <utility>

#include <visp3/circle_marker/vpDetectorCircleMarker.h>
#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/core/vpImage.h>

#include "../detection/detector_options.h"
#include "../visp_names.h"
#include "servo_scene.h"
#include "tag_source.h"

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
  Sees the object's markers. A servo begins with the largest image of a marker and goes on with that; and which of a
  circle's two poses is right it is told by all images since, not by one.
*/
class PoseSource
{
public:
  /*!
    \param object : What is looked for.
    \param cam : The camera.
    \param settings : How the circular marker is looked for; its size is the object's.
    \exception vpException : If the object has an AprilTag and ViSP was built without.
  */
  PoseSource(const ServoObject &object, const vpCameraParameters &cam, const DetectorSettings &settings);

  /*!
    \return The object's pose from what is seen in an image. The tag is looked for where the circular marker is not
    seen: it takes more time and is less accurate.
  */
  ObjectSighting look(const vpImage<unsigned char> &I);

  /*! Begins anew: while a servo is held the camera may be pointed at anything. */
  void forget();

private:
  std::optional<vpHomogeneousMatrix> lookForCircle(const vpImage<unsigned char> &I);
  bool isSought(const vpCircleMarkerDetection &detection) const;
  vpHomogeneousMatrix poseFrom(const vpCircleMarkerDetection &detection);

  ServoObject m_object;                             //!< What is looked for.
  vpCameraParameters m_cam;                         //!< The camera.
  vpDetectorCircleMarker m_circleDetector;          //!< Finds the circular marker.
  std::optional<TagSource> m_tag;                   //!< Finds the AprilTag, if there is one.
  std::optional<std::pair<std::string, int>> m_own; //!< Family and id of the circular marker that it has begun with.
  std::optional<vpHomogeneousMatrix> m_last;        //!< The object's pose when it was last seen.
  double m_odds = 0.;                               //!< ln(odds) of that against the circle's other one, by all images.
};
} // namespace tutorial

#endif
