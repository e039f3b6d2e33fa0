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
  \file vpPoseCircle.h
  \brief Pose of a circle of known radius from its image, an ellipse.
*/

#ifndef VP_POSE_CIRCLE_H
#define VP_POSE_CIRCLE_H

#include <memory>
#include <vector>

#include <visp3/circle_marker/vpConfigCircleMarker.h>
#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpColVector.h>
#include <visp3/core/vpColor.h>
#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/core/vpImage.h>
#include <visp3/core/vpImagePoint.h>
#include <visp3/core/vpMatrix.h>
#include <visp3/core/vpPoint.h>
#include <visp3/core/vpRGBa.h>

BEGIN_VISP_NAMESPACE
class vpCircle;
class vpDot2;
class vpFeatureEllipse;
class vpMeEllipse;

/*!
  \class vpPoseCircle
  \ingroup group_circle_marker
  \brief Pose of a circle of known radius from its image, in closed form: both solutions.

  The image of a circle is an ellipse \f$ {\bf x}^T {\bf Q} {\bf x} = 0 \f$ in normalised coordinates x = (x, y, 1).
  With the eigenvalues \f$ \lambda_1 \ge \lambda_2 > 0 > \lambda_3 \f$ of Q and unit eigenvectors, the circles of radius
  r with that image have, for s = +1 and -1, the normal N (away from the camera) and the centre C \f[ {\bf N} = s \, g
  \, {\bf e}_1 + k \, {\bf e}_3, \quad
      {\bf C} = \frac{r}{\sqrt{-\lambda_1 \lambda_3}} (s \, \lambda_3 \, g \, {\bf e}_1 + \lambda_1 k \, {\bf e}_3),
  \quad g = \sqrt{\frac{\lambda_1 - \lambda_2}{\lambda_1 - \lambda_3}}, \quad k = \sqrt{\frac{\lambda_2 -
  \lambda_3}{\lambda_1 - \lambda_3}}. \f] K. Kanatani and W. Liu, 3D interpretation of conics and orthogonality, CVGIP:
  Image Understanding 58 (1993); Q. Chen, H. Wu and T. Wada, Camera calibration with two arbitrary coplanar circles,
  ECCV 2004.

  \code
  vpPoseCircle pose;
  pose.setRadius(0.090);                                  // metres
  pose.addPoints(contour, cam);                           // std::vector<vpImagePoint>, pixels
  vpHomogeneousMatrix cMo, cMo2;
  pose.computePose(cMo, &cMo2);                           // both solutions
  \endcode

  - **Input.** Either contour points or one measurement of the whole ellipse; the last kind given counts. Lens
  distortion does not map circles to ellipses in pixels: give the contour's points where you have them, they are
  undistorted one by one with vpPixelMeterConversion before the ellipse is fitted.
  - **Frame.** Origin at the circle's centre. As with vpDetectorAprilTag z points toward the camera by default, and y is
  up where x is right; after setZAlignedWithCameraAxis(true) z points away from the camera and y is down. A circle does
    not show its spin about the normal: the x axis is the direction of its plane that is closest to the camera's x axis.
  - **Order.** A second, concentric circle (setConcentricCircle()) and an expected pose (setPriorPose()) tell the two
    solutions apart: the likelier comes first, and getLogOdds() is ln(likelihood of the first / of the second). Without
    either, the first is the one whose normal is closer to the optical axis, and getLogOdds() is 0: no evidence.
  - **Errors.** Everything that prevents a pose throws a vpException with the reason: a conic that is not an ellipse, a
    circle behind the camera, no or a bad radius, fewer than 5 points, points on a line, values that are not finite.
*/
class VISP_EXPORT vpPoseCircle
{
public:
  vpPoseCircle();
  explicit vpPoseCircle(double radius);
  vpPoseCircle(const vpPoseCircle &other);
  vpPoseCircle &operator=(const vpPoseCircle &other);
  ~vpPoseCircle();

  /** @name The circle and its contour's points */
  //@{
  void setRadius(double radius);
  double getRadius() const;
  void addPoint(const vpPoint &P);
  void addPoint(const vpImagePoint &ip, const vpCameraParameters &cam);
  void addPoints(const std::vector<vpPoint> &lP);
  void addPoints(const std::vector<vpImagePoint> &ips, const vpCameraParameters &cam);
  void clearPoint();
  unsigned int getNbPoints() const;
  //@}

  /** @name Measurements of the whole ellipse, instead of points */
  //@{
  void setConic(const vpMatrix &Q);
  void setConic(const vpMatrix &Q, const vpCameraParameters &cam);
  void setConic(const vpColVector &K);
  void setConic(const vpColVector &K, const vpCameraParameters &cam);
  void setMoments(double x, double y, double n20, double n11, double n02);
  void setMoments(const vpImagePoint &center, double n20, double n11, double n02, const vpCameraParameters &cam);
  void setEllipse(const vpCircle &circle);
  void setEllipse(const vpFeatureEllipse &ellipse);
  void setEllipse(const vpDot2 &dot, const vpCameraParameters &cam);
  void setEllipse(const vpMeEllipse &ellipse, const vpCameraParameters &cam);
  //@}

  /** @name Evidence that orders the two solutions */
  //@{
  void setConcentricCircle(double radius, const vpMatrix &Q);
  void setConcentricCircle(double radius, const std::vector<vpImagePoint> &ips, const vpCameraParameters &cam);
  void setPriorPose(const vpHomogeneousMatrix &cMo, double sigma = 0.0873);
  void setPriorNormal(const vpColVector &normal, double sigma = 0.0873);
  void clearEvidence();
  //@}

  /** @name Pose */
  //@{
  bool computePose(vpHomogeneousMatrix &cMo, vpHomogeneousMatrix *cMo2 = nullptr);
  double getLogOdds() const;
  double computeResidual(const vpHomogeneousMatrix &cMo) const;
  vpMatrix getConic() const;
  //@}

  /** @name Settings */
  //@{
  void setZAlignedWithCameraAxis(bool aligned);
  void setPointSigma(double sigma);
  void setCovarianceComputation(bool flag);
  vpMatrix getCovarianceMatrix() const;
  //@}

  static void display(const vpImage<unsigned char> &I, const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam,
                      double radius, const vpColor &color = vpColor::none, unsigned int thickness = 1);
  static void display(const vpImage<vpRGBa> &I, const vpHomogeneousMatrix &cMo, const vpCameraParameters &cam,
                      double radius, const vpColor &color = vpColor::none, unsigned int thickness = 1);

private:
  class Impl;
  std::unique_ptr<Impl> m_impl; //!< Settings, measurements and results.
};

END_VISP_NAMESPACE

#endif
