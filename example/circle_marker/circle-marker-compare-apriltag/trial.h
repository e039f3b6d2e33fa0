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
 * One pose, seen once with each marker and measured with each method.
 */

#ifndef VP_COMPARE_TRIAL_H
#define VP_COMPARE_TRIAL_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <visp3/core/vpHomogeneousMatrix.h>

#include "common/parallel.h"
#include "common/pose_error.h"
#include "experiment.h"

namespace compare {
/*! What a method made of one frame. */
struct Measurement
{
  std::optional<PoseError> error; //!< Nothing: the marker was not found.
  unsigned int wrongIds = 0;      //!< Markers found that are not there.
  double cpuTime = 0.;            //!< Seconds.
};

/*! One pose, at which each marker was seen once. */
struct Trial
{
  std::size_t cell = 0;                              //!< Index into cells.
  unsigned int frame = 0;                            //!< From 0 in each cell.
  int circleId = 0;                                  //!< Of the circular marker.
  int tagId = 0;                                     //!< Of the AprilTag.
  vpHomogeneousMatrix cMo;                           //!< The true pose of both markers, z into the marker, metres.
  std::array<Measurement, methodCount> measurements; //!< By method.

  const Measurement &operator[](Method method) const { return measurements[indexOf(method)]; }

  /*! Whether every method found the marker. */
  bool foundByAll() const
  {
    return std::all_of(measurements.begin(), measurements.end(),
                       [](const Measurement &measurement) { return measurement.error.has_value(); });
  }
};

/*!
  Makes all trials. Each has a seed of its own, made of the settings' seed, its cell and its number: the outcome, but
  for the CPU times, depends neither on the number of threads nor on the number of frames.

  \return The trials, by cell and then by frame.
  \exception vpException : If a scene cannot be made, for instance of a marker that does not fit into the image.
*/
std::vector<Trial> makeTrials(const Settings &settings, const Progress &progress);
} // namespace compare

#endif
