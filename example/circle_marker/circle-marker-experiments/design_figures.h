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
 * What a design of the marker is judged by.
 */

#ifndef VP_EXPERIMENTS_DESIGN_FIGURES_H
#define VP_EXPERIMENTS_DESIGN_FIGURES_H

#include "run_data.h"

namespace experiments {
/*! Depths of the poses, metres: from markers that are read with ease to those that nobody finds. */
constexpr double leastDesignDepth = 5.;
constexpr double mostDesignDepth = 22.;

/*! Group of the markers of another kind, whose levels are their places in a list. */
constexpr const char *rivalGroup = "rival";

/*! Figures of merit of a design over the poses of its series, which are the same for all designs. */
struct DesignFigures
{
  std::size_t frames = 0;     //!< Seen by the detector.
  double found = 0.;          //!< Share of them with the marker found and identified, at a pose that does not mislead.
  double reach = 0.;          //!< Depth to which that share of a range of depths goes, metres: what the share is worth.
  double depthLimit = 0.;     //!< Median over the poses of the bound's standard deviation of the depth, mm.
  double lateralLimit = 0.;   //!< The same across the line of sight, mm.
  double normalLimit = 0.;    //!< The same of the normal, degrees.
  double separation = 0.;     //!< Median over the poses of the distance of the two solutions' images, in sigmas.
  double weakSeparation = 0.; //!< Share of the poses with mean log-odds between the two solutions below 10.
  double reading = 0.; //!< Median over the poses of the distance to the marker most like it, in sigmas; 0 without.
  double unread = 0.;  //!< Share of the poses at which it is less than 10: an ideal reader errs once in 3e6.
  double depthError =
      0.; //!< Of the detector's poses: the standard deviation that a normal error with their median has, mm.
  double mirrored = 0.; //!< Share of the markers found with the mirrored solution first.
};

DesignFigures designFiguresOf(const std::vector<std::optional<FrameSamples>> &series);
} // namespace experiments

#endif
