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
 * Both poses of a recognised marker, refined and weighed against each other.
 */

#ifndef VP_CIRCLE_MARKER_MEASURE_H
#define VP_CIRCLE_MARKER_MEASURE_H

#include <optional>

#include "decode/recognise.h"
#include "refine/code_image.h"
#include "refine/fitter.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! The poses of a marker, the likelier first. */
struct Measurement
{
  FittedPose first;
  std::optional<FittedPose> second; //!< Nothing if both starts lead to the same pose.
  double cost = 0.;                 //!< Negative log-likelihood of the first, up to a constant common to both.
  double cost2 = HUGE_VAL;          //!< And of the second.
  //! The light on the marker, if it is so uneven that the pixels were taken to even light before they were fitted.
  std::optional<UnevenLight> uneven{};
};

/*! Calls change(FittedPose &) for the first pose, and for the second if there is one. */
template <class Change> void forEachPose(Measurement &measurement, const Change &change)
{
  change(measurement.first);
  if (measurement.second) {
    change(*measurement.second);
  }
}

/*! Coordinates in which measure() tells the light on a marker: those of the first pose that was recognised. */
ImageFrame frameOf(const MarkerPlane &plane, const CameraModel &camera);

/*! Working memory of measure(), and of what is read at a measured pose. A copy has a memory of its own. */
struct MeasureMemory : FittingMemory
{
  MeasureMemory() = default;
  MeasureMemory(const MeasureMemory &) : FittingMemory() {}
  MeasureMemory &operator=(const MeasureMemory &) { return *this; }

  TrackMemory track;               //!< Of the code track's pixels.
  CodeImage code;                  //!< The same of a small marker.
  std::vector<FitPixel> fewPixels; //!< When few are looked at once more after all.
};

/*!
  Whether a plain ring has another ratio of radii than its family's: both of its edges tell how far the ink would have
  spread, and nothing else of it. Fitted with the inner radius of another ring it is fitted with its outer edge beside
  its place, too, by half of the difference; and the depth is off by that.
  \param marker : The marker; with a code it is none.
  \param fit : Its pose.
  \param camera : The camera.
*/
bool isOtherRing(const Recognition &marker, const FittedPose &fit, const CameraModel &camera);

/*!
  Refines both poses of a marker on the image and compares how well they explain it.
  \param I : The image.
  \param camera : Its camera.
  \param marker : The marker, with the poses to start from.
  \param refine : Whether to move the poses, or only to evaluate them.
  \param memory : Working memory.
  \param deadline : When to stop, with nothing.
  \param noise : Noise of the image; by default pixels share none.
  \return Nothing if the image does not look like the marker after all.
*/
std::optional<Measurement> measure(const vpImage<unsigned char> &I, const CameraModel &camera,
                                   const Recognition &marker, bool refine, MeasureMemory &memory,
                                   const Deadline &deadline = Deadline(), const ImageNoise &noise = ImageNoise());

/*!
  The likelier pose with less: in even light, whatever that leaves.
*/
std::optional<FittedPose> measureInOneLook(const vpImage<unsigned char> &I, const CameraModel &camera,
                                           const Recognition &marker, MeasureMemory &memory, const Deadline &deadline,
                                           const ImageNoise &noise);

/*!
  With less again, for a marker that is measured many times: one of its poses only, from where it was measured in an
  image that is nearly the same, on pixels around the edges of another pose: for measurements that are compared they
  must be the same.
*/
std::optional<FittedPose> measureNearby(const vpImage<unsigned char> &I, const CameraModel &camera,
                                        const Recognition &marker, const FittedPose &around, const FittedPose &from,
                                        MeasureMemory &memory, const Deadline &deadline, const ImageNoise &noise);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
