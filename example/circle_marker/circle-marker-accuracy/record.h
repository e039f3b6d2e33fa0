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
 * One measurement: what was seen, how well it was measured, and how well it could have been.
 */

#ifndef VP_ACCURACY_RECORD_H
#define VP_ACCURACY_RECORD_H

#include <limits>
#include <string>
#include <vector>

namespace accuracy {
constexpr double none = std::numeric_limits<double>::quiet_NaN();

/*! One marker in one image by one method. Nothing: not a number. Lengths in mm, angles in degrees. */
struct Record
{
  std::string part;   //!< Of partNames.
  std::string group;  //!< Family, factor or cell.
  std::string method; //!< "circle", or an AprilTag's decimation.
  double frame = none;
  double id = none;
  double distance = none;              //!< Of the marker's centre, metres.
  double diameter = none;              //!< Major axis of the image of the ring's outer edge, pixels.
  double minor = none;                 //!< Minor axis, pixels.
  double tilt = none;                  //!< Angle between normal and line of sight.
  double noise = none;                 //!< Standard deviation, grey levels, before rounding.
  double blur = none;                  //!< Standard deviation, pixels.
  double contrast = none;              //!< Paper minus ink, grey levels.
  double found = 0.;                   //!< 1 if the marker was found.
  double wrong = none;                 //!< 1 if the first pose is nearer to the mirrored normal.
  double x = none, y = none, z = none; //!< Measured minus true centre, camera frame.
  double normal = none;                //!< Angle between the measured and the true normal.
  double lean = none;                  //!< Measured minus true tilt.
  double rotation = none;              //!< Angle of the rotation between the measured and the true pose.
  double dof = none;                   //!< Degrees of freedom of the pose.
  double mahalanobis = none;           //!< Squared error by the reported covariance.
  double reportedX = none, reportedY = none, reportedZ = none, reportedNormal = none; //!< Standard deviations.
  double boundX = none, boundY = none, boundZ = none, boundNormal = none, boundRotation = none;
  double logOdds = none;    //!< Reported.
  double separation = none; //!< Of the mirrored pose, standard deviations of the noise.
  double predicted = none;  //!< Probability of the wrong choice.
  double milliseconds = none;

  bool isFound() const { return found == 1.; }
  bool isWrong() const { return wrong == 1.; }
};

/*! Comment lines, the names of the columns, a row for each record. */
std::string csvOf(const std::vector<std::string> &comments, const std::vector<Record> &records);

/*!
  The records of csvOf(); columns may be in any order.
  \exception std::runtime_error : If the file cannot be read or is not such a file.
*/
std::vector<Record> readCsv(const std::string &file);

/*! The comment lines of csvOf(), without their signs. */
std::vector<std::string> readComments(const std::string &file);
} // namespace accuracy

#endif
