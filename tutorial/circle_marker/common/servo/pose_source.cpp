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

#include <algorithm>
#include <vector>

#include <visp3/core/vpThetaUVector.h>

namespace tutorial {
namespace {
// What single images say of a circle's two poses adds up, but no further than this, natural logarithm of the odds: a
// later image that says as much is believed, whatever was thought before.
constexpr double mostOdds = 20.;

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

void PoseSource::forget()
{
  m_own.reset();
  m_last.reset();
  m_odds = 0.;
}

std::optional<vpHomogeneousMatrix> PoseSource::lookForCircle(const vpImage<unsigned char> &I)
{
  std::vector<vpHomogeneousMatrix> cMm;
  m_circleDetector.detect(I, m_object.circle->size, m_cam, cMm);
  const vpCircleMarkerDetection *seen = nullptr;
  const auto wayTo = [this](const vpCircleMarkerDetection &detection) {
    return distanceBetween(*m_last, detection.cMo * m_object.circle->oMm.inverse());
  };
  const auto isBetter = [&](const vpCircleMarkerDetection &p, const vpCircleMarkerDetection &q) {
    return m_last ? wayTo(p) < wayTo(q) : p.ellipse.a > q.ellipse.a;
  };
  for (const vpCircleMarkerDetection &detection : m_circleDetector.getDetections()) {
    if (isSought(detection) && (seen == nullptr || isBetter(detection, *seen))) {
      seen = &detection;
    }
  }
  if (seen == nullptr) {
    return std::nullopt;
  }
  m_own = {seen->family.getName(), seen->id};
  return poseFrom(*seen);
}

bool PoseSource::isSought(const vpCircleMarkerDetection &detection) const
{
  if (m_own) {
    return detection.family.getName() == m_own->first && detection.id == m_own->second;
  }
  return m_object.circle->id == anyId || detection.id == m_object.circle->id;
}

vpHomogeneousMatrix PoseSource::poseFrom(const vpCircleMarkerDetection &detection)
{
  const vpHomogeneousMatrix mMo = m_object.circle->oMm.inverse();
  const vpHomogeneousMatrix cMo = detection.cMo * mMo;
  const double odds = detection.hasSecondPose ? std::min(detection.logOdds, mostOdds) : mostOdds;
  if (detection.hasSecondPose && m_last) {
    const vpHomogeneousMatrix other = detection.cMo2 * mMo;
    if (angleBetween(*m_last, other) < angleBetween(*m_last, cMo)) { // the one before leans as the less likely one
      m_odds -= odds;
      if (m_odds > 0.) {
        return other;
      }
      m_odds = -m_odds;
      return cMo;
    }
  }
  m_odds = std::min(m_odds + odds, mostOdds);
  return cMo;
}
//! [Pose source]
} // namespace tutorial
