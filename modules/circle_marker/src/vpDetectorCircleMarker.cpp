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
 * Detection, identification and pose of circular markers.
 */

#include "vpDetectorCircleMarkerImpl.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <future>

#include <visp3/core/vpException.h>
#include <visp3/core/vpTime.h>

#include "pose/hypotheses.h"
#include "refine/measure.h"
#include "refine/report.h"

BEGIN_VISP_NAMESPACE

using namespace circle_marker;

namespace {
// Points of the polygon that vpDetectorBase keeps of each object.
constexpr unsigned int polygonPoints = 36;
// Size of a marker whose size was not told: poses are then in units of its diameter.
constexpr double unitSize = 1.;

// Inside a marker there is room for another one in its white centre only, of this radius in units of the ring's.
constexpr double whiteCenter = 0.4;

void checkImageSize(const vpImage<unsigned char> &I)
{
  constexpr unsigned int leastSide = 16; // pixels
  if (I.getWidth() < leastSide || I.getHeight() < leastSide) {
    throw vpException(vpException::dimensionError,
                      "vpDetectorCircleMarker: the image is %u x %u pixels; at least %u x %u are needed", I.getWidth(),
                      I.getHeight(), leastSide, leastSide);
  }
}

// A camera that is good enough to read codes with: ordinary lenses have a focal length of about the image's width.
vpCameraParameters nominalCamera(const vpImage<unsigned char> &I)
{
  const double focal = std::max(I.getWidth(), I.getHeight());
  return vpCameraParameters(focal, focal, 0.5 * (I.getWidth() - 1.), 0.5 * (I.getHeight() - 1.));
}

// The image fixes the poses up to the size: everything scales with it.
void scaleTo(double size, PosePair &poses)
{
  for (MarkerPlane &plane : poses) {
    plane.center *= 0.5 * size / plane.radius;
    plane.radius = 0.5 * size;
  }
}
} // namespace

/*!
  The pipeline: an image goes through the rooms once, in this order. Two outlines never depend on one another but
  that nothing is sought inside the code of a marker, so several threads find what one finds.
*/
void vpDetectorCircleMarker::Impl::detect(const vpImage<unsigned char> &I, double size, const vpCameraParameters &cam,
                                          double deadline)
{
  found.clear();
  image = I;
  const CameraModel camera(cam);
  const std::vector<EllipseCandidate> &outlines = findOutlines(image, settings.threads > 1, m_outlines);
  outlineCount = static_cast<unsigned int>(outlines.size());
  std::vector<std::optional<Found>> examined;
  if (settings.threads > 1) {
    examined = examineAll(outlines, size, camera, deadline);
  }
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    if (isPartOfFound(outlines[i].ellipse)) {
      continue;
    }
    if (examined.empty() && vpTime::measureTimeMs() > deadline) {
      break;
    }
    auto marker = examined.empty() ? examine(outlines[i], size, camera, m_pixels) : std::move(examined[i]);
    if (marker) {
      found.push_back(std::move(*marker));
    }
  }
  detections.clear();
  for (const Found &marker : found) {
    detections.push_back(marker.detection);
  }
}

/*! One outline through the rooms after the outlines: pose, decode, refine. */
std::optional<vpDetectorCircleMarker::Impl::Found>
vpDetectorCircleMarker::Impl::examine(const EllipseCandidate &outline, double size, const CameraModel &camera,
                                      std::vector<FitPixel> &pixels) const
{
  const auto poses = posesFromOutline(outline.points, camera, 0.5 * size);
  if (!poses) {
    return std::nullopt;
  }
  for (const vpCircleMarkerFamily &family : settings.families) {
    auto marker = recognise(image, camera, *poses, outline, family, settings.decode);
    if (!marker) {
      continue;
    }
    const auto known = settings.sizes.find(marker->code.id);
    if (known != settings.sizes.end()) {
      scaleTo(known->second, marker->poses);
    }
    if (const auto measurement = measure(image, camera, *marker, settings.refinePose, pixels)) {
      return Found{reportOf(*marker, *measurement, camera, outline.support, settings.zAlignedWithCameraAxis), *marker,
                   outline, outlineOf(measurement->first.plane, camera, polygonPoints)};
    }
  }
  return std::nullopt;
}

/*! All outlines, shared among the threads; those that the deadline leaves no time for are left empty. */
std::vector<std::optional<vpDetectorCircleMarker::Impl::Found>>
vpDetectorCircleMarker::Impl::examineAll(const std::vector<EllipseCandidate> &outlines, double size,
                                         const CameraModel &camera, double deadline) const
{
  std::vector<std::optional<Found>> examined(outlines.size());
  std::atomic<std::size_t> next(0);
  const auto work = [&]() {
    std::vector<FitPixel> pixels;
    for (std::size_t i = next++; i < outlines.size() && vpTime::measureTimeMs() <= deadline; i = next++) {
      examined[i] = examine(outlines[i], size, camera, pixels);
    }
  };
  std::vector<std::future<void>> workers;
  for (unsigned int i = 0; i < settings.threads; ++i) {
    workers.push_back(std::async(std::launch::async, work));
  }
  for (std::future<void> &worker : workers) {
    worker.get(); // passes on what a worker has thrown
  }
  return examined;
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
  const auto marker = recognise(image, camera, *poses, known.outline, known.marker.family, settings.decode);
  if (!marker || marker->code.id != known.marker.code.id) {
    return std::nullopt;
  }
  const auto measurement = measure(image, camera, *marker, settings.refinePose, m_pixels);
  if (!measurement) {
    return std::nullopt;
  }
  return reportOf(*marker, *measurement, camera, known.outline.support, settings.zAlignedWithCameraAxis);
}

/*! Whether an outline is a piece of a marker that is known already: its code, or its ring again. */
bool vpDetectorCircleMarker::Impl::isPartOfFound(const EllipseParameters &ellipse) const
{
  for (const Found &known : found) {
    const vpImageEllipse &outer = known.detection.ellipse;
    const Eigen::Vector2d center(outer.center.get_u(), outer.center.get_v());
    const Eigen::Vector2d offset = Eigen::Rotation2Dd(-outer.angle) * (ellipse.center - center);
    // Affine image of the ring as the unit circle: distance of the centres, and the larger reach of the outline.
    const double distance = Eigen::Vector2d(offset.x() / outer.a, offset.y() / outer.b).norm();
    const double reach = distance + ellipse.a / outer.a;
    const double room = known.marker.family.getType() == vpCircleMarkerFamily::DISC ? 0. : whiteCenter;
    if (distance < 1. && reach > room) {
      return true;
    }
  }
  return false;
}

const vpDetectorCircleMarker::Impl::Found &vpDetectorCircleMarker::Impl::at(std::size_t index) const
{
  if (index >= found.size()) {
    throw vpException(vpException::badValue, "vpDetectorCircleMarker: there is no marker %lu; the last image has %lu",
                      static_cast<unsigned long>(index), static_cast<unsigned long>(found.size()));
  }
  return found[index];
}

/*!
  \param family : Family to look for.
*/
vpDetectorCircleMarker::vpDetectorCircleMarker(const vpCircleMarkerFamily &family) : m_impl(new Impl)
{
  m_impl->settings.families = {family};
}

/*!
  \param family : Family to look for.
*/
vpDetectorCircleMarker::vpDetectorCircleMarker(vpCircleMarkerFamily::vpType family)
    : vpDetectorCircleMarker(vpCircleMarkerFamily(family))
{
}

vpDetectorCircleMarker::vpDetectorCircleMarker(const vpDetectorCircleMarker &other)
    : vpDetectorBase(other), m_impl(new Impl(*other.m_impl))
{
}

vpDetectorCircleMarker &vpDetectorCircleMarker::operator=(const vpDetectorCircleMarker &other)
{
  if (this != &other) {
    m_polygon = other.m_polygon;
    m_message = other.m_message;
    m_nb_objects = other.m_nb_objects;
    m_timeout_ms = other.m_timeout_ms;
    m_impl.reset(new Impl(*other.m_impl));
  }
  return *this;
}

vpDetectorCircleMarker::~vpDetectorCircleMarker() = default;

/*!
  Finds and reads the markers of an image whose camera is not known. Their poses are then to be had from getPose();
  those in getDetections() belong to a nominal camera and a marker of 1 m.

  \param I : Grey level image.
  \return Whether a marker was found.
  \exception vpException::dimensionError : If the image is smaller than 16 x 16 pixels.
*/
bool vpDetectorCircleMarker::detect(const vpImage<unsigned char> &I)
{
  checkImageSize(I);
  std::vector<vpHomogeneousMatrix> poses;
  return detect(I, unitSize, nominalCamera(I), poses);
}

/*!
  Finds the markers of an image, reads their codes and computes their poses.

  \param I : Grey level image.
  \param size : Outer diameter of the ring, metres, for markers without a size of their own (setMarkerSizes()).
  \param cam : Camera, with any of ViSP's projection models.
  \param cMo_vec : Pose of each marker, the likelier solution.
  \param cMo_vec2 : If not null, the other solution; equal to the first if there is none.
  \param projErrors : If not null, negative log-likelihood of each pose, up to a constant common to both solutions.
  \param projErrors2 : If not null, the same for the other solution, HUGE_VAL if there is none.
  \return Whether a marker was found.
  \exception vpException::dimensionError : If the image is smaller than 16 x 16 pixels.
  \exception vpException::badValue : If the size is not positive.
*/
bool vpDetectorCircleMarker::detect(const vpImage<unsigned char> &I, double size, const vpCameraParameters &cam,
                                    std::vector<vpHomogeneousMatrix> &cMo_vec,
                                    std::vector<vpHomogeneousMatrix> *cMo_vec2, std::vector<double> *projErrors,
                                    std::vector<double> *projErrors2)
{
  circle_marker::checkMarkerSize(size);
  checkImageSize(I);
  const double deadline = m_timeout_ms > 0 ? vpTime::measureTimeMs() + static_cast<double>(m_timeout_ms) : HUGE_VAL;
  m_impl->detect(I, size, cam, deadline);
  const auto fill = [this](auto *output, auto value) {
    if (output == nullptr) {
      return;
    }
    output->clear();
    for (const vpCircleMarkerDetection &detection : m_impl->detections) {
      output->push_back(value(detection));
    }
  };
  using Detection = vpCircleMarkerDetection;
  fill(&cMo_vec, [](const Detection &d) { return d.cMo; });
  fill(cMo_vec2, [](const Detection &d) { return d.hasSecondPose ? d.cMo2 : d.cMo; });
  fill(projErrors, [](const Detection &d) { return d.cost; });
  fill(projErrors2, [](const Detection &d) { return d.cost2; });
  fill(&m_message, [](const Detection &d) {
    return d.family.isCoded() ? d.family.getName() + " id: " + std::to_string(d.id) : d.family.getName();
  });
  m_nb_objects = m_impl->detections.size();
  m_polygon.clear();
  for (std::size_t i = 0; i < m_nb_objects; ++i) {
    m_polygon.push_back(m_impl->found[i].polygon);
  }
  if (m_impl->displayTag) {
    displayTags(I, m_impl->displayColor, m_impl->displayThickness);
  }
  return m_nb_objects > 0;
}

/*!
  Pose of a marker of the last image for a given size and camera.

  \param index : Index of the marker, from 0 to getNbObjects() - 1.
  \param size : Outer diameter of its ring, metres.
  \param cam : Camera.
  \param cMo : Its pose, the likelier solution.
  \param cMo2 : If not null, the other solution; equal to the first if there is none.
  \param projError : If not null, negative log-likelihood of cMo up to a constant common to both.
  \param projError2 : If not null, the same for cMo2, HUGE_VAL if there is none.
  \return Whether the pose could be computed with this camera.
  \exception vpException::badValue : If there is no such marker, or the size is not positive.
*/
bool vpDetectorCircleMarker::getPose(size_t index, double size, const vpCameraParameters &cam, vpHomogeneousMatrix &cMo,
                                     vpHomogeneousMatrix *cMo2, double *projError, double *projError2)
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
  return true;
}

END_VISP_NAMESPACE
