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
 * What vpPoseCircle holds.
 */

/*!
  \file pose_circle_impl.h
  \brief What vpPoseCircle holds.
*/

#ifndef VP_CIRCLE_MARKER_POSE_CIRCLE_IMPL_H
#define VP_CIRCLE_MARKER_POSE_CIRCLE_IMPL_H

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <visp3/circle_marker/vpPoseCircle.h>

#include "pose/circle_from_conic.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
//! A measured ellipse stands for this many contour points: one every 5 degrees.
constexpr std::size_t samplesOfAnEllipse = 72;

/*! Throws a vpException::badValue with the reason. */
VP_NORETURN void refuse(const std::string &reason);

/*! Whether a value is positive and finite. */
bool isPositive(double value);

/*! Whether a value can be a standard deviation: finite, and not so small that its inverse square is none. */
bool isDeviation(double value);

/*! Symmetric part of a 3 x 3 matrix; vpException::dimensionError for another size. */
Eigen::Matrix3d conicFromMatrix(const vpMatrix &Q);

/*! Conic of 5 or 6 coefficients: see vpPoseCircle::setConic(); vpException::dimensionError for another number. */
Eigen::Matrix3d conicFromCoefficients(const vpColVector &K);

/*! The ellipse of a conic; vpException::badValue with the reason if it is none. */
CenteredEllipse ellipseOrReason(const Eigen::Matrix3d &Q);
} // namespace circle_marker

/*!
  The measurements, what was set and what was computed. Coordinates are normalised.
*/
class vpPoseCircle::Impl
{
public:
  //! Replaces the points.
  void setEllipse(const circle_marker::CenteredEllipse &ellipse);

  //! Replaces the measured ellipse.
  void addPoints(const std::vector<Eigen::Vector2d> &points);

  //! The measured ellipse, or the one fitted to the points; throws if there is none.
  circle_marker::CenteredEllipse ellipse() const;

  //! The points given, or points of the measured ellipse.
  std::vector<Eigen::Vector2d> contour() const;

  //! ln(likelihood of the first / of the second) by all the evidence there is.
  double logOdds(const std::array<circle_marker::CirclePosition, 2> &circles) const;

  //! Pose in the frame convention that was set.
  vpHomogeneousMatrix pose(const circle_marker::CirclePosition &circle) const;

  std::vector<Eigen::Vector2d> m_points;                   //!< Contour points, if these were given.
  std::optional<circle_marker::CenteredEllipse> m_ellipse; //!< Ellipse, if it was measured as a whole.
  std::vector<Eigen::Vector2d> m_concentric;               //!< Contour of the concentric circle.
  std::optional<Eigen::Vector3d> m_priorNormal;            //!< Expected normal, of either sign.
  double m_radius = 0.;                                    //!< Radius, metres; 0: not set.
  double m_concentricRadius = 0.;                          //!< Radius of the concentric circle, metres.
  double m_priorSigma = 0.;                                //!< Standard deviation of the expected normal, radians.
  double m_sigma = 1e-4;   //!< Standard deviation of a contour point: 0.1 pixel at a focal length of 1000 pixels.
  double m_logOdds = 0.;   //!< Of the last pose.
  bool m_zAligned = false; //!< Whether z points away from the camera.
  bool m_computeCovariance = false;     //!< Whether computePose() computes the covariance.
  std::optional<vpMatrix> m_covariance; //!< Of the last pose.
};

END_VISP_NAMESPACE

#endif
