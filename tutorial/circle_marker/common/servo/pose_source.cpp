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

#include <visp3/core/vpThetaUVector.h>

namespace tutorial {
namespace {
// Natural logarithm of the odds below which the image before tells better which of a circle's two poses is right.
constexpr double doubtfulOdds = 5.;

double distanceBetween(const vpHomogeneousMatrix &p, const vpHomogeneousMatrix &q)
{
  return (p.getTranslationVector() - q.getTranslationVector()).frobeniusNorm();
}

double angleBetween(const vpHomogeneousMatrix &p, const vpHomogeneousMatrix &q)
{
  return vpThetaUVector(p.getRotationMatrix().t() * q.getRotationMatrix()).getTheta();
}
} // namespace

//! [Pose source]
PoseSource::PoseSource(const ServoObject &object, const vpCameraParameters &cam, const DetectorSettings &settings)
    : m_object(object), m_cam(cam), m_circleDetector(makeDetector(settings))
{
  if (object.aprilTag) {
    m_tag.emplace(*object.aprilTag, cam);
  }
}

ObjectSighting PoseSource::look(const vpImage<unsigned char> &I)
{
  ObjectSighting sighting;
  if (m_object.circle) {
    sighting.byCircle = lookForCircle(I);
  }
  if (m_tag && !sighting.byCircle) {
    sighting.byAprilTag = m_tag->look(I);
  }
  if (sighting.best()) {
    m_last = sighting.best();
  }
  return sighting;
}

std::optional<vpHomogeneousMatrix> PoseSource::lookForCircle(const vpImage<unsigned char> &I)
{
  std::vector<vpHomogeneousMatrix> cMm;
  m_circleDetector.detect(I, m_object.circle->size, m_cam, cMm);
  std::optional<vpHomogeneousMatrix> nearest;
  const vpCircleMarkerDetection *seen = nullptr;
  for (const vpCircleMarkerDetection &detection : m_circleDetector.getDetections()) {
    if (!isSought(detection)) {
      continue;
    }
    const vpHomogeneousMatrix cMo = poseFrom(detection);
    const bool isNearer = nearest && m_last && distanceBetween(*m_last, cMo) < distanceBetween(*m_last, *nearest);
    if (!nearest || isNearer) { // at first, the largest
      nearest = cMo;
      seen = &detection;
    }
  }
  if (seen != nullptr) {
    m_own = {seen->family.getName(), seen->id};
  }
  return nearest;
}

bool PoseSource::isSought(const vpCircleMarkerDetection &detection) const
{
  if (m_own) {
    return detection.family.getName() == m_own->first && detection.id == m_own->second;
  }
  return m_object.circle->id == anyId || detection.id == m_object.circle->id;
}

vpHomogeneousMatrix PoseSource::poseFrom(const vpCircleMarkerDetection &detection) const
{
  const vpHomogeneousMatrix mMo = m_object.circle->oMm.inverse();
  const vpHomogeneousMatrix cMo = detection.cMo * mMo;
  if (!detection.hasSecondPose || detection.logOdds >= doubtfulOdds || !m_last) {
    return cMo;
  }
  const vpHomogeneousMatrix other = detection.cMo2 * mMo;
  return angleBetween(*m_last, other) < angleBetween(*m_last, cMo) ? other : cMo;
}
//! [Pose source]
} // namespace tutorial
