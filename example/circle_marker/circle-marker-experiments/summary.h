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
 * Statistics of a method's samples.
 */

#ifndef VP_EXPERIMENTS_SUMMARY_H
#define VP_EXPERIMENTS_SUMMARY_H

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "common/statistics.h"
#include "run_data.h"

namespace experiments {
/*! Which solutions count: the thesis counts every estimate, which are two of each ellipse. */
enum class Solutions
{
  Both,
  First
};

/*! A column of a report: a method, and which of its solutions count. */
struct View
{
  Method method;
  Solutions solutions;
  const char *title;
};

constexpr View ringBoth = {Method::Ring, Solutions::Both, "plain ring, both solutions"};
constexpr View ringFirst = {Method::Ring, Solutions::First, "plain ring, likelier one"};
constexpr View circle = {Method::Circle, Solutions::First, "circular marker (golay23)"};
constexpr View aprilTag = {Method::AprilTag, Solutions::First, "AprilTag 36h11"};
constexpr View bound = {Method::Bound, Solutions::First, "bound (Cramér-Rao)"};

/*! What a method did in a set of frames. */
struct Summary
{
  std::size_t frames = 0;           //!< How many.
  std::size_t found = 0;            //!< With the marker found.
  std::size_t falseMarkers = 0;     //!< Reported, but not there.
  std::size_t mirrored = 0;         //!< Found with the mirrored normal first.
  std::size_t wrong = 0;            //!< Found with a pose that would mislead, see isWrong().
  double outlines = 0.;             //!< Mean of a frame.
  double markers = 0.;              //!< Mean of a frame.
  Statistics position;              //!< |C - eC| of the estimates that count, mm.
  Statistics angle;                 //!< Between N and eN, of the same, degrees.
  std::array<Statistics, 3> offset; //!< C - eC in x, y, z, of the same, mm: the thesis's sign.
  Statistics cpuTime;               //!< Of a frame, ms.
};

/*!
  The samples of a method, of frames that are done. The bound counts where the circular marker was found: it would be
  compared with other poses else, those at which nobody sees a marker.
*/
std::vector<Sample> samplesOf(const std::vector<std::optional<FrameSamples>> &series, Method method);

Summary summaryOf(const std::vector<Sample> &samples, Solutions solutions);

/*! The deviations that count. */
std::vector<Deviation> deviationsOf(const Sample &sample, Solutions solutions);

using SampleValue = std::function<double(const Sample &)>;

/*! Samples of which the value lies in a bin, for each bin; values outside of all bins are left out. */
std::vector<std::vector<Sample>> inBins(const std::vector<Sample> &samples, const std::vector<double> &edges,
                                        const SampleValue &value);

/*! Edges of bins of the same width. */
std::vector<double> evenBins(double least, double most, std::size_t count);
} // namespace experiments

#endif
