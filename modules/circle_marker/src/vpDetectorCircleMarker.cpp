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

#include <visp3/circle_marker/vpDetectorCircleMarker.h>

#include <algorithm>
#include <cmath>

#include <visp3/core/vpException.h>
#include <visp3/core/vpTime.h>

#include "decode/recognise.h"
#include "ellipse/outlines.h"
#include "pose/hypotheses.h"
#include "refine/measure.h"
#include "refine/report.h"
#include "support/detector_settings.h"

BEGIN_VISP_NAMESPACE

using namespace circle_marker;

namespace
{
// Points of the polygon that vpDetectorBase keeps of each object.
constexpr unsigned int polygonPoints = 36;
// Size of a marker whose size was not told: poses are then in units of its diameter.
constexpr double unitSize = 1.;

// Inside a marker there is room for another one in its white centre only, of this radius in units of the ring's.
constexpr double whiteCenter = 0.4;

void checkSize(double size)
{
  if (!(size > 0.) || !std::isfinite(size)) {
    throw vpException(vpException::badValue,
                      "vpDetectorCircleMarker: the marker size is %g; it is the outer diameter of the ring in metres "
                      "and must be positive", size);
  }
}

// A camera that is good enough to read codes with: ordinary lenses have a focal length of about the image's width.
vpCameraParameters nominalCamera(const vpImage<unsigned char> &I)
{
  const double focal = std::max(I.getWidth(), I.getHeight());
  return vpCameraParameters(focal, focal, 0.5 * (I.getWidth() - 1.), 0.5 * (I.getHeight() - 1.));
}
} // namespace

class vpDetectorCircleMarker::Impl
{
public:
  DetectorSettings settings;
  std::vector<vpCircleMarkerDetection> detections;
  bool displayTag = false;
  vpColor displayColor = vpColor::none;
  unsigned int displayThickness = 2;

  // The pipeline: an image goes through the rooms once, in this order.
  void detect(const vpImage<unsigned char> &I, double size, const vpCameraParameters &cam, double deadline)
  {
    m_recognised.clear();
    detections.clear();
    const CameraModel camera(cam);
    for (const EllipseCandidate &candidate : findOutlines(I, m_outlines)) {
      if (vpTime::measureTimeMs() > deadline) {
        break;
      }
      if (isPartOfDetected(candidate.ellipse)) {
        continue;
      }
      const auto poses = posesFromOutline(candidate.points, camera, 0.5 * size);
      if (!poses) {
        continue;
      }
      for (const vpCircleMarkerFamily &family : settings.families) {
        const auto marker = recognise(I, camera, *poses, candidate.contrast, family, settings.decode);
        if (marker && addDetection(I, camera, candidate, *marker)) {
          break;
        }
      }
    }
  }

  // The pose of a marker for another size or camera, from its outline and the image it was detected in.
  std::optional<vpCircleMarkerDetection> measureAgain(const vpImage<unsigned char> &I, std::size_t index, double size,
                                                      const vpCameraParameters &cam)
  {
    const CameraModel camera(cam);
    const Found &found = m_recognised[index];
    const auto poses = posesFromOutline(found.outline, camera, 0.5 * size);
    if (!poses) {
      return std::nullopt;
    }
    const auto marker =
        recognise(I, camera, *poses, found.contrast, found.marker.family, settings.decode);
    if (!marker || marker->code.id != found.marker.code.id) {
      return std::nullopt;
    }
    const auto measurement = measure(I, camera, *marker, settings.refinePose, m_pixels);
    if (!measurement) {
      return std::nullopt;
    }
    return reportOf(*marker, *measurement, camera, found.visible, settings.zAlignedWithCameraAxis);
  }

  std::vector<vpImagePoint> polygonOf(std::size_t index) const { return m_recognised[index].polygon; }

  vpImage<unsigned char> image; // the last one, for getPose()

private:
  // What is kept of a detected marker to measure it again.
  struct Found
  {
    Recognition marker;
    std::vector<EdgePoint> outline;
    std::vector<vpImagePoint> polygon;
    double contrast;
    double visible;
  };

  // Whether an outline is a piece of a marker that is known already: its code, or its ring again.
  bool isPartOfDetected(const EllipseParameters &ellipse) const
  {
    for (const vpCircleMarkerDetection &known : detections) {
      const EllipseParameters outer = {Eigen::Vector2d(known.ellipse.center.get_u(), known.ellipse.center.get_v()),
                                       known.ellipse.a, known.ellipse.b, known.ellipse.angle};
      const Eigen::Vector2d offset = Eigen::Rotation2Dd(-outer.angle) * (ellipse.center - outer.center);
      // Affine image of the ring as the unit circle: distance of the centres, and the larger reach of the outline.
      const double distance = Eigen::Vector2d(offset.x() / outer.a, offset.y() / outer.b).norm();
      const double reach = distance + ellipse.a / outer.a;
      if (distance < 1. && reach > whiteCenter) {
        return true;
      }
    }
    return false;
  }

  bool addDetection(const vpImage<unsigned char> &I, const CameraModel &camera, const EllipseCandidate &candidate,
                    Recognition marker)
  {
    const auto known = settings.sizes.find(marker.code.id);
    if (known != settings.sizes.end()) {
      // The image fixes the pose up to the size: everything scales with it.
      for (MarkerPlane &plane : marker.poses) {
        plane.center *= 0.5 * known->second / plane.radius;
        plane.radius = 0.5 * known->second;
      }
    }
    const auto measurement = measure(I, camera, marker, settings.refinePose, m_pixels);
    if (!measurement) {
      return false;
    }
    const vpCircleMarkerDetection detection =
        reportOf(marker, *measurement, camera, candidate.support, settings.zAlignedWithCameraAxis);
    detections.push_back(detection);
    m_recognised.push_back({marker, candidate.points, outlineOf(measurement->first.plane, camera, polygonPoints),
                            candidate.contrast, candidate.support});
    return true;
  }

  OutlineMemory m_outlines;
  std::vector<Found> m_recognised; // one for each detection
  std::vector<FitPixel> m_pixels;
};

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
{ }

vpDetectorCircleMarker::vpDetectorCircleMarker(const vpDetectorCircleMarker &other)
  : vpDetectorBase(other), m_impl(new Impl(*other.m_impl))
{ }

vpDetectorCircleMarker &vpDetectorCircleMarker::operator=(const vpDetectorCircleMarker &other)
{
  if (this != &other) {
    vpDetectorBase::operator=(other);
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
  checkSize(size);
  constexpr unsigned int leastSide = 16; // pixels
  if (I.getWidth() < leastSide || I.getHeight() < leastSide) {
    throw vpException(vpException::dimensionError,
                      "vpDetectorCircleMarker: the image is %u x %u pixels; at least %u x %u are needed", I.getWidth(),
                      I.getHeight(), leastSide, leastSide);
  }
  m_impl->image = I;
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
    m_polygon.push_back(m_impl->polygonOf(i));
  }
  if (m_impl->displayTag) {
    displayTags(I, m_impl->displayColor, m_impl->displayThickness);
  }
  return m_nb_objects > 0;
}

/*!
  \return What the last call of detect() found, in the order of the messages and polygons.
*/
const std::vector<vpCircleMarkerDetection> &vpDetectorCircleMarker::getDetections() const
{
  return m_impl->detections;
}

namespace
{
const vpCircleMarkerDetection &at(const std::vector<vpCircleMarkerDetection> &detections, size_t index)
{
  if (index >= detections.size()) {
    throw vpException(vpException::badValue, "vpDetectorCircleMarker: there is no marker %lu; the last image has %lu",
                      static_cast<unsigned long>(index), static_cast<unsigned long>(detections.size()));
  }
  return detections[index];
}
} // namespace

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
bool vpDetectorCircleMarker::getPose(size_t index, double size, const vpCameraParameters &cam,
                                     vpHomogeneousMatrix &cMo, vpHomogeneousMatrix *cMo2, double *projError,
                                     double *projError2)
{
  checkSize(size);
  at(m_impl->detections, index);
  const auto detection = m_impl->measureAgain(m_impl->image, index, size, cam);
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

/*!
  \return Image of the centre of a marker, pixels. It is neither the centre of its ellipse nor getCog().
  \exception vpException::badValue : If there is no such marker.
*/
vpImagePoint vpDetectorCircleMarker::getCenter(size_t index) const { return at(m_impl->detections, index).center; }

/*!
  \return 6 x 6 covariance of a marker's pose: see vpCircleMarkerDetection.
  \exception vpException::badValue : If there is no such marker.
*/
vpMatrix vpDetectorCircleMarker::getCovariance(size_t index) const { return at(m_impl->detections, index).covariance; }

/*!
  \return ln(likelihood of the first pose / likelihood of the second), HUGE_VAL if there is no second one.
  \exception vpException::badValue : If there is no such marker.
*/
double vpDetectorCircleMarker::getLogOdds(size_t index) const { return at(m_impl->detections, index).logOdds; }

/*!
  \return Mean agreement of the code's sectors with the codeword, from 0 to 1 (each sector black or white as the
  codeword has it); 1 without a code.
  \exception vpException::badValue : If there is no such marker.
*/
double vpDetectorCircleMarker::getMargin(size_t index) const { return at(m_impl->detections, index).margin; }

/*!
  \return Number of sectors of the code that had to be corrected.
  \exception vpException::badValue : If there is no such marker.
*/
unsigned int vpDetectorCircleMarker::getHammingDistance(size_t index) const
{
  return at(m_impl->detections, index).hamming;
}

/*!
  \return Identity of each marker; -1 without a code. Named as in vpDetectorAprilTag.
*/
std::vector<int> vpDetectorCircleMarker::getTagsId() const
{
  std::vector<int> ids;
  for (const vpCircleMarkerDetection &detection : m_impl->detections) {
    ids.push_back(detection.id);
  }
  return ids;
}

/*!
  \return For each marker, points along the image of its outer edge, pixels. Named as in vpDetectorAprilTag.
*/
std::vector<std::vector<vpImagePoint> > vpDetectorCircleMarker::getTagsCorners() const { return m_polygon; }

/*!
  \return For each marker, the number of corrected sectors. Named as in vpDetectorAprilTag.
*/
std::vector<int> vpDetectorCircleMarker::getTagsHammingDistance() const
{
  std::vector<int> distances;
  for (const vpCircleMarkerDetection &detection : m_impl->detections) {
    distances.push_back(static_cast<int>(detection.hamming));
  }
  return distances;
}

/*!
  \return For each marker, its decision margin: see getMargin(). Named as in vpDetectorAprilTag.
*/
std::vector<float> vpDetectorCircleMarker::getTagsDecisionMargin() const
{
  std::vector<float> margins;
  for (const vpCircleMarkerDetection &detection : m_impl->detections) {
    margins.push_back(static_cast<float>(detection.margin));
  }
  return margins;
}

/*!
  \param family : The only family to look for.
*/
void vpDetectorCircleMarker::setFamily(const vpCircleMarkerFamily &family) { m_impl->settings.families = {family}; }

/*!
  \param families : Families to look for, at least one. An outline that could be of several is given to the first.
  \exception vpException::badValue : If there is none.
*/
void vpDetectorCircleMarker::setFamilies(const std::vector<vpCircleMarkerFamily> &families)
{
  if (families.empty()) {
    throw vpException(vpException::badValue, "vpDetectorCircleMarker: at least one family must be looked for");
  }
  m_impl->settings.families = families;
}

/*!
  \return Families that are looked for.
*/
const std::vector<vpCircleMarkerFamily> &vpDetectorCircleMarker::getFamilies() const
{
  return m_impl->settings.families;
}

/*!
  \param sizes : Sizes of single markers, metres, by id; the others have the size given to detect().
  \exception vpException::badValue : If a size is not positive.
*/
void vpDetectorCircleMarker::setMarkerSizes(const std::map<int, double> &sizes)
{
  for (const auto &[id, size] : sizes) {
    (void)id;
    checkSize(size);
  }
  m_impl->settings.sizes = sizes;
}

/*!
  \param distance : Most sectors of a code that are corrected (2 by default). The codes of distance 7 correct 3: every
  word of golay23 is then a marker, so keep to 2 at most where phantoms matter.
*/
void vpDetectorCircleMarker::setMaximumHammingDistance(unsigned int distance)
{
  m_impl->settings.decode.maximumHamming = distance;
}

/*!
  \param margin : Least decision margin, from 0 to 1 (see getMargin()).
  \exception vpException::badValue : If it is outside of [0, 1].
*/
void vpDetectorCircleMarker::setMinimumMargin(double margin)
{
  if (!(margin >= 0. && margin <= 1.)) {
    throw vpException(vpException::badValue, "vpDetectorCircleMarker: the margin %g is not in [0, 1]", margin);
  }
  m_impl->settings.decode.minimumMargin = margin;
}

/*!
  \param threads : Number of threads, at least one.
  \exception vpException::badValue : If it is 0.
*/
void vpDetectorCircleMarker::setNbThreads(unsigned int threads)
{
  if (threads == 0) {
    throw vpException(vpException::badValue, "vpDetectorCircleMarker: at least one thread is needed");
  }
  m_impl->settings.threads = threads;
}

/*!
  \param refine : Whether poses are refined on the grey levels around the marker's edges (the default), or left as the
  closed form of vpPoseCircle gives them, which takes less time.
*/
void vpDetectorCircleMarker::setRefinePose(bool refine) { m_impl->settings.refinePose = refine; }

/*!
  \param aligned : Whether the marker's z axis points into the marker (and y down), or toward the camera (and y up),
  which is the default as in vpDetectorAprilTag.
*/
void vpDetectorCircleMarker::setZAlignedWithCameraAxis(bool aligned)
{
  m_impl->settings.zAlignedWithCameraAxis = aligned;
}

/*!
  Reads settings from a JSON file; those it does not name stay as they are. Keys: families (list of names), sizes
  (id to metres), maximumHammingDistance, minimumMargin, refinePose, zAlignedWithCameraAxis, threads.

  \param filename : Its path.
  \exception vpException::ioError : If it cannot be read.
  \exception vpException::badValue : If it is not JSON, or a key or value is not known.
  \exception vpException::functionNotImplementedError : If the module was built without nlohmann-json.
*/
void vpDetectorCircleMarker::loadConfigFile(const std::string &filename)
{
  const DetectorSettings settings = readSettings(filename, m_impl->settings);
  setFamilies(settings.families);
  setMarkerSizes(settings.sizes);
  setMinimumMargin(settings.decode.minimumMargin);
  setNbThreads(settings.threads);
  m_impl->settings = settings;
}

/*!
  Writes the settings as loadConfigFile() reads them, whole or not at all.
  \param filename : Path of the file.
  \exception vpException::ioError : If it cannot be written.
  \exception vpException::functionNotImplementedError : If the module was built without nlohmann-json.
*/
void vpDetectorCircleMarker::saveConfigFile(const std::string &filename) const
{
  writeSettings(filename, m_impl->settings);
}

/*!
  \param display : Whether detect() draws the outline of what it finds in the image's display.
  \param color : Colour; vpColor::none for the default.
  \param thickness : Of the lines, pixels.
*/
void vpDetectorCircleMarker::setDisplayTag(bool display, const vpColor &color, unsigned int thickness)
{
  m_impl->displayTag = display;
  m_impl->displayColor = color;
  m_impl->displayThickness = thickness;
}

END_VISP_NAMESPACE
