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
 * From pixels to the marker's plane, eight or sixteen at a time.
 */

/*!
  \file plane_lanes.h
  \brief From pixels to the marker's plane, eight or sixteen at a time.
*/

#ifndef VP_CIRCLE_MARKER_PLANE_LANES_H
#define VP_CIRCLE_MARKER_PLANE_LANES_H

#include <utility>

#include "pose/marker_plane.h"
#include "refine/lanes.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
/*! Origin and unit of image coordinates in single precision: a point of the marker's image and the size of a pixel. */
struct ImageReference
{
  Eigen::Vector2d meter = Eigen::Vector2d::Zero(); //!< The origin, in normalised coordinates.
  double unit = 1.;                                //!< Size of a pixel there, in normalised coordinates.
  //! Second derivative by the pixel (u, v) of where a distorting lens has it, in pixels (u, v), 1 / pixel: of each,
  //! along uu, uv and vv.
  Eigen::Matrix<double, 2, 3> lens = Eigen::Matrix<double, 2, 3>::Zero();
};

/*! Where pixels are in the image. */
struct PlaceLanes
{
  Lanes x, y;       //!< From the reference's origin, in its unit.
  Lanes xByU, xByV; //!< Derivative of x by the pixel.
  Lanes yByU, yByV; //!< And of y.
};

/*! Where pixels are seen on the marker's plane, in units of the outer radius. */
struct PlaneLanes
{
  Lanes qx, qy;                     //!< Place.
  Lanes qxByU, qxByV, qyByU, qyByV; //!< Derivatives by the pixel, where the blur is round.
  Lanes wByU, wByV;                 //!< Derivative of the homography's denominator 1 + w p by the pixel, over it.
  Lanes radius;                     //!< Distance from the centre.
  Lanes outX, outY;                 //!< Unit vector away from the centre.
  Lanes gradientU, gradientV;       //!< Derivative of the radius by the pixel.
  Lanes gradient;                   //!< Its length.
};

/*!
  What a straight way through the image is not on the plane, which is seen in perspective and through a lens that may
  distort: second derivatives by the pixel, over the first along a unit vector (u, v) across an edge. The coordinates
  are those in which the blur is round; the lens is taken not to know of these.
*/
class SecondOrder
{
public:
  explicit SecondOrder(const ImageReference &reference) : m_lens(reference.lens.cast<float>()) {}

  /*! Along the way across: how much the scale changes from pixel to pixel, share of it. */
  Lanes across(const PlaneLanes &point, const Lanes &u, const Lanes &v) const
  {
    return lensAlong(u, v, u * u, u * v, v * v) - 2.f * (u * point.wByU + v * point.wByV);
  }

  /*! Along the edge: how much it is bent, 1 / pixel. In perspective straight lines are straight. */
  Lanes along(const Lanes &u, const Lanes &v) const { return lensAlong(u, v, v * v, -u * v, u * u); }

private:
  Lanes lensAlong(const Lanes &u, const Lanes &v, const Lanes &uu, const Lanes &uv, const Lanes &vv) const
  {
    return u * (m_lens(0, 0) * uu + 2.f * m_lens(0, 1) * uv + m_lens(0, 2) * vv) +
           v * (m_lens(1, 0) * uu + 2.f * m_lens(1, 1) * uv + m_lens(1, 2) * vv);
  }

  Eigen::Matrix<float, 2, 3, Eigen::DontAlign> m_lens;
};

/*! A direction of the image as the plane sees it: from q, s steps lead to (q + s (x, y)) / (1 + s w). */
struct DirectionLanes
{
  Lanes x, y, w;
};

/*!
  The way from the image to the plane at a pose: a homography, q = (A p + b) / (1 + w p). Derivatives by the pixel are
  taken in coordinates in which the blur is round: by the columns of the matrix BlurParameters::shape() in the image's.
*/
class PlaneHomography
{
public:
  PlaneHomography(const MarkerPlane &plane, const ImageReference &reference, const Eigen::Matrix2d &blurShape);

  /*! Where pixels are seen on the plane. */
  void apply(const PlaceLanes &place, PlaneLanes &point) const
  {
    const Lanes perSlope = (1.f + m_wx * place.x + m_wy * place.y).inverse();
    point.qx = (m_axx * place.x + m_axy * place.y + m_bx) * perSlope;
    point.qy = (m_ayx * place.x + m_ayy * place.y + m_by) * perSlope;
    const Lanes qxByX = (m_axx - m_wx * point.qx) * perSlope;
    const Lanes qxByY = (m_axy - m_wy * point.qx) * perSlope;
    const Lanes qyByX = (m_ayx - m_wx * point.qy) * perSlope;
    const Lanes qyByY = (m_ayy - m_wy * point.qy) * perSlope;
    const Lanes qxByU = qxByX * place.xByU + qxByY * place.yByU;
    const Lanes qxByV = qxByX * place.xByV + qxByY * place.yByV;
    const Lanes qyByU = qyByX * place.xByU + qyByY * place.yByU;
    const Lanes qyByV = qyByX * place.xByV + qyByY * place.yByV;
    point.qxByU = m_suu * qxByU + m_suv * qxByV;
    point.qxByV = m_suv * qxByU + m_svv * qxByV;
    point.qyByU = m_suu * qyByU + m_suv * qyByV;
    point.qyByV = m_suv * qyByU + m_svv * qyByV;
    const Lanes wByU = (m_wx * place.xByU + m_wy * place.yByU) * perSlope;
    const Lanes wByV = (m_wx * place.xByV + m_wy * place.yByV) * perSlope;
    point.wByU = m_suu * wByU + m_suv * wByV;
    point.wByV = m_suv * wByU + m_svv * wByV;
    if (m_isBent) {
      bend(point);
    }
    // At the very centre the direction does not matter: no edge is near.
    point.radius = (point.qx * point.qx + point.qy * point.qy).max(1e-12f).sqrt();
    const Lanes perRadius = point.radius.inverse();
    point.outX = point.qx * perRadius;
    point.outY = point.qy * perRadius;
    point.gradientU = point.qxByU * point.outX + point.qyByU * point.outY;
    point.gradientV = point.qxByV * point.outX + point.qyByV * point.outY;
    point.gradient = (point.gradientU * point.gradientU + point.gradientV * point.gradientV).sqrt();
  }

  /*! Steps of (u, v) pixels from places, on straight lines, in the coordinates in which the blur is round. */
  DirectionLanes along(const PlaceLanes &place, const Lanes &u, const Lanes &v) const
  {
    const Lanes perSlope = (1.f + m_wx * place.x + m_wy * place.y).inverse();
    const Lanes alongU = m_suu * u + m_suv * v;
    const Lanes alongV = m_suv * u + m_svv * v;
    const Lanes x = (place.xByU * alongU + place.xByV * alongV) * perSlope;
    const Lanes y = (place.yByU * alongU + place.yByV * alongV) * perSlope;
    const DirectionLanes direction = {m_axx * x + m_axy * y, m_ayx * x + m_ayy * y, m_wx * x + m_wy * y};
    if (!m_isBent) {
      return direction;
    }
    // Straight lines of the image are bent on the sheet: by their direction, at the pixel.
    PlaneLanes point;
    point.qx = (m_axx * place.x + m_axy * place.y + m_bx) * perSlope;
    point.qy = (m_ayx * place.x + m_ayy * place.y + m_by) * perSlope;
    point.qxByU = direction.x - direction.w * point.qx;
    point.qyByU = direction.y - direction.w * point.qy;
    point.qxByV.setZero();
    point.qyByV.setZero();
    bend(point);
    return {point.qxByU + direction.w * point.qx, point.qyByU + direction.w * point.qy, direction.w};
  }

private:
  // From where rays meet the plane to where they meet the sheet: see planePoint().
  void bend(PlaneLanes &point) const
  {
    const Lanes slantX = m_perDepth * (point.qx - m_cx);
    const Lanes slantY = m_perDepth * (point.qy - m_cy);
    Lanes x = point.qx;
    Lanes y = point.qy;
    Lanes slopeX, slopeY, height;
    for (int i = 0; i <= SheetBend::steps; ++i) {
      slopeX = (m_bow + m_saddleX) * x + m_saddleY * y;
      slopeY = (m_bow - m_saddleX) * y + m_saddleY * x;
      const Lanes along = x * slopeX + y * slopeY;
      height = 0.5f * (along - m_bow);
      if (i < SheetBend::steps) {
        x = point.qx + height * slantX + (1.f / 6.f) * along * slopeX;
        y = point.qy + height * slantY + (1.f / 6.f) * along * slopeY;
      }
    }
    point.qx = x;
    point.qy = y;
    const Lanes longer = 1.f + m_perDepth * height;
    const Lanes perRest = (1.f - slopeX * slantX - slopeY * slantY).inverse();
    for (const auto &[byX, byY] : {std::pair<Lanes &, Lanes &>(point.qxByU, point.qyByU),
                                   std::pair<Lanes &, Lanes &>(point.qxByV, point.qyByV)}) {
      byX = longer * byX;
      byY = longer * byY;
      const Lanes higher = perRest * (slopeX * byX + slopeY * byY);
      byX += slantX * higher;
      byY += slantY * higher;
    }
  }

  float m_axx, m_axy, m_ayx, m_ayy, m_bx, m_by, m_wx, m_wy;
  float m_suu, m_suv, m_svv; // of the blur's shape
  bool m_isBent;
  float m_bow, m_saddleX, m_saddleY; // of the sheet
  float m_cx, m_cy, m_perDepth;      // camera's centre in the marker's frame, in radii; 1 / |c_z|
};
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
