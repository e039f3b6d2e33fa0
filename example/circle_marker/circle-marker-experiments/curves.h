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
 * Curves of the figures, from samples.
 */

#ifndef VP_EXPERIMENTS_CURVES_H
#define VP_EXPERIMENTS_CURVES_H

#include <string>

#include "common/figure.h"
#include "summary.h"

namespace experiments {
/*! How the estimates of a view are drawn: its colour is the same in all figures. */
std::string lineStyle(const View &view);
std::string pointStyle(const View &view);

/*! The views of which there are samples. */
std::vector<View> viewsIn(const RunData &data, const std::vector<View> &views);

/*! True centres, seen from above: x and z, metres. */
Curve trueCentres(const std::vector<Sample> &samples);

/*! Estimated centres, seen from above: x and z, metres. */
Curve estimatedCentres(const std::vector<Sample> &samples, const View &view);

/*! Points (x, y) of the estimates that count. */
Curve estimates(const std::vector<Sample> &samples, const View &view, const SampleValue &x,
                const std::function<double(const Sample &, const Deviation &)> &y);

/*! In each bin that has enough estimates: the middle, and the mean of a deviation's value. */
Curve meanCurve(const std::vector<Sample> &samples, const View &view, const std::vector<double> &edges,
                const SampleValue &x, const std::function<double(const Deviation &)> &y);

/*!
  In each bin that has frames: a bar of the share of them with the marker found, per cent.
  \e place: Which of how many bars in a bin.
*/
Curve rateBars(const std::vector<Sample> &samples, const View &view, const std::vector<double> &edges,
               const SampleValue &x, std::size_t place, std::size_t places);

/*!
  Gives all panels of a figure with a logarithmic y axis the same range, in whole powers of ten, at most six of them: a
  few estimates that are right by chance are not worth the room.
*/
void shareDecades(Figure &figure);

/*! A horizontal line across a range. */
Curve level(const std::string &title, double least, double most, double y);
} // namespace experiments

#endif
