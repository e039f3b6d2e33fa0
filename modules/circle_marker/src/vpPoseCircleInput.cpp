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
 * Pose of a circle: its contour and its image as others measure it.
 */

#include <visp3/circle_marker/vpPoseCircle.h>

#include <cmath>
#include <list>
#include <optional>

#include <visp3/blob/vpDot2.h>
#include <visp3/core/vpCircle.h>
#include <visp3/me/vpMeEllipse.h>
#include <visp3/visual_features/vpFeatureEllipse.h>

#include "pose/image_ellipse.h"
#include "pose/pose_circle_impl.h"
#include "support/visp_matrix.h"

BEGIN_VISP_NAMESPACE
using namespace circle_marker;

namespace {
// A point of the image in normalised coordinates.
Eigen::Vector2d pointOf(const vpImagePoint &ip, const vpCameraParameters &cam)
{
  const std::optional<Eigen::Vector2d> point = normalizePoint(ip, cam);
  if (!point) {
    refuse("a contour point is not finite or beyond the field of view of the camera model");
  }
  return *point;
}
} // namespace

/*!
  Adds a contour point.
  \param P : Its image in normalised coordinates, vpPoint::get_x() and get_y(); its 3D coordinates are not used.
  \exception vpException::badValue : It is not finite.
*/
void vpPoseCircle::addPoint(const vpPoint &P)
{
  m_impl->addPoints({{P.get_x(), P.get_y()}});
}

/*!
  Adds a contour point.
  \param ip : The point in pixels.
  \param cam : Camera, of any model: the point is undistorted with vpPixelMeterConversion::convertPoint().
  \exception vpException::badValue : It is not finite, or beyond the field of view of the camera model.
*/
void vpPoseCircle::addPoint(const vpImagePoint &ip, const vpCameraParameters &cam)
{
  m_impl->addPoints({pointOf(ip, cam)});
}

/*! Adds contour points, all or, if one cannot be added, none; see addPoint(const vpPoint &). */
void vpPoseCircle::addPoints(const std::vector<vpPoint> &lP)
{
  std::vector<Eigen::Vector2d> points;
  for (const vpPoint &P : lP) {
    points.push_back({P.get_x(), P.get_y()});
  }
  m_impl->addPoints(points);
}

/*!
  Adds contour points, all or, if one cannot be added, none; see addPoint(const vpImagePoint &, const
  vpCameraParameters &).
*/
void vpPoseCircle::addPoints(const std::vector<vpImagePoint> &ips, const vpCameraParameters &cam)
{
  std::vector<Eigen::Vector2d> points;
  for (const vpImagePoint &ip : ips) {
    points.push_back(pointOf(ip, cam));
  }
  m_impl->addPoints(points);
}

/*! Forgets the contour points and the measured ellipse; radius, evidence and settings stay. */
void vpPoseCircle::clearPoint()
{
  m_impl->m_points.clear();
  m_impl->m_ellipse.reset();
}

/*! \return Number of contour points. */
unsigned int vpPoseCircle::getNbPoints() const
{
  return static_cast<unsigned int>(m_impl->m_points.size());
}

/*!
  \param Q : Conic x^T Q x = 0 in normalised coordinates, 3 x 3, of any scale and sign; its symmetric part is taken.
  \exception vpException::badValue : It is not an ellipse.
  \exception vpException::dimensionError : It is not 3 x 3.
*/
void vpPoseCircle::setConic(const vpMatrix &Q)
{
  m_impl->setEllipse(ellipseOrReason(conicFromMatrix(Q)));
}

/*!
  The same for a conic in pixels, x = (u, v, 1). With a camera with distortion the ellipse's outline is undistorted and
  fitted again, which is exact only as far as the image of the circle was an ellipse in pixels.
  \exception vpException::badValue : It is not an ellipse, or beyond the field of view of the camera model.
  \exception vpException::dimensionError : It is not 3 x 3.
*/
void vpPoseCircle::setConic(const vpMatrix &Q, const vpCameraParameters &cam)
{
  const std::optional<CenteredEllipse> ellipse = normalizeEllipse(ellipseOrReason(conicFromMatrix(Q)), cam);
  if (!ellipse) {
    refuse("the ellipse is beyond the field of view of the camera model");
  }
  m_impl->setEllipse(*ellipse);
}

/*!
  Conic by the coefficients that vpMeEllipse and vpCircle use, in normalised coordinates: six,
  \f$ K_0 x^2 + K_1 y^2 + 2 K_2 x y + 2 K_3 x + 2 K_4 y + K_5 = 0 \f$, or the five of older versions,
  \f$ x^2 + K_0 y^2 + 2 K_1 x y + 2 K_2 x + 2 K_3 y + K_4 = 0 \f$. Not to be confused with the five parameters
  (x, y, n20, n11, n02): see setMoments().
  \exception vpException::badValue : It is not an ellipse.
  \exception vpException::dimensionError : It has neither 5 nor 6 coefficients.
*/
void vpPoseCircle::setConic(const vpColVector &K)
{
  m_impl->setEllipse(ellipseOrReason(conicFromCoefficients(K)));
}

/*!
  The same for coefficients in pixels, u for x and v for y.
  \exception vpException::badValue : It is not an ellipse, or beyond the field of view of the camera model.
  \exception vpException::dimensionError : It has neither 5 nor 6 coefficients.
*/
void vpPoseCircle::setConic(const vpColVector &K, const vpCameraParameters &cam)
{
  setConic(vispMatrix(conicFromCoefficients(K)), cam);
}

/*!
  Ellipse by its moments in normalised coordinates, as vpCircle and vpFeatureEllipse hold them.
  \param x, y : Centre of the ellipse (not the image of the circle's centre).
  \param n20, n11, n02 : Centred second moments divided by the area; those of an ellipse of semi-axes a and b along the
  coordinate axes are a^2/4, 0, b^2/4.
  \exception vpException::badValue : They are not those of an ellipse.
*/
void vpPoseCircle::setMoments(double x, double y, double n20, double n11, double n02)
{
  const std::optional<CenteredEllipse> ellipse = ellipseFromMoments({x, y}, n20, n11, n02);
  if (!ellipse) {
    refuse("the moments are not those of an ellipse: n20 n02 - n11^2 must be positive, and all values finite");
  }
  m_impl->setEllipse(*ellipse);
}

/*!
  The same in pixels: n20 along u, n02 along v. For a camera with distortion see setConic().
  \exception vpException::badValue : They are not those of an ellipse, or it is beyond the field of view of the camera
  model.
*/
void vpPoseCircle::setMoments(const vpImagePoint &center, double n20, double n11, double n02,
                              const vpCameraParameters &cam)
{
  const std::optional<CenteredEllipse> pixels = ellipseFromMoments({center.get_u(), center.get_v()}, n20, n11, n02);
  if (!pixels) {
    refuse("the moments are not those of an ellipse: n20 n02 - n11^2 must be positive, and all values finite");
  }
  const std::optional<CenteredEllipse> ellipse = normalizeEllipse(*pixels, cam);
  if (!ellipse) {
    refuse("the ellipse is beyond the field of view of the camera model");
  }
  m_impl->setEllipse(*ellipse);
}

/*!
  Ellipse of a projected circle, vpCircle::get_x() to get_n02(), after vpCircle::changeFrame() and projection().
  Its radius is not taken: see setRadius().
  \exception vpException::badValue : The circle is not projected, or a part of it is behind the camera.
*/
void vpPoseCircle::setEllipse(const vpCircle &circle)
{
  const double length =
      std::sqrt(circle.getA() * circle.getA() + circle.getB() * circle.getB() + circle.getC() * circle.getC());
  // Without changeFrame() there is no normal, and only the image to judge by.
  if (length > 0.) {
    const double slope = circle.getC() / length;
    const double nearest = circle.getZ() - circle.getR() * std::sqrt(std::fmax(0., 1. - slope * slope));
    if (!(nearest > 0.)) {
      refuse("the circle, or a part of it, is behind the camera");
    }
  }
  setMoments(circle.get_x(), circle.get_y(), circle.get_n20(), circle.get_n11(), circle.get_n02());
}

/*!
  Ellipse of a visual feature: x, y, n20, n11, n02 in normalised coordinates.
  \exception vpException::badValue : They are not those of an ellipse.
*/
void vpPoseCircle::setEllipse(const vpFeatureEllipse &ellipse)
{
  setMoments(ellipse.get_x(), ellipse.get_y(), ellipse.get_n20(), ellipse.get_n11(), ellipse.get_n02());
}

/*!
  Contour of a tracked dot: its border pixels, moved onto the outline (they lie half a pixel inside in the mean),
  become the points. The dot's own moments are not used: they are those of the polygon through the centres of the border
  pixels, half a pixel too small all round, and know no distortion.
  \exception vpException::badValue : The dot has no border, no ellipse fits it, or it is beyond the field of view of the
  camera model: what was measured before stays.
*/
void vpPoseCircle::setEllipse(const vpDot2 &dot, const vpCameraParameters &cam)
{
  const std::list<vpImagePoint> border = dot.getEdges();
  if (border.size() < 5) {
    refuse("the dot has no border: initialise and track it first");
  }
  const std::optional<std::vector<vpImagePoint>> outline = outlineFromBorder({border.begin(), border.end()});
  if (!outline) {
    refuse("no ellipse fits the border of the dot");
  }
  std::vector<Eigen::Vector2d> points;
  for (const vpImagePoint &ip : *outline) {
    points.push_back(pointOf(ip, cam));
  }
  clearPoint();
  m_impl->addPoints(points);
}

/*!
  Ellipse of a moving-edges tracker: its centre and moments in pixels. For a camera with distortion see setConic().
  \exception vpException::badValue : They are not those of an ellipse, or it is beyond the field of view of the camera
  model.
*/
void vpPoseCircle::setEllipse(const vpMeEllipse &ellipse, const vpCameraParameters &cam)
{
  const vpColVector nij = ellipse.get_nij();
  setMoments(ellipse.getCenter(), nij[0], nij[1], nij[2], cam);
}

END_VISP_NAMESPACE
