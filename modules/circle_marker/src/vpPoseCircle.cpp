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
 * Pose of a circle of known radius from its image, an ellipse.
 */

/*!
  \file vpPoseCircle.cpp
  \brief Pose of a circle of known radius from its image, an ellipse.
*/

#include <visp3/circle_marker/vpPoseCircle.h>

#include <cmath>
#include <optional>
#include <utility>

#include <visp3/core/vpException.h>

#include "pose/circle_covariance.h"
#include "pose/circle_evidence.h"
#include "pose/image_ellipse.h"
#include "pose/pose_circle_impl.h"
#include "support/visp_matrix.h"

BEGIN_VISP_NAMESPACE
using namespace circle_marker;

/*! A circle whose radius is still to be set. */
vpPoseCircle::vpPoseCircle() : m_impl(std::make_unique<Impl>()) {}

/*!
  \param radius : Radius of the circle, metres.
  \exception vpException::badValue : The radius is not positive and finite.
*/
vpPoseCircle::vpPoseCircle(double radius) : vpPoseCircle()
{
  setRadius(radius);
}

/*!
  Copies settings, measurements and results.
  \param other : Object to copy.
*/
vpPoseCircle::vpPoseCircle(const vpPoseCircle &other) : m_impl(std::make_unique<Impl>(*other.m_impl)) {}

/*!
  Copies settings, measurements and results.
  \param other : Object to copy.
*/
vpPoseCircle &vpPoseCircle::operator=(const vpPoseCircle &other)
{
  m_impl = std::make_unique<Impl>(*other.m_impl); // the old one stays if there is no memory
  return *this;
}

vpPoseCircle::~vpPoseCircle() = default;

/*!
  \param radius : Radius of the circle, metres.
  \exception vpException::badValue : The radius is not positive and finite.
*/
void vpPoseCircle::setRadius(double radius)
{
  if (!isPositive(radius)) {
    throw vpException(vpException::badValue, "vpPoseCircle: the radius must be positive and finite, metres, not %g",
                      radius);
  }
  m_impl->m_radius = radius;
}

/*! \return Radius of the circle, metres; 0 if it was not set. */
double vpPoseCircle::getRadius() const
{
  return m_impl->m_radius;
}

/*!
  A second circle around the same centre in the same plane, for instance the inner edge of a ring. The two solutions
  predict its image at different places. It orders the solutions; the pose stays that of the first circle. One of the
  first circle's own radius says nothing.
  \param radius : Its radius, metres.
  \param Q : Its conic in normalised coordinates, 3 x 3; of one that is not symmetric, its symmetric part.
  \exception vpException::badValue : The radius is not positive and finite, or Q is no ellipse.
  \exception vpException::dimensionError : Q is not 3 x 3.
*/
void vpPoseCircle::setConcentricCircle(double radius, const vpMatrix &Q)
{
  if (!isPositive(radius)) {
    refuse("the radius of the concentric circle must be positive and finite, metres");
  }
  m_impl->m_concentric = sampleEllipse(ellipseOrReason(conicFromMatrix(Q)), samplesOfAnEllipse);
  m_impl->m_concentricRadius = radius;
}

/*!
  The same from points of its contour.
  \param radius : Its radius, metres.
  \param ips : Points of its contour, pixels; no points say nothing.
  \param cam : Camera, of any model.
  \exception vpException::badValue : The radius is not positive and finite, or a point is not finite or beyond the field
  of view of the camera model.
*/
void vpPoseCircle::setConcentricCircle(double radius, const std::vector<vpImagePoint> &ips,
                                       const vpCameraParameters &cam)
{
  if (!isPositive(radius)) {
    refuse("the radius of the concentric circle must be positive and finite, metres");
  }
  std::vector<Eigen::Vector2d> points;
  for (const vpImagePoint &ip : ips) {
    const std::optional<Eigen::Vector2d> point = normalizePoint(ip, cam);
    if (!point) {
      refuse("a point of the concentric circle is not finite or beyond the field of view of the camera model");
    }
    points.push_back(*point);
  }
  m_impl->m_concentric = points;
  m_impl->m_concentricRadius = radius;
}

/*!
  An expected pose, for instance that of the image before: its z axis, of either sign, is compared with both normals.
  \param cMo : The pose, in either frame convention.
  \param sigma : Standard deviation of the angle between both normals, radians; 5 degrees by default.
  \exception vpException::badValue : As for setPriorNormal().
*/
void vpPoseCircle::setPriorPose(const vpHomogeneousMatrix &cMo, double sigma)
{
  vpColVector normal(3);
  for (unsigned int i = 0; i < 3; i++) {
    normal[i] = cMo[i][2];
  }
  setPriorNormal(normal, sigma);
}

/*!
  The same from an expected normal of the circle's plane.
  \param normal : Normal in the camera frame, three coordinates, of either sign and any length.
  \param sigma : Standard deviation of the angle, radians, at least 1e-12; 5 degrees by default.
  \exception vpException::badValue : The normal is not three finite coordinates, not all zero, or sigma is less.
*/
void vpPoseCircle::setPriorNormal(const vpColVector &normal, double sigma)
{
  if (normal.size() != 3) {
    refuse("the expected normal must be three finite coordinates, not all zero");
  }
  const Eigen::Vector3d direction(normal[0], normal[1], normal[2]);
  if (!direction.allFinite() || direction.isZero(0.)) {
    refuse("the expected normal must be three finite coordinates, not all zero");
  }
  if (!isDeviation(sigma)) {
    refuse("the standard deviation of the expected normal must be positive, finite and no less than 1e-12 rad");
  }
  m_impl->m_priorNormal = direction.stableNormalized();
  m_impl->m_priorSigma = sigma;
}

/*! Forgets the concentric circle and the expected pose. */
void vpPoseCircle::clearEvidence()
{
  m_impl->m_concentric.clear();
  m_impl->m_priorNormal.reset();
}

/*!
  Computes both poses.
  \param cMo : The likelier pose.
  \param cMo2 : The other one, if not nullptr; equal to cMo for a circle seen along its own axis.
  \return true, as vpPose::computePose() for a pose that was found: whatever prevents it throws.
  \exception vpException::notInitialized : No radius, or fewer than 5 points and no measured ellipse.
  \exception vpException::badValue : No ellipse fits the points, or no circle has that image.
*/
bool vpPoseCircle::computePose(vpHomogeneousMatrix &cMo, vpHomogeneousMatrix *cMo2)
{
  m_impl->m_covariance.reset();
  m_impl->m_logOdds = 0.;
  if (!isPositive(m_impl->m_radius)) {
    throw vpException(vpException::notInitialized,
                      "vpPoseCircle: the radius of the circle is not set: see setRadius()");
  }
  std::optional<std::array<CirclePosition, 2>> circles = circlesFromEllipse(m_impl->ellipse(), m_impl->m_radius);
  if (!circles) {
    refuse("the ellipse is too small or too large to be the image of a circle");
  }
  m_impl->m_logOdds = m_impl->logOdds(*circles);
  if (m_impl->m_logOdds < 0.) {
    std::swap((*circles)[0], (*circles)[1]);
    m_impl->m_logOdds = -m_impl->m_logOdds;
  }
  if (m_impl->m_computeCovariance) {
    m_impl->m_covariance = vispMatrix(circleCovariance((*circles)[0], m_impl->contour(), m_impl->m_sigma));
  }
  cMo = m_impl->pose((*circles)[0]);
  if (cMo2 != nullptr) {
    *cMo2 = m_impl->pose((*circles)[1]);
  }
  return true;
}

/*!
  \return ln(likelihood of the first pose / likelihood of the second) of the last computePose(): not negative; 0 without
  evidence.
*/
double vpPoseCircle::getLogOdds() const
{
  return m_impl->m_logOdds;
}

/*!
  \param cMo : A pose, in either frame convention.
  \return Sum of the squared distances, normalised coordinates, of the contour points to the image of the circle at that
  pose; a measured ellipse counts as 72 points. HUGE_VAL for a circle behind the camera, which has no image.
  \exception vpException::notInitialized : No radius.
*/
double vpPoseCircle::computeResidual(const vpHomogeneousMatrix &cMo) const
{
  if (!isPositive(m_impl->m_radius)) {
    throw vpException(vpException::notInitialized,
                      "vpPoseCircle: the radius of the circle is not set: see setRadius()");
  }
  if (!isPositive(cMo[2][3])) {
    return HUGE_VAL;
  }
  return squaredDistances(conicFromPose(cMo, m_impl->m_radius), m_impl->contour());
}

/*!
  \return Conic of the measured or fitted ellipse in normalised coordinates: 3 x 3, unit norm, negative inside.
  \exception vpException::notInitialized : Fewer than 5 points and no measured ellipse.
  \exception vpException::badValue : No ellipse fits the points.
*/
vpMatrix vpPoseCircle::getConic() const
{
  const CenteredEllipse ellipse = m_impl->ellipse();
  const Eigen::Vector2d b = -ellipse.A * ellipse.center;
  Eigen::Matrix3d Q;
  Q << ellipse.A, b, b.transpose(), ellipse.offset - b.dot(ellipse.center);
  Q /= Q.norm();
  return vispMatrix(Q);
}

/*!
  \param aligned : Whether z points away from the camera (and y down), or toward it (and y up), the default.
*/
void vpPoseCircle::setZAlignedWithCameraAxis(bool aligned)
{
  m_impl->m_zAligned = aligned;
}

/*!
  \param sigma : Standard deviation of a contour point across the contour in normalised coordinates, pixels / focal
  length, at least 1e-12; 1e-4 by default. It scales the covariance and the log-odds. Points count as independent: those
  of a contour as many as there are, a whole ellipse (setConic(), setMoments(), setEllipse() of other than a vpDot2) as
  72, whatever it was fitted to.
  \exception vpException::badValue : It is less, or not finite.
*/
void vpPoseCircle::setPointSigma(double sigma)
{
  if (!isDeviation(sigma)) {
    refuse("the standard deviation of a contour point must be positive, finite and no less than 1e-12, normalised "
           "coordinates");
  }
  m_impl->m_sigma = sigma;
}

/*! \param flag : Whether computePose() computes the covariance of the pose. */
void vpPoseCircle::setCovarianceComputation(bool flag)
{
  m_impl->m_computeCovariance = flag;
}

/*!
  \return 6 x 6 covariance of the first pose of the last computePose(), of \f$ \delta = (\upsilon, \omega) \f$ in the
  camera frame with \f$ ^cM_o^{true} = \exp(\delta) \, ^cM_o \f$ (vpExponentialMap), metres and radians. The spin about
  the normal is not measured and has the variance of a uniform angle, pi^2/3. It follows from the geometry and from
  setPointSigma() alone, not from how well the contour fits: see computeResidual(). It is right to first order: that of
  the centre's place dt and the turn \f$ \omega \f$, \f$ \upsilon = dt - \omega \times t \f$. \exception
  vpException::notInitialized : It was not computed: see setCovarianceComputation().
*/
vpMatrix vpPoseCircle::getCovarianceMatrix() const
{
  if (!m_impl->m_covariance) {
    throw vpException(vpException::notInitialized,
                      "vpPoseCircle: no covariance: call setCovarianceComputation(true) before computePose()");
  }
  return *m_impl->m_covariance;
}

END_VISP_NAMESPACE
