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
#include <memory>
#include <utility>

#include <visp3/core/vpException.h>

#include "debug_record.h"

BEGIN_VISP_NAMESPACE

using namespace circle_marker;

namespace {
// Size of a marker whose size was not told: poses are then in units of its diameter.
constexpr double unitSize = 1.;

void checkImageSize(const vpImage<unsigned char> &I)
{
  constexpr unsigned int leastSide = 16;   // pixels
  constexpr unsigned int mostSide = 32767; // places of edge pixels are numbers of 16 bits
  const auto [shorter, longer] = std::minmax({I.getWidth(), I.getHeight()});
  if (shorter < leastSide || longer > mostSide) {
    throw vpException(vpException::dimensionError,
                      "vpDetectorCircleMarker: the image is %u x %u pixels; its sides must have %u to %u", I.getWidth(),
                      I.getHeight(), leastSide, mostSide);
  }
}

// A camera that is good enough to read codes with: ordinary lenses have a focal length of about the image's width.
vpCameraParameters nominalCamera(const vpImage<unsigned char> &I)
{
  const double focal = std::max(I.getWidth(), I.getHeight());
  return vpCameraParameters(focal, focal, 0.5 * (I.getWidth() - 1.), 0.5 * (I.getHeight() - 1.));
}

// As vpDetectorAprilTag's, and what the database knows of the marker.
void putMessage(const vpCircleMarkerDetection &d, const vpCircleMarkerEntry *entry, std::string &message)
{
  message = d.family.getName();
  if (d.family.isCoded()) {
    message += " id: ";
    message += std::to_string(d.id);
  }
  if (entry != nullptr && !entry->name.empty()) {
    message += " name: " + entry->name;
  }
  if (entry != nullptr && !entry->payload.empty()) {
    message += " payload: " + entry->payload;
  }
}
} // namespace

/*!
  The pipeline: an image goes through the rooms once, in this order. Whatever the number of threads, each outline is
  looked at on its own and what is chosen among them is chosen in their order: the results are the same.
*/
void vpDetectorCircleMarker::Impl::detectBlack(const vpImage<unsigned char> &I, double size,
                                               const vpCameraParameters &cam, bool isCameraGuessed,
                                               const Deadline &deadline)
{
  m_workers.setCount(settings.threads);
  m_workspaces.resize(m_workers.getCount());
  const CameraModel camera(cam);
  const Visit visit = {I, size, camera, deadline, m_outlines.full.gradient.noise, false, nullptr, isCameraGuessed};
  m_inRegions.clear();
  m_hadRegions = false;
  if (!searchRegions(visit)) {
    searchWhole(visit);
  }
  // Assigned, not made anew: ViSP's matrices then keep their memory.
  std::size_t count = 0;
  for (const Examination &examination : m_examinations) {
    if (examination.isFound) {
      if (count == found.size()) {
        found.emplace_back();
        detections.emplace_back();
      }
      found[count] = m_measured[examination.place];
      detections[count] = found[count].detection;
      ++count;
    }
  }
  found.resize(count);
  detections.resize(count);
  keepSurroundings(I);
}

/*! What the markers of the families have in their centre. */
SoughtCenters vpDetectorCircleMarker::Impl::soughtCenters() const
{
  const auto isDisc = [](const vpCircleMarkerFamily &family) { return family.getType() == vpCircleMarkerFamily::DISC; };
  SoughtCenters sought;
  sought.dark = std::any_of(settings.families.begin(), settings.families.end(), isDisc);
  sought.bright = !std::all_of(settings.families.begin(), settings.families.end(), isDisc);
  for (const vpCircleMarkerFamily &family : settings.families) {
    if (family.getType() != vpCircleMarkerFamily::DISC) {
      sought.thinRing = std::max(sought.thinRing, family.getLayout().ringInner);
    }
  }
  return sought;
}

/*! Looks for markers in the whole image. */
void vpDetectorCircleMarker::Impl::searchWhole(const Visit &visit)
{
  const vpImage<unsigned char> &I = visit.I;
  m_outlines.keepsRefusals(keepsDebug);
  const Outlines &outlines = findOutlines(I, soughtCenters(), m_workers, visit.deadline, m_outlines);
  outlineCount = static_cast<unsigned int>(outlines.size());
  searched.assign(1, vpRect(0., 0., I.getWidth(), I.getHeight()));
  debug = vpCircleMarkerDebug();
  if (keepsDebug) {
    recordOutlines(m_outlines, vpImagePoint(0., 0.), debug);
  }
  examineAll(visit, outlines);
  if (settings.tracking) {
    keepSeen(outlines);
    followSeen(visit);
  }
}

/*! The marker of an index; throws vpException::badValue if there is none. */
const vpDetectorCircleMarker::Impl::Found &vpDetectorCircleMarker::Impl::at(std::size_t index) const
{
  if (index >= found.size()) {
    throw vpException(vpException::badValue, "vpDetectorCircleMarker: there is no marker %lu; the last image has %lu",
                      static_cast<unsigned long>(index), static_cast<unsigned long>(found.size()));
  }
  return found[index];
}

/*! As if no image had been seen: what an image that was not finished has left is of no use. */
void vpDetectorCircleMarker::Impl::forgetResults() noexcept
{
  found.clear();
  detections.clear();
  outlineCount = 0;
  hasTimedOut = false;
  searched.clear();
  debug = vpCircleMarkerDebug();
  m_inverse.clear();
  forgetTracks();
}

/*!
  \param family : Family to look for. It can be replaced later by setFamily() or setFamilies().
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

/*!
  Copies settings and results.
  \param other : Detector to copy.
*/
vpDetectorCircleMarker::vpDetectorCircleMarker(const vpDetectorCircleMarker &other)
    : vpDetectorBase(other), m_impl(new Impl(*other.m_impl))
{
}

/*!
  Copies settings and results.
  \param other : Detector to copy.
*/
vpDetectorCircleMarker &vpDetectorCircleMarker::operator=(const vpDetectorCircleMarker &other)
{
  if (this != &other) {
    // Copied first: if there is no memory for a copy, this one stays as it is.
    auto impl = std::make_unique<Impl>(*other.m_impl);
    auto polygon = other.m_polygon;
    auto message = other.m_message;
    m_impl = std::move(impl);
    m_polygon = std::move(polygon);
    m_message = std::move(message);
    m_nb_objects = other.m_nb_objects;
    m_timeout_ms = other.m_timeout_ms;
  }
  return *this;
}

vpDetectorCircleMarker::~vpDetectorCircleMarker() = default;

/*!
  Finds and reads the markers of an image whose camera is not known. Their poses are then to be had from getPose();
  those in getDetections() belong to a nominal camera, and to a marker of 1 m unless setMarkerSizes() or the database
  know it.

  \param I : Grey level image.
  \return Whether a marker was found.
  \exception vpException::dimensionError : If the image has a side of less than 16 or more than 32767 pixels.
  \exception vpException::fatalError : If the system does not give the threads of setNbThreads().
*/
bool vpDetectorCircleMarker::detect(const vpImage<unsigned char> &I)
{
  checkImageSize(I);
  std::vector<vpHomogeneousMatrix> poses;
  constexpr bool isCameraGuessed = true;
  return detectWith(I, unitSize, nominalCamera(I), isCameraGuessed, poses, nullptr, nullptr, nullptr);
}

/*!
  Finds the markers of an image, reads their codes and computes their poses.

  \param I : Grey level image.
  \param size : Outer diameter of the ring, metres, for markers without a size of their own (setMarkerSizes()).
  \param cam : Camera, with any of ViSP's projection models.
  \param cMo_vec : Pose of each marker, the likelier solution.
  \param cMo_vec2 : If not null, the other solution; equal to the first if there is none.
  \param projErrors : If not null, negative log-likelihood of each pose, up to a constant common to both solutions.
  \param projErrors2 : If not null, that plus the log-odds of the first solution, which may be less than what the other
  one's likelihood alone would give (vpCircleMarkerDetection::logOdds); HUGE_VAL if there is no other.
  \return Whether a marker was found.
  \exception vpException::dimensionError : If the image has a side of less than 16 or more than 32767 pixels.
  \exception vpException::badValue : If the size is not positive.
  \exception vpException::fatalError : If the system does not give the threads of setNbThreads().

  After the time of setTimeout() (none by default) a search ends with the markers found by then, and returns whether
  there are any. That it did hasTimedOut() tells; with setDebug() candidates for which no time was left have the reason
  TIMEOUT, where it came so far that there were candidates.

  After an exception for the image or the size the detector has the markers of the image before; after any other, want
  of memory for instance, it has none, and markers are not followed any more.
*/
bool vpDetectorCircleMarker::detect(const vpImage<unsigned char> &I, double size, const vpCameraParameters &cam,
                                    std::vector<vpHomogeneousMatrix> &cMo_vec,
                                    std::vector<vpHomogeneousMatrix> *cMo_vec2, std::vector<double> *projErrors,
                                    std::vector<double> *projErrors2)
{
  constexpr bool isCameraGuessed = false;
  return detectWith(I, size, cam, isCameraGuessed, cMo_vec, cMo_vec2, projErrors, projErrors2);
}

// What detect() does, with a camera or, in default of one, with a guess (see Impl::Visit).
bool vpDetectorCircleMarker::detectWith(const vpImage<unsigned char> &I, double size, const vpCameraParameters &cam,
                                        bool isCameraGuessed, std::vector<vpHomogeneousMatrix> &cMo_vec,
                                        std::vector<vpHomogeneousMatrix> *cMo_vec2, std::vector<double> *projErrors,
                                        std::vector<double> *projErrors2)
{
  circle_marker::checkMarkerSize(size);
  checkImageSize(I);
  try {
    const circle_marker::Deadline deadline(static_cast<double>(m_timeout_ms));
    m_impl->detect(I, size, cam, isCameraGuessed, deadline);
    m_impl->hasTimedOut = deadline.hasPassed();
    fillOutputs(cMo_vec, cMo_vec2, projErrors, projErrors2);
  }
  catch (...) {
    m_impl->forgetResults();
    m_nb_objects = 0;
    m_polygon.clear();
    m_message.clear();
    throw;
  }
  if (m_impl->displayTag) {
    displayTags(I, m_impl->displayColor, m_impl->displayThickness);
  }
  return m_nb_objects > 0;
}

// Gives the image's markers to the outputs of detect(), and to what vpDetectorBase keeps.
void vpDetectorCircleMarker::fillOutputs(std::vector<vpHomogeneousMatrix> &cMo_vec,
                                         std::vector<vpHomogeneousMatrix> *cMo_vec2, std::vector<double> *projErrors,
                                         std::vector<double> *projErrors2)
{
  using Detection = vpCircleMarkerDetection;
  using Matrix = vpHomogeneousMatrix;
  m_nb_objects = m_impl->detections.size();
  // Assigned, not made anew: ViSP's matrices then keep their memory.
  const auto fill = [this](auto *output, auto value) {
    if (output == nullptr) {
      return;
    }
    output->resize(m_nb_objects);
    for (std::size_t i = 0; i < m_nb_objects; ++i) {
      (*output)[i] = value(m_impl->detections[i]);
    }
  };
  fill(&cMo_vec, [](const Detection &d) -> const Matrix & { return d.cMo; });
  fill(cMo_vec2, [](const Detection &d) -> const Matrix & { return d.hasSecondPose ? d.cMo2 : d.cMo; });
  fill(projErrors, [](const Detection &d) { return d.cost; });
  fill(projErrors2, [](const Detection &d) { return d.cost2; });
  m_message.resize(m_nb_objects);
  m_polygon.resize(m_nb_objects);
  for (std::size_t i = 0; i < m_nb_objects; ++i) {
    const Detection &detection = m_impl->detections[i];
    putMessage(detection, m_impl->database.find(detection.family, detection.id), m_message[i]);
    m_polygon[i] = m_impl->found[i].polygon;
  }
}

END_VISP_NAMESPACE
