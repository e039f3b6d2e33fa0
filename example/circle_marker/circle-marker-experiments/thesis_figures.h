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
 * The figures of the thesis: J. Stork, Camera pose estimation with circular markers, University of Amsterdam, 2012.
 */

#ifndef VP_EXPERIMENTS_THESIS_FIGURES_H
#define VP_EXPERIMENTS_THESIS_FIGURES_H

#include <array>
#include <optional>

namespace experiments {
/*! A column of its tables 5.5 and 5.6: every estimate counts, which are two of each ellipse. */
struct ThesisFigures
{
  const char *table;                           //!< Where the thesis states them.
  unsigned int frames;                         //!< n.
  double framesPerSecond;                      //!< Simulator and pipeline together.
  double ellipsesBefore;                       //!< In each frame, before the filter.
  double ellipsesAfter;                        //!< In each frame, after the filter.
  double leastError, mostError;                //!< |C - eC|, mm.
  double meanError, sigmaError;                //!< |C - eC|, mm.
  std::array<double, 3> meanOffset;            //!< C - eC in x, y, z, mm.
  std::optional<double> meanAngle, sigmaAngle; //!< Between N and eN, degrees; not measured in experiment 2.

  /*!
    The thesis gives detection rates in figures 5.11 and 5.12 only. Its program finds two ellipses for each circle that
    it finds (6.2.2), so half the ellipses after the filter is about the share of the frames with a detection.
  */
  double detectionRate() const { return 0.5 * ellipsesAfter; }
};

/*! Table 5.5: five lines. */
constexpr ThesisFigures thesisLines = {
    "5.5", 2000, 2.17, 1.51, 0.24, 459.8, 10870.6, 3945.6, 2241.4, {-1320.1, -956.3, 3289.8}, {}, {}};

/*! A column of table 5.6 and the range of its poses: angle in degrees, depth in metres from 0.36. */
struct ThesisCell
{
  double maximumAngle, maximumDistance;
  ThesisFigures figures;
};

/*! Table 5.6. Its last column states a range of angles to 10 degrees, but a greatest angle of 30.0, as the text does.
 */
constexpr std::array<ThesisCell, 5> thesisCells = {
    {{30., 10.4, {"5.6", 7439, 2.07, 4.00, 1.95, 1, 804, 137, 94, {2, -2, -121}, 26.3, 15.4}},
     {60., 10.4, {"5.6", 7947, 2.21, 4.00, 1.96, 1, 2480, 175, 136, {1, -2, -163}, 49.3, 30.6}},
     {60., 18.4, {"5.6", 7665, 2.13, 3.83, 1.91, 1, 9568, 287, 509, {3, -2, -113}, 49.0, 30.2}},
     {90., 10.4, {"5.6", 7813, 2.17, 3.47, 1.55, 1, 24873, 318, 810, {-1, -3, -304}, 66.3, 42.1}},
     {90., 18.4, {"5.6", 7900, 2.15, 2.96, 1.35, 1, 25331, 439, 985, {3, -4, -313}, 63.5, 40.5}}}};
} // namespace experiments

#endif
