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
 * Poses of the markers of the last image, for another size or camera.
 */

#include "vpDetectorCircleMarkerImpl.h"

#include <algorithm>

#include "detect_covered.h"
#include "pose/hypotheses.h"

BEGIN_VISP_NAMESPACE

using namespace circle_marker;

/*! What of an image measuring a marker may look at. */
PixelBox vpDetectorCircleMarker::Impl::surroundingsOf(const EllipseCandidate &outline,
                                                      const vpCircleMarkerFamily &family,
                                                      const vpImage<unsigned char> &I)
{
  constexpr double leastShare = 0.5; // of the radius; the quiet zone has a sixth, and more at the corners of its sheet
  constexpr double ofQuietZone = 2.2;
  constexpr double leastMargin = 32.; // pixels: the widest blur the refinement knows, and interpolation
  const double share = std::max(leastShare, ofQuietZone * family.getLayout().quietZone);
  return boxAround(outline.ellipse, share * outline.ellipse.a + leastMargin, static_cast<int>(I.getWidth()),
                   static_cast<int>(I.getHeight()));
}

/*!
  Keeps what getPose() looks at of the image: its markers and what surrounds them. A copy of the whole takes as long as
  a tenth of the search.
*/
void vpDetectorCircleMarker::Impl::keepSurroundings(const vpImage<unsigned char> &I)
{
  if (image.getHeight() != I.getHeight() || image.getWidth() != I.getWidth()) {
    image.resize(I.getHeight(), I.getWidth(), 0); // the assignment of images would allocate each time
  }
  for (const Found &marker : found) {
    const PixelBox box = surroundingsOf(marker.outline, marker.marker.family, I);
    for (int y = box.top; y < box.bottom; ++y) {
      const unsigned char *row = I[static_cast<unsigned int>(y)];
      std::copy(row + box.left, row + box.right, image[static_cast<unsigned int>(y)] + box.left);
    }
  }
}

/*! The pose of a marker for another size or camera, from its outline and the image it was found in. */
std::optional<vpCircleMarkerDetection> vpDetectorCircleMarker::Impl::measureAgain(std::size_t index, double size,
                                                                                  const vpCameraParameters &cam)
{
  const CameraModel camera(cam);
  const Found &known = at(index);
  const auto poses = posesFromOutline(known.outline.points, camera, 0.5 * size);
  if (!poses) {
    return std::nullopt;
  }
  m_workspaces.resize(std::max<std::size_t>(m_workspaces.size(), 1));
  Workspace &workspace = m_workspaces.front();
  const vpImage<unsigned char> &kept = known.detection.isInverse ? m_inverse.front().image : image;
  const vpCircleMarkerFamily &family = known.marker.family;
  const Deadline never;
  const Visit visit = {kept, size, camera, never, known.noise, true};
  OutlineInImage seen(kept, camera, *poses, known.outline);
  std::vector<Attempt> attempts;
  listAttempts({family}, attempts);
  for (const Attempt &attempt : attempts) {
    std::optional<Recognition> marker;
    if (attempt.kind != ReadingKind::WHOLE) {
      marker = readInDoubt(visit, seen, family, attempt.kind);
      if (marker && attempt.kind == ReadingKind::COVERED && family.isCoded()) {
        marker = recogniseByMeasuredRing(kept, camera, *marker, family, settings.decode, workspace.measuring, never,
                                         known.noise);
      }
    }
    else if (auto whole = recognise(seen, family, settings.decode, nullptr, known.mayBeBlurred)) {
      marker = std::move(*whole);
    }
    Found measured;
    const bool isMeasured = marker && measureMarker(visit, known.outline, *marker, workspace, measured);
    if (isMeasured &&
        measured.detection.id == known.detection.id) { // a proof may have made another one of what was read
      measured.detection.isInverse = known.detection.isInverse;
      return measured.detection;
    }
  }
  return std::nullopt;
}

/*!
  Pose of a marker of the last image for a given size and camera, as the detector is set now: where poses are not
  refined or no sectors corrected any more, one that was found with them may have none.

  \param index : Index of the marker, from 0 to getNbObjects() - 1.
  \param size : Outer diameter of its ring, metres.
  \param cam : Camera.
  \param cMo : Its pose, the likelier solution.
  \param cMo2 : If not null, the other solution; equal to the first if there is none.
  \param projError : If not null, negative log-likelihood of cMo up to a constant common to both.
  \param projError2 : If not null, that plus the log-odds of cMo, HUGE_VAL if there is no other solution.
  \param covariance : If not null, that of cMo, 6 x 6: see vpCircleMarkerDetection.
  \param covariance2 : If not null, that of cMo2, zero if there is none.
  \return Whether the pose could be computed with this camera and these settings. The time of setTimeout() is that of
  detect() alone.
  \exception vpException::badValue : If there is no such marker, or the size is not positive.
*/
bool vpDetectorCircleMarker::getPose(size_t index, double size, const vpCameraParameters &cam, vpHomogeneousMatrix &cMo,
                                     vpHomogeneousMatrix *cMo2, double *projError, double *projError2,
                                     vpMatrix *covariance, vpMatrix *covariance2)
{
  circle_marker::checkMarkerSize(size);
  const auto detection = m_impl->measureAgain(index, size, cam);
  if (!detection) {
    return false;
  }
  cMo = detection->cMo;
  if (cMo2 != nullptr) {
    *cMo2 = detection->hasSecondPose ? detection->cMo2 : detection->cMo;
  }
  if (projError != nullptr) {
    *projError = detection->cost;
  }
  if (projError2 != nullptr) {
    *projError2 = detection->cost2;
  }
  if (covariance != nullptr) {
    *covariance = detection->covariance;
  }
  if (covariance2 != nullptr) {
    *covariance2 = detection->covariance2;
  }
  return true;
}

END_VISP_NAMESPACE
