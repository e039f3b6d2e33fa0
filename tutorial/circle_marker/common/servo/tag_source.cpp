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
 * Sees the AprilTag of an object.
 */

#include "tag_source.h"

#include <vector>

#include <visp3/core/vpException.h>

#include "../moved_camera.h"

namespace tutorial {
#if defined(VISP_HAVE_APRILTAG)
namespace {
/*! AprilTag counts pixels from their corners: its points lie 0.5 pixels right of and below those of ViSP. */
vpCameraParameters forAprilTag(const vpCameraParameters &cam)
{
  constexpr double shift = 0.5;
  return movedPrincipalPoint(cam, shift, shift);
}
} // namespace

TagSource::TagSource(const MountedMarker &tag, const vpCameraParameters &cam)
    : m_tag(tag), m_cam(forAprilTag(cam)), m_detector(vpDetectorAprilTag::TAG_36h11)
{
  m_detector.setZAlignedWithCameraAxis(true);
  m_detector.setAprilTagQuadDecimate(1.f); // the whole resolution
}

std::optional<vpHomogeneousMatrix> TagSource::look(const vpImage<unsigned char> &I)
{
  std::vector<vpHomogeneousMatrix> cMm;
  m_detector.detect(I, m_tag.size, m_cam, cMm);
  const std::vector<int> ids = m_detector.getTagsId();
  for (std::size_t i = 0; i < cMm.size(); ++i) {
    if (ids[i] == m_tag.id) {
      return cMm[i] * m_tag.oMm.inverse();
    }
  }
  return std::nullopt;
}
#else
TagSource::TagSource(const MountedMarker &, const vpCameraParameters &)
{
  throw vpException(vpException::functionNotImplementedError,
                    "this ViSP was built without AprilTag; build it with WITH_APRILTAG, or leave the tag out");
}

std::optional<vpHomogeneousMatrix> TagSource::look(const vpImage<unsigned char> &)
{
  return std::nullopt;
}
#endif
} // namespace tutorial
