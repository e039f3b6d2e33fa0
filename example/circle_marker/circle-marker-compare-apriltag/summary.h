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
 * Statistics of the trials, for each cell and method.
 */

#ifndef VP_COMPARE_SUMMARY_H
#define VP_COMPARE_SUMMARY_H

#include <array>
#include <cstddef>
#include <vector>

#include "common/statistics.h"
#include "experiment.h"
#include "trial.h"

namespace compare {
/*! Statistics of a list of numbers; not a number if the list is empty. */
/*! Errors of one method over a set of frames, all of which it found. */
struct ErrorSummary
{
  std::size_t frames = 0;         //!< How many.
  Statistics position;            //!< |C - eC|, mm.
  Statistics x, y, z;             //!< Magnitudes, camera frame, mm.
  Statistics normal;              //!< Degrees.
  Statistics rotation;            //!< Degrees.
  std::size_t wrongSolutions = 0; //!< Frames with the mirrored normal.
};

/*! What one method did in one cell. */
struct MethodSummary
{
  std::size_t found = 0;    //!< Frames in which the marker was found.
  std::size_t wrongIds = 0; //!< Markers found that are not there, in all frames.
  Statistics cpuTime;       //!< Over all frames, ms.
  ErrorSummary own;         //!< Over the frames in which this method found the marker.
  ErrorSummary common;      //!< Over the frames in which all methods found the marker.
};

/*! What all methods did in one cell. */
struct CellSummary
{
  std::size_t frames = 0;                         //!< How many.
  std::size_t common = 0;                         //!< Those in which all methods found the marker.
  std::array<MethodSummary, methodCount> methods; //!< By method.

  const MethodSummary &operator[](Method method) const { return methods[indexOf(method)]; }
};

/*! Root-mean-square errors of the circle over those of another method, on the frames all methods found. */
struct Ratios
{
  double x, y, z, rotation;
};

using Summary = std::array<CellSummary, cells.size()>;

Summary summaryOf(const std::vector<Trial> &trials);

Ratios circleOver(Method method, const CellSummary &cell);
} // namespace compare

#endif
