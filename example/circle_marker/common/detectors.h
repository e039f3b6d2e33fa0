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
 * The detectors that are compared, as a user calls them.
 */

#ifndef VP_COMMON_DETECTORS_H
#define VP_COMMON_DETECTORS_H

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <visp3/circle_marker/vpDetectorCircleMarker.h>
#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/core/vpImage.h>

#include "visp_names.h"

namespace common {
/*! What a detector made of an image with one marker. */
struct Sighting
{
  std::optional<vpHomogeneousMatrix> cMo; //!< Pose of the marker, z into it, metres; nothing: not found.
  unsigned int wrongIds = 0;              //!< Markers found that are not there.
  double cpuTime = 0.;                    //!< Of this thread for detection and pose, the image in memory, seconds.
};

/*! The circular markers of this project. Not to be used by two threads at once. */
class CircleDetector
{
public:
  /*! \e size: Outer diameter of the ring, metres. */
  CircleDetector(const vpCircleMarkerFamily &family, double size);

  /*! What the detector is told of the camera's calibration: see vpDetectorCircleMarker. */
  void setCameraCovariance(const vpMatrix &covariance) { m_detector.setCameraCovariance(covariance); }

  /*! Looks for the marker of an id, -1 in a family without code. */
  Sighting look(const vpImage<unsigned char> &I, const vpCameraParameters &cam, int id);

  /*! All the detector knows of the marker that it looked for last, if it found it. */
  const std::optional<vpCircleMarkerDetection> &last() const { return m_last; }

  /*! Ellipses of the last image that might have been a ring. */
  unsigned int outlines() const { return m_detector.getNbOutlines(); }

private:
  double m_size;                                 //!< Outer diameter of the ring, metres.
  unsigned int m_readyFor = 0;                   //!< Pixels of an image for which there is memory.
  std::optional<vpCircleMarkerDetection> m_last; //!< Of the last image.
  vpDetectorCircleMarker m_detector;             //!< Settings and working memory.
};

/*! What vpDetectorAprilTag makes of an image: with the camera as it is, and corrected by half a pixel. */
struct AprilTagSightings
{
  Sighting asDelivered, halfPixel;
};

/*! ViSP's detector of AprilTag 36h11. Not to be used by two threads at once. */
class AprilTagDetector
{
public:
  /*!
    \param size : Side of the black square, metres.
    \param poseMethod : One of tagPoseMethods().
    \param decimation : 1, or 2 for the search at half the image's size.
    \exception vpException::functionNotImplementedError : If ViSP was built without AprilTag.
    \exception vpException::badValue : If the pose method is not known.
  */
  AprilTagDetector(double size, const std::string &poseMethod, float decimation);
  AprilTagDetector(AprilTagDetector &&) noexcept;
  ~AprilTagDetector();

  /*! Looks for the marker of an id. The image is searched once; each pose is charged with the whole search. */
  AprilTagSightings look(const vpImage<unsigned char> &I, const vpCameraParameters &cam, int id);

private:
  class Impl;
  std::unique_ptr<Impl> m_impl; //!< ViSP's detector, where there is one.
};

/*! The most accurate of ViSP's ways from a tag's corners to its pose: see circle-marker-compare-apriltag --help. */
constexpr const char *bestTagPose = "HOMOGRAPHY_VIRTUAL_VS";

/*! The names of ViSP's ways from a tag's corners to its pose; empty if ViSP was built without AprilTag. */
std::vector<std::string> tagPoseMethods();
} // namespace common

#endif
