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
 * What was seen of the target in the pictures.
 */

#ifndef VP_CALIBRATE_VIEW_H
#define VP_CALIBRATE_VIEW_H

#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace calibrate {
/*! A point of the target in a picture. */
struct Observation
{
  std::size_t point = 0; //!< Index among the target's points.
  Eigen::Vector2d pixel; //!< A corner; of a circle the centre of its image (ellipse), not the image of its centre.
};

/*! One picture. */
struct View
{
  std::string name;
  unsigned int width = 0;  //!< Pixels.
  unsigned int height = 0; //!< Pixels.
  std::vector<Observation> observations;
};

/*! Pose of the target in the camera's frame, metres. */
struct TargetPose
{
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();

  Eigen::Vector3d operator*(const Eigen::Vector2d &place) const
  {
    return rotation * Eigen::Vector3d(place.x(), place.y(), 0.) + translation;
  }
  /*! Moved by a small translation, then a small rotation vector (camera frame). */
  TargetPose moved(const Eigen::Matrix<double, 6, 1> &step) const
  {
    const double angle = step.tail<3>().norm();
    TargetPose pose = *this;
    if (angle > 0.) {
      pose.rotation = Eigen::AngleAxisd(angle, step.tail<3>() / angle).toRotationMatrix() * rotation;
    }
    pose.translation += step.head<3>();
    return pose;
  }
};
} // namespace calibrate

#endif
