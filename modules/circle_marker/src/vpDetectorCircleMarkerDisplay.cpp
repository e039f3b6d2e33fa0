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
 * Overlays of the circular marker detector.
 */

#include <visp3/circle_marker/vpDetectorCircleMarker.h>

#include <visp3/core/vpDisplay.h>

#include "pose_display.h"

BEGIN_VISP_NAMESPACE

namespace {
template <class Pixel>
void displayOutlines(const vpImage<Pixel> &I, const std::vector<std::vector<vpImagePoint>> &outlines,
                     const std::vector<std::string> &messages, const std::vector<vpCircleMarkerDetection> &detections,
                     const vpColor &color, unsigned int thickness)
{
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    vpDisplay::displayPolygon(I, outlines[i], color == vpColor::none ? vpColor::green : color, thickness);
    vpDisplay::displayCross(I, detections[i].center, 12, vpColor::red, 1);
    vpDisplay::displayText(I, detections[i].center + vpImagePoint(-8., 10.), messages[i], vpColor::red);
  }
}

template <class Pixel>
void displayPolygons(const vpImage<Pixel> &I, const std::vector<std::vector<vpImagePoint>> &polygons,
                     const vpColor &color, unsigned int thickness)
{
  for (const std::vector<vpImagePoint> &polygon : polygons) {
    vpDisplay::displayPolygon(I, polygon, color == vpColor::none ? vpColor::green : color, thickness);
  }
}

template <class Pixel>
void displayAllFrames(const vpImage<Pixel> &I, const std::vector<vpHomogeneousMatrix> &poses,
                      const vpCameraParameters &cam, double size, const vpColor &color, unsigned int thickness)
{
  const circle_marker::CameraModel camera(cam);
  for (const vpHomogeneousMatrix &cMo : poses) {
    circle_marker::displayAxes(I, cMo, camera, 0.5 * size, color, thickness);
  }
}
} // namespace

/*!
  Draws the frames of markers: x in red, y in green, z in blue, each as long as the ring's radius.
  \param I : Image with a display.
  \param cMo_vec : Poses of the markers.
  \param cam : Camera.
  \param size : Outer diameter of the rings, metres.
  \param color : Colour of all axes; vpColor::none for red, green and blue.
  \param thickness : Of the lines, pixels.
*/
void vpDetectorCircleMarker::displayFrames(const vpImage<unsigned char> &I,
                                           const std::vector<vpHomogeneousMatrix> &cMo_vec,
                                           const vpCameraParameters &cam, double size, const vpColor &color,
                                           unsigned int thickness) const
{
  displayAllFrames(I, cMo_vec, cam, size, color, thickness);
}

/*! The same for a colour image. */
void vpDetectorCircleMarker::displayFrames(const vpImage<vpRGBa> &I, const std::vector<vpHomogeneousMatrix> &cMo_vec,
                                           const vpCameraParameters &cam, double size, const vpColor &color,
                                           unsigned int thickness) const
{
  displayAllFrames(I, cMo_vec, cam, size, color, thickness);
}

/*!
  Draws the outline, the centre and the message of each marker of the last detect().
  \param I : Image with a display.
  \param color : Colour of the outlines; vpColor::none for green.
  \param thickness : Of the lines, pixels.
*/
void vpDetectorCircleMarker::displayTags(const vpImage<unsigned char> &I, const vpColor &color,
                                         unsigned int thickness) const
{
  displayOutlines(I, m_polygon, m_message, getDetections(), color, thickness);
}

/*! The same for a colour image. */
void vpDetectorCircleMarker::displayTags(const vpImage<vpRGBa> &I, const vpColor &color, unsigned int thickness) const
{
  displayOutlines(I, m_polygon, m_message, getDetections(), color, thickness);
}

/*!
  Draws outlines that were kept, as vpDetectorAprilTag does.
  \param I : Image with a display.
  \param tagsCorners : What getTagsCorners() gave.
  \param color : Colour of the outlines; vpColor::none for green.
  \param thickness : Of the lines, pixels.
*/
void vpDetectorCircleMarker::displayTags(const vpImage<unsigned char> &I,
                                         const std::vector<std::vector<vpImagePoint>> &tagsCorners,
                                         const vpColor &color, unsigned int thickness) const
{
  displayPolygons(I, tagsCorners, color, thickness);
}

/*! The same for a colour image. */
void vpDetectorCircleMarker::displayTags(const vpImage<vpRGBa> &I,
                                         const std::vector<std::vector<vpImagePoint>> &tagsCorners,
                                         const vpColor &color, unsigned int thickness) const
{
  displayPolygons(I, tagsCorners, color, thickness);
}

END_VISP_NAMESPACE
