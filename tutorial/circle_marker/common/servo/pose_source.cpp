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

#include "pose_source.h"

#include <vector>

#include "../moved_camera.h"

namespace tutorial {
namespace {
/*! AprilTag counts pixels from their corners: its points lie 0.5 pixels right of and below those of ViSP. */
vpCameraParameters forAprilTag(const vpCameraParameters &cam)
{
  constexpr double shift = 0.5;
  return movedPrincipalPoint(cam, shift, shift);
}
} // namespace

//! [Pose source]
PoseSource::PoseSource(const ServoObject &object, const vpCameraParameters &cam, const DetectorSettings &settings)
    : m_object(object), m_cam(cam), m_tagCam(forAprilTag(cam)), m_circleDetector(makeDetector(settings)),
      m_tagDetector(vpDetectorAprilTag::TAG_36h11)
{
  m_tagDetector.setZAlignedWithCameraAxis(true);
  m_tagDetector.setAprilTagQuadDecimate(1.f); // the whole resolution
}

ObjectSighting PoseSource::look(const vpImage<unsigned char> &I)
{
  ObjectSighting sighting;
  if (m_object.circle) {
    sighting.byCircle = lookForCircle(I);
  }
  if (m_object.aprilTag && !sighting.byCircle) {
    sighting.byAprilTag = lookForTag(I);
  }
  return sighting;
}

std::optional<vpHomogeneousMatrix> PoseSource::lookForCircle(const vpImage<unsigned char> &I)
{
  std::vector<vpHomogeneousMatrix> cMm;
  m_circleDetector.detect(I, m_object.circle->size, m_cam, cMm);
  const std::vector<int> ids = m_circleDetector.getTagsId();
  for (std::size_t i = 0; i < cMm.size(); ++i) {
    if (ids[i] == m_object.circle->id || m_object.circle->id == anyId) {
      return cMm[i] * m_object.circle->oMm.inverse();
    }
  }
  return std::nullopt;
}
//! [Pose source]

std::optional<vpHomogeneousMatrix> PoseSource::lookForTag(const vpImage<unsigned char> &I)
{
  std::vector<vpHomogeneousMatrix> cMm;
  m_tagDetector.detect(I, m_object.aprilTag->size, m_tagCam, cMm);
  const std::vector<int> ids = m_tagDetector.getTagsId();
  for (std::size_t i = 0; i < cMm.size(); ++i) {
    if (ids[i] == m_object.aprilTag->id) {
      return cMm[i] * m_object.aprilTag->oMm.inverse();
    }
  }
  return std::nullopt;
}
} // namespace tutorial
