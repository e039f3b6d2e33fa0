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

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <sstream>

#include <visp3/core/vpConfig.h>
#include <visp3/core/vpException.h>
#include <visp3/detection/vpDetectorAprilTag.h>

#include "detectors.h"
#include "reference_camera.h"

namespace common {
namespace {
/*! CPU time of this thread, seconds; of the process where the system does not tell threads apart. */
double cpuTime()
{
#ifdef CLOCK_THREAD_CPUTIME_ID
  timespec time;
  if (clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time) == 0) {
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  }
#endif
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/*! Where an id is in a list, if it is there; a second marker of that id would be one too many. */
std::optional<std::size_t> placeOf(int id, const std::vector<int> &ids)
{
  const auto place = std::find(ids.begin(), ids.end(), id);
  return place == ids.end() ? std::nullopt : std::optional<std::size_t>(place - ids.begin());
}

unsigned int tooMany(const std::optional<std::size_t> &place, const std::vector<int> &ids)
{
  return static_cast<unsigned int>(ids.size()) - (place ? 1 : 0);
}
} // namespace

CircleDetector::CircleDetector(const vpCircleMarkerFamily &family, double size) : m_size(size), m_detector(family)
{
  m_detector.setZAlignedWithCameraAxis(true);
  m_detector.setNbThreads(1);
}

Sighting CircleDetector::look(const vpImage<unsigned char> &I, const vpCameraParameters &cam, int id)
{
  Sighting sighting;
  std::vector<vpHomogeneousMatrix> poses;
  if (I.getSize() > m_readyFor) { // the first look takes its memory from the system, ten times as long as the next
    m_detector.detect(I, m_size, cam, poses);
    m_readyFor = I.getSize();
  }
  const double start = cpuTime();
  m_detector.detect(I, m_size, cam, poses);
  sighting.cpuTime = cpuTime() - start;
  const std::vector<int> ids = m_detector.getTagsId();
  const auto place = placeOf(id, ids);
  m_last.reset();
  if (place) {
    sighting.cMo = poses[*place];
    m_last = m_detector.getDetections()[*place];
  }
  sighting.wrongIds = tooMany(place, ids);
  return sighting;
}

#if defined(VISP_HAVE_APRILTAG)

namespace {
constexpr vpDetectorAprilTag::vpPoseEstimationMethod poseMethods[] = {
    vpDetectorAprilTag::HOMOGRAPHY,
    vpDetectorAprilTag::HOMOGRAPHY_VIRTUAL_VS,
    vpDetectorAprilTag::DEMENTHON_VIRTUAL_VS,
    vpDetectorAprilTag::LAGRANGE_VIRTUAL_VS,
    vpDetectorAprilTag::BEST_RESIDUAL_VIRTUAL_VS,
    vpDetectorAprilTag::HOMOGRAPHY_ORTHOGONAL_ITERATION,
};

std::string nameOf(vpDetectorAprilTag::vpPoseEstimationMethod method)
{
  std::ostringstream name;
  name << method;
  return name.str();
}

vpDetectorAprilTag::vpPoseEstimationMethod poseMethodOf(const std::string &name)
{
  for (const auto method : poseMethods) {
    if (nameOf(method) == name) {
      return method;
    }
  }
  throw vpException(vpException::badValue, "AprilTag has no pose method \"%s\"; use one of tagPoseMethods()",
                    name.c_str());
}
} // namespace

class AprilTagDetector::Impl
{
public:
  Impl(double size, const std::string &poseMethod, float decimation)
      : m_size(size), m_detector(vpDetectorAprilTag::TAG_36h11, poseMethodOf(poseMethod))
  {
    m_detector.setAprilTagQuadDecimate(decimation);
    m_detector.setAprilTagNbThreads(1);
    m_detector.setZAlignedWithCameraAxis(true);
  }

  AprilTagSightings look(const vpImage<unsigned char> &I, const vpCameraParameters &cam, int id)
  {
    if (I.getSize() > m_readyFor) { // as of the circular markers, so that the two are compared alike
      m_detector.detect(I);
      m_readyFor = I.getSize();
    }
    const double start = cpuTime();
    m_detector.detect(I);
    const double searchTime = cpuTime() - start;
    const std::vector<int> ids = m_detector.getTagsId();
    const auto place = placeOf(id, ids);

    Sighting none;
    none.cpuTime = searchTime;
    none.wrongIds = tooMany(place, ids);
    AprilTagSightings sightings = {none, none};
    if (place) {
      addPose(*place, cam, sightings.asDelivered);
      addPose(*place, halfPixelCamera(cam), sightings.halfPixel);
    }
    return sightings;
  }

private:
  void addPose(std::size_t place, const vpCameraParameters &cam, Sighting &sighting)
  {
    vpHomogeneousMatrix cMo;
    const double start = cpuTime();
    const bool hasPose = m_detector.getPose(place, m_size, cam, cMo);
    sighting.cpuTime += cpuTime() - start;
    if (hasPose) {
      sighting.cMo = cMo;
    }
  }

  double m_size;                 //!< Side of the black square, metres.
  unsigned int m_readyFor = 0;   //!< Pixels of an image for which there is memory.
  vpDetectorAprilTag m_detector; //!< ViSP's detector.
};

AprilTagDetector::AprilTagDetector(double size, const std::string &poseMethod, float decimation)
    : m_impl(new Impl(size, poseMethod, decimation))
{
}

AprilTagSightings AprilTagDetector::look(const vpImage<unsigned char> &I, const vpCameraParameters &cam, int id)
{
  return m_impl->look(I, cam, id);
}

std::vector<std::string> tagPoseMethods()
{
  std::vector<std::string> names;
  for (const auto method : poseMethods) {
    names.push_back(nameOf(method));
  }
  return names;
}

#else

class AprilTagDetector::Impl
{
};

AprilTagDetector::AprilTagDetector(double, const std::string &, float)
{
  throw vpException(vpException::functionNotImplementedError,
                    "this ViSP was built without AprilTag; build it with WITH_APRILTAG");
}

AprilTagSightings AprilTagDetector::look(const vpImage<unsigned char> &, const vpCameraParameters &, int)
{
  return AprilTagSightings();
}

std::vector<std::string> tagPoseMethods()
{
  return {};
}

#endif

AprilTagDetector::AprilTagDetector(AprilTagDetector &&) noexcept = default;
AprilTagDetector::~AprilTagDetector() = default;
} // namespace common
