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
 * What a method made of one frame.
 */

#ifndef VP_EXPERIMENTS_SAMPLE_H
#define VP_EXPERIMENTS_SAMPLE_H

#include <cstddef>
#include <optional>
#include <vector>

#include "method.h"

namespace experiments {
/*! How far an estimate is from the truth. */
struct Deviation
{
  double dx, dy, dz; //!< Estimated minus true centre, camera frame, mm.
  double normal;     //!< Angle between the estimated and the true normal, degrees.

  double position() const; //!< |C - eC|, mm.
};

/*! What a method made of one frame. */
struct Sample
{
  Method method = Method::Circle;
  double x = 0., y = 0., z = 0.;   //!< True centre, camera frame, metres; all 0 without a marker.
  double angle = 0.;               //!< Between normal and line of sight, degrees.
  unsigned int outlines = 0;       //!< Ellipses that were looked at; 0 where the detector does not tell.
  unsigned int markers = 0;        //!< Markers reported, of whatever id.
  std::optional<Deviation> first;  //!< Of the marker's pose, the likelier one; nothing: not found.
  std::optional<Deviation> second; //!< Of the other solution, if there is one.
  double rotation = 0.;            //!< Angle of the rotation between estimate and truth, degrees; with a code only.
  bool isMirrored = false;         //!< The first pose's normal is nearer to the true one reflected about the sight.
  double logOdds = 0.;             //!< ln(likelihood of the first / of the second); 0 without a second.
  double reading = 0.;             //!< Limit: distance to the image of the marker most like it, see readingDistance().
  double cpuTime = 0.;             //!< Of detection and pose, ms.

  double distance() const; //!< |C|, metres.
};

/*! The samples of a frame, one for each method of its series, in their order. */
using FrameSamples = std::vector<Sample>;

/*! Whether an estimate would mislead: off by more than a tenth of the distance, or its normal by 20 degrees. */
bool isWrong(const Sample &sample);
} // namespace experiments

#endif
