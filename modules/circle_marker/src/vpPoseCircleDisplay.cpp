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
 * Display of a circle and its frame.
 */

#include <visp3/circle_marker/vpPoseCircle.h>

#include <cmath>
#include <optional>

#include "pose_display.h"

BEGIN_VISP_NAMESPACE

using namespace circle_marker;

namespace {
template <class ImageType>
void displayCircle(const ImageType &I, const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam, double radius,
                   const vpColor &color, unsigned int thickness)
{
  const CameraModel camera(cam);
  const int segments = 72; // 5 degrees each: the chord stays within a thousandth of the radius.
  std::optional<vpImagePoint> previous;
  for (int i = 0; i <= segments; i++) {
    const double t = 2. * M_PI * i / segments;
    const auto point = seenPoint(radius * Eigen::Vector3d(std::cos(t), std::sin(t), 0.), cMo, camera);
    if (previous && point) {
      vpDisplay::displayLine(I, *previous, *point, (color == vpColor::none) ? vpColor::green : color, thickness);
    }
    previous = point;
  }
  displayAxes(I, cMo, camera, radius, color, thickness);
}
} // namespace

/*!
  Displays the outline of a circle, with the camera's distortion, and its frame.
  \param I : Image whose display is drawn on. \param cMo : Pose of the circle. \param cam : Camera.
  \param radius : Radius of the circle and length of the frame's axes, metres.
  \param color : Color; vpColor::none: a green outline and axes in red, green and blue.
  \param thickness : Thickness of the lines, pixels.
*/
void vpPoseCircle::display(const vpImage<unsigned char> &I, const vpHomogeneousMatrix &cMo,
                           const vpCameraParameters &cam, double radius, const vpColor &color, unsigned int thickness)
{
  displayCircle(I, cMo, cam, radius, color, thickness);
}

/*! The same on a color image. */
void vpPoseCircle::display(const vpImage<vpRGBa> &I, const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam,
                           double radius, const vpColor &color, unsigned int thickness)
{
  displayCircle(I, cMo, cam, radius, color, thickness);
}

END_VISP_NAMESPACE
