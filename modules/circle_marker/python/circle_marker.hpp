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
 * Python bindings that ViSP's generator cannot write by itself: several results of one call.
 */

// Read in ViSP's modules/python/bindings/include, as circle_marker.json says.
#ifndef VISP_PYTHON_CIRCLE_MARKER_HPP
#define VISP_PYTHON_CIRCLE_MARKER_HPP

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <visp3/circle_marker/vpCircleMarkerDatabase.h>
#include <visp3/circle_marker/vpCircleMarkerFamily.h>
#include <visp3/circle_marker/vpDetectorCircleMarker.h>
#include <visp3/circle_marker/vpPoseCircle.h>
#include <visp3/core/vpConfig.h>
#include <visp3/detection/vpDetectorBase.h>

namespace py = pybind11;

// What has no constructor that the generator sees would have none in Python.
inline void
bindings_vpCircleMarkerLayout(py::class_<VISP_NAMESPACE_ADDRESSING vpCircleMarkerLayout,
                                         std::shared_ptr<VISP_NAMESPACE_ADDRESSING vpCircleMarkerLayout>> &pyLayout)
{
  pyLayout.def(py::init<>(), "The default print's layout, in radii of the ring.");
}

// A family's type stands for the family wherever one is asked for, as in C++; vpDetectorCircleMarker's default does.
inline void bindings_vpCircleMarkerFamily(py::class_<VISP_NAMESPACE_ADDRESSING vpCircleMarkerFamily,
                                                     std::shared_ptr<VISP_NAMESPACE_ADDRESSING vpCircleMarkerFamily>> &)
{
#ifdef ENABLE_VISP_NAMESPACE
  using namespace VISP_NAMESPACE_NAME;
#endif
  py::implicitly_convertible<vpCircleMarkerFamily::vpType, vpCircleMarkerFamily>();
}

inline void
bindings_vpCircleMarkerEntry(py::class_<VISP_NAMESPACE_ADDRESSING vpCircleMarkerEntry,
                                        std::shared_ptr<VISP_NAMESPACE_ADDRESSING vpCircleMarkerEntry>> &pyEntry)
{
#ifdef ENABLE_VISP_NAMESPACE
  using namespace VISP_NAMESPACE_NAME;
#endif
  pyEntry.def(py::init([](const vpCircleMarkerFamily &family, int id, double size) {
                return vpCircleMarkerEntry{family, id, size, {}, {}, false, {}};
              }),
              R"doc(
What is known of one marker before it is seen.

:param family: Its family.

:param id: Its identity in the family; -1 for a family without code.

:param size: Outer diameter of its ring, metres.

)doc",
              py::arg("family"), py::arg("id"), py::arg("size"));
}

inline void bindings_vpCircleMarkerDatabase(
    py::class_<VISP_NAMESPACE_ADDRESSING vpCircleMarkerDatabase,
               std::shared_ptr<VISP_NAMESPACE_ADDRESSING vpCircleMarkerDatabase>> &pyDatabase)
{
#ifdef ENABLE_VISP_NAMESPACE
  using namespace VISP_NAMESPACE_NAME;
#endif
  pyDatabase.def(py::init<>(), "A database without markers.");

  pyDatabase.def(
      "find",
      [](const vpCircleMarkerDatabase &self, const vpCircleMarkerFamily &family, int id) {
        const vpCircleMarkerEntry *entry = self.find(family, id);
        return entry ? std::optional<vpCircleMarkerEntry>(*entry) : std::nullopt;
      },
      R"doc(
What is known of a marker.

:param family: Its family.

:param id: Its identity in the family; -1 for a family without code.

:return: A copy of its entry, or None where the marker is not known.

)doc",
      py::arg("family"), py::arg("id"));
}

inline void bindings_vpPoseCircle(
    py::class_<VISP_NAMESPACE_ADDRESSING vpPoseCircle, std::shared_ptr<VISP_NAMESPACE_ADDRESSING vpPoseCircle>> &pyPose)
{
#ifdef ENABLE_VISP_NAMESPACE
  using namespace VISP_NAMESPACE_NAME;
#endif
  pyPose.def(
      "computePose",
      [](vpPoseCircle &self) {
        vpHomogeneousMatrix cMo, cMo2;
        const bool computed = self.computePose(cMo, &cMo2);
        return std::make_tuple(computed, cMo, cMo2);
      },
      R"doc(
Both poses of the circle from what was given of its image.

:return: Whether they could be computed; the likelier pose; the other, both in metres from the circle to the camera.

)doc");
}

inline void
bindings_vpDetectorCircleMarker(py::class_<VISP_NAMESPACE_ADDRESSING vpDetectorCircleMarker,
                                           std::shared_ptr<VISP_NAMESPACE_ADDRESSING vpDetectorCircleMarker>,
                                           VISP_NAMESPACE_ADDRESSING vpDetectorBase> &pyDetector)
{
#ifdef ENABLE_VISP_NAMESPACE
  using namespace VISP_NAMESPACE_NAME;
#endif
  using Poses = std::vector<vpHomogeneousMatrix>;

  pyDetector.def(
      "detect",
      [](vpDetectorCircleMarker &self, const vpImage<unsigned char> &I, double size, const vpCameraParameters &cam) {
        Poses cMo;
        const bool found = self.detect(I, size, cam, cMo);
        return std::make_tuple(found, cMo);
      },
      R"doc(
Finds the markers of an image, reads their codes and computes their poses.

:param I: Grey level image.

:param size: Outer diameter of the ring, metres.

:param cam: Camera.

:return: Whether a marker was found, and the pose of each, the likelier solution.

)doc",
      py::arg("I"), py::arg("size"), py::arg("cam"));

  pyDetector.def(
      "detectWithAlternativesPoses",
      [](vpDetectorCircleMarker &self, const vpImage<unsigned char> &I, double size, const vpCameraParameters &cam) {
        Poses cMo, cMo2;
        std::vector<double> errors, errors2;
        const bool found = self.detect(I, size, cam, cMo, &cMo2, &errors, &errors2);
        return std::make_tuple(found, cMo, cMo2, errors, errors2);
      },
      R"doc(
The same with both poses of each marker. The name is that of vpDetectorAprilTag's function.

:return: Whether a marker was found; the likelier poses; the other poses; the negative log-likelihoods of both, up to a
  constant common to the two poses of a marker.

)doc",
      py::arg("I"), py::arg("size"), py::arg("cam"));

  pyDetector.def(
      "getPose",
      [](vpDetectorCircleMarker &self, std::size_t index, double size, const vpCameraParameters &cam) {
        vpHomogeneousMatrix cMo, cMo2;
        double error = 0., error2 = 0.;
        const bool known = self.getPose(index, size, cam, cMo, &cMo2, &error, &error2);
        return std::make_tuple(known, cMo, cMo2, error, error2);
      },
      R"doc(
Both poses of a marker of the last image for a given size and camera.

:param index: Index of the marker.

:param size: Outer diameter of its ring, metres.

:param cam: Camera.

:return: Whether the poses could be computed; the likelier pose; the other; the negative log-likelihoods of both.

)doc",
      py::arg("index"), py::arg("size"), py::arg("cam"));
}

#endif
