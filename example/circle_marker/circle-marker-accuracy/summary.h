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
 * Statistics over records: errors against the bound and against what was reported.
 */

#ifndef VP_ACCURACY_SUMMARY_H
#define VP_ACCURACY_SUMMARY_H

#include <array>
#include <functional>
#include <vector>

#include "record.h"

namespace accuracy {
using Records = std::vector<Record>;
using Filter = std::function<bool(const Record &)>;

Records chosen(const Records &records, const Filter &filter);

/*! What is measured: x, y, z and the normal. */
enum Quantity
{
  X,
  Y,
  Z,
  NORMAL,
  QUANTITIES
};
constexpr const char *quantityNames[] = {"x", "y", "z", "normal"};

/*! A pose, as the mean of many; errors are over the frames with the right one of the two solutions. */
struct Summary
{
  std::size_t frames = 0; //!< Images.
  std::size_t found = 0;  //!< With the marker found.
  std::size_t wrong = 0;  //!< Of those, with the mirrored pose first.
  std::size_t right = 0;  //!< Of those, with the right pose first.
  double predicted = 0.;  //!< Wrong ones as the bound predicts them, of those found; not a number: not computed.

  std::array<double, QUANTITIES> rms;      //!< Of the error, mm and degrees.
  std::array<double, QUANTITIES> ratio;    //!< Root mean square of error over bound.
  std::array<double, QUANTITIES> worst;    //!< Greatest error over bound.
  std::array<double, QUANTITIES> bias;     //!< Mean of error over bound; the normal's: of the change of tilt.
  std::array<double, QUANTITIES> optimism; //!< Root mean square of error over reported standard deviation.
  double depthBias = none;                 //!< Mean of the depth's error over the distance, per cent.
  double depthSpread = none;               //!< Standard deviation of it.
  double mahalanobis = none;               //!< Mean of the squared error by the covariance over degrees of freedom.
  double mahalanobis95 = none;             //!< Its 95 % quantile over that of the chi-squared distribution.
  double position = none, positionMedian = none;     //!< |C - eC| over all frames found, mm.
  double normal = none, normalMedian = none;         //!< Angle of the normal over all frames found, degrees.
  double positionSpread = none, normalSpread = none; //!< Standard deviations of these two.
  double positionBound = none, normalBound = none;   //!< What these two means are expected to be, about.
  double rotation = none;     //!< Root mean square of the rotation's error, degrees; 6 degrees of freedom.
  double milliseconds = none; //!< Median CPU time of an image.

  /*! Relative standard error of a root mean square over the right ones. */
  double ratioError() const;
};

/*!
  The mean length of a normally distributed error is sqrt(2/pi) of its root mean square at least: so much of the bound
  is what the means over the frames found are compared with. Of the normal's error it is no more than the tilt, for the
  bound is one of the first order and grows without limit where the marker faces the camera; and as often as the wrong
  solution is predicted to be the likelier one, the error is twice the tilt.
*/
Summary summaryOf(const Records &records);

/*! How often those that were as sure as this were right. */
struct Calibration
{
  double from, to;        //!< Reported probability of the first pose.
  std::size_t frames = 0; //!< Images in between.
  std::size_t right = 0;  //!< With the right pose first.
  double reported = none; //!< Mean of the reported probability.
};

/*! Of the images with a prediction: where the marker faces the camera there is no mirrored pose to be told from. */
std::vector<Calibration> calibrationOf(const Records &records);
} // namespace accuracy

#endif
