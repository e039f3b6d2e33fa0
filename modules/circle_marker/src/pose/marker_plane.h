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
 * The plane of a marker seen by a camera.
 */

#ifndef VP_CIRCLE_MARKER_MARKER_PLANE_H
#define VP_CIRCLE_MARKER_MARKER_PLANE_H

#include <Eigen/Core>

#include "pose/circle_from_conic.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  How the sheet is bent: the point q of the print is at the height
  \f$ h = b_0 (q^2 - 1) / 2 + b_1 (q_x^2 - q_y^2) / 2 + b_2 q_x q_y \f$ beyond the marker's plane, away from the camera,
  all in outer radii. On the ring's outer circle its mean is 0: that is where the plane is. Paper bends without being
  stretched, about one axis, and draws the print together by \f$ (q \cdot \nabla h) \nabla h / 6 \f$, to third order.
*/
struct SheetBend
{
  /*! Whether the sheet is not flat. */
  bool isAny() const { return bow != 0. || saddle.x() != 0. || saddle.y() != 0.; }

  /*! Height of a point of the print. */
  double height(const Eigen::Vector2d &q) const;

  /*! Its derivative. */
  Eigen::Vector2d slope(const Eigen::Vector2d &q) const;

  /*! By how much it is drawn together with the print, along the plane. */
  Eigen::Vector2d shift(const Eigen::Vector2d &q) const;

  /*! The point of the print that is seen where the plane would be at \e flat; slant: see MarkerPlane::slantAt(). */
  Eigen::Vector2d seenAt(const Eigen::Vector2d &flat, const Eigen::Vector2d &slant) const;

  /*! The same sheet in a frame that is turned about the normal, rad, positive from x to y. */
  void spin(double angle);

  /*! Steps to the point that is seen: each leaves some hundredths of the way. */
  static constexpr int steps = 3;

  double bow = 0.;                                  //!< b_0.
  Eigen::Vector2d saddle = Eigen::Vector2d::Zero(); //!< (b_1, b_2).
};

/*!
  Pose of a marker, z-aligned (x right, y down, z into the marker), with the ring's outer radius as unit of length in
  its plane: the point q of the plane is centre + radius (q.x ex + q.y ey) in the camera frame, metres.
*/
struct MarkerPlane
{
  Eigen::Vector3d center;   //!< Origin of the marker frame, metres.
  Eigen::Matrix3d rotation; //!< Columns ex, ey and the normal away from the camera.
  double radius = 0.;       //!< Outer radius of the ring, metres.
  SheetBend bend;           //!< Of the sheet.

  /*! Normalised coordinates of the image of a point of the sheet. */
  Eigen::Vector2d project(const Eigen::Vector2d &q) const;

  /*! The point of the sheet whose image is \e meter, in normalised coordinates. */
  Eigen::Vector2d intersect(const Eigen::Vector2d &meter) const;

  /*! How far the ray through a point of the plane goes along it, on its way by one unit of height away from the camera.
   */
  Eigen::Vector2d slantAt(const Eigen::Vector2d &flat) const;

  /*! Whether the print's front is seen, and the camera is not nearly on it. */
  bool showsFront() const;

  /*! Cosine of the angle at which the camera sees the centre: 1 facing it, 0 edge-on. */
  double foreshortening() const;

  /*!
    Semi-minor axis of the outer edge's image where the pixels are of a size, pixels; to first order in the radius over
    the distance.
    \param unit : Size of a pixel, normalised coordinates.
  */
  double semiMinor(double unit) const;

  /*! The same pose of a flat sheet. */
  MarkerPlane flattened() const
  {
    MarkerPlane flat = *this;
    flat.bend = SheetBend();
    return flat;
  }

  /*! Turns the marker about its normal, rad, positive from x to y. */
  void spin(double angle);
};

/*!
  Covariance of (t, w) along other axes.
  \param covariance : Along the axes of a frame.
  \param rotation : From that frame to the other.
  \param unit : What the first has for its unit of length, in that of the other.
*/
Eigen::Matrix<double, 6, 6> turnedCovariance(const Eigen::Matrix<double, 6, 6> &covariance,
                                             const Eigen::Matrix3d &rotation, double unit = 1.);

/*! Turns the second pose about its normal so that its x axis has the image direction of the first pose's x axis. */
void copySpin(const MarkerPlane &from, MarkerPlane &to);

/*! How far the outline moves in the image from one pose to another, normalised coordinates, as four points show it. */
double outlineMotion(const MarkerPlane &from, const MarkerPlane &to);

/*!
  How far the print moves in the image from one pose to another, its spin too: the largest distance that eight points of
  the outline and the centre move, normalised coordinates.
*/
double printMotion(const MarkerPlane &from, const MarkerPlane &to);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
