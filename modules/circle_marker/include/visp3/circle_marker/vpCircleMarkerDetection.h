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
 * What the detector knows of one circular marker in one image.
 */

/*!
  \file vpCircleMarkerDetection.h
  \brief What the detector knows of one circular marker in one image.
*/

#ifndef VP_CIRCLE_MARKER_DETECTION_H
#define VP_CIRCLE_MARKER_DETECTION_H

#include <cmath>

#include <visp3/circle_marker/vpCircleMarkerFamily.h>
#include <visp3/circle_marker/vpConfigCircleMarker.h>
#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/core/vpImagePoint.h>
#include <visp3/core/vpMatrix.h>

BEGIN_VISP_NAMESPACE

/*!
  \struct vpImageEllipse
  \ingroup group_circle_marker
  \brief An ellipse in the image, in pixels; integer coordinates are pixel centres.
*/
struct vpImageEllipse
{
  vpImagePoint center; //!< Centre of the ellipse (not the image of the circle's centre).
  double a = 0.;       //!< Semi-major axis, pixels.
  double b = 0.;       //!< Semi-minor axis, pixels.
  double angle = 0.;   //!< Angle of the major axis from the u axis toward the v axis, radians, in ]-pi/2, pi/2].
};

/*!
  \struct vpCircleMarkerDetection
  \ingroup group_circle_marker
  \brief One detected marker: identity, image, both poses and their covariances.

  The frame of the poses follows vpDetectorCircleMarker::setZAlignedWithCameraAxis(). A covariance is that of
  \f$ \delta = (\upsilon, \omega) \f$ in the camera frame, metres and radians, with
  \f$ ^cM_o^{true} = \exp(\delta) \, ^cM_o \f$ (vpExponentialMap), and does not depend on that choice.
  It is about the camera's centre. That of where the marker is and how it is turned, of \f$ (dt, \omega) \f$ in the
  camera frame with \f$ t^{true} = t + dt \f$ and \f$ R^{true} = \exp([\omega]_\times) R \f$, stands beside it: the
  square root of its third diagonal element is the standard deviation of z. The other one has there what a turn about
  the camera does besides, which is much more beside the axis. To first order \f$ dt = \upsilon + \omega \times t \f$,
  but far away the term \f$ -\omega \times dt / 2 \f$ of the logarithm is as large as the error across the line of
  sight, so that neither follows from the other. Each pose has that of its own fit: of two, one is true, and the
  covariance does not tell of the other. A second pose that trails far behind (log-odds of some 30) was left as a fit of
  few pixels had it, with the covariance of these.
*/
struct vpCircleMarkerDetection
{
  vpCircleMarkerFamily family;           //!< Family the marker belongs to.
  int id = -1;                           //!< Identity in the family; -1 for a family without code.
  unsigned int hamming = 0;              //!< Number of sectors that had to be corrected: see getHammingDistance().
  double margin = 0.;                    //!< Decision margin in [0, 1]: see vpDetectorCircleMarker::getMargin().
  double size = 0.;                      //!< Outer diameter of the ring used for the poses, metres.
  unsigned int dof = 5;                  //!< Degrees of freedom that were measured: 6 with a code, 5 without.
  vpImagePoint center;                   //!< Image of the circle's centre, pixels.
  vpImageEllipse ellipse;                //!< Image of the ring's outer edge, pixels.
  vpHomogeneousMatrix cMo;               //!< The pose: the more likely solution.
  bool hasSecondPose = false;            //!< Whether there is another solution.
  vpHomogeneousMatrix cMo2;              //!< The less likely solution; the identity if there is none.
  double cost = 0.;                      //!< Negative log-likelihood of cMo, up to a constant common to both poses.
  double cost2 = HUGE_VAL;               //!< cost + logOdds; HUGE_VAL without a second solution.
  double logOdds = HUGE_VAL;             //!< ln(odds of cMo against cMo2), as far as the image is as the model has it.
  vpMatrix covariance = vpMatrix(6, 6);  //!< 6 x 6 covariance of cMo, metres and radians.
  vpMatrix covariance2 = vpMatrix(6, 6); //!< The same of cMo2; zero without a second solution.
  vpMatrix covarianceAtMarker = vpMatrix(6, 6);  //!< 6 x 6 covariance of place and turn by cMo, metres and radians.
  vpMatrix covarianceAtMarker2 = vpMatrix(6, 6); //!< The same of cMo2; zero without a second solution.
  bool isInverse = false; //!< Whether it is white on black: see vpDetectorCircleMarker::setPolarity().
  double visible = 0.;    //!< Share of the ring's outer edge that was seen, in [0, 1].
};

END_VISP_NAMESPACE

#endif
