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
 * Least error of a marker's pose that the noise of an image allows.
 */

/*!
  \file vpMarkerPoseBound.h
  \brief Least error of a marker's pose that the noise of an image allows.
*/

#ifndef VP_MARKER_POSE_BOUND_H
#define VP_MARKER_POSE_BOUND_H

#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/core/vpMatrix.h>

#include <visp3/circle_marker_simulator/vpConfigCircleMarkerSimulator.h>
#include <visp3/circle_marker_simulator/vpScenePhotometry.h>
#include <visp3/circle_marker_simulator/vpSimulatedMarker.h>

BEGIN_VISP_NAMESPACE

/*!
  \struct vpPoseBound
  \ingroup group_circle_marker_simulator
  \brief Cramer-Rao bound of a pose: no unbiased estimator has a smaller covariance.

  The pose error is delta = (upsilon, omega), translation first, in the camera frame: cMo_true = exp(delta) cMo. Because
  delta turns about the camera's centre, the errors of the marker's own centre are stated beside it.

  The bound is of first order. Where the normal's error is not small against the viewing angle (a marker that is far
  away and faces the camera) the true least error is another one, and less than a large bound.
*/
struct vpPoseBound
{
  vpMatrix information; //!< 6 x 6, of delta, in 1/m and 1/rad; levels and blur unknown. Singular without a code.
  vpMatrix covariance;  //!< 6 x 6, of delta, in m and rad; the spin of a marker without code has the variance pi^2 / 3.
  unsigned int dof = 6; //!< Degrees of freedom of the pose: 5 for a marker without code.
  double x = 0.;        //!< Standard deviation of the marker's centre along the camera's x axis, in metres.
  double y = 0.;        //!< Standard deviation of the marker's centre along the camera's y axis, in metres.
  double z = 0.;        //!< Standard deviation of the marker's depth, in metres.
  double normal = 0.;   //!< Root mean square of the angle between true and measured normal, in radians.
  double spin = 0.;     //!< Standard deviation of the turn about the normal, in radians; pi / sqrt(3) without a code.
};

/*!
  \struct vpPoseSeparation
  \ingroup group_circle_marker_simulator
  \brief How well an image tells a marker's pose from the mirrored one.
*/
struct vpPoseSeparation
{
  /*! sqrt(sum of (I - I2)^2) / noise, I2 being the image of the best mirrored pose; its square is also the mean of
     twice the log-odds ln(likelihood of the true pose / likelihood of the mirrored one). */
  double separation = 0.;
  double wrongChoice = 0.5;   //!< Probability that the mirrored pose fits better: Phi(-separation / 2).
  vpHomogeneousMatrix mirror; //!< Mirrored pose that fits best.
  /*! Whether the mirrored pose is a minimum of its own. If not (a marker so far away that both poses share one
      minimum), separation and mirror are those of the normal reflected about the line of sight. */
  bool isDistinct = true;
};

/*!
  \class vpMarkerPoseBound
  \ingroup group_circle_marker_simulator
  \brief The information limit: how well a pose can be known from one image of a marker, whatever the method.

  The image is that of vpMarkerSceneSimulator before noise, and depends on the pose (6 parameters, 5 without a code) and
  on three nuisances that are unknown as well: the levels of paper and ink and the variance of the Gaussian blur. With J
  the derivatives of the pixels' grey levels by all of these, and the noise independent in each pixel, the Fisher
  information is J^T W J, W = 1 / noise^2, and the bound is the pose's block of its inverse (S. Kay, Fundamentals of
  Statistical Signal Processing, vol. 1, 1993, section 3.7). The camera is known.

  Derivatives are central differences of the simulator's image. A step moves the marker's outer edge by 0.05 pixels at
  most (setStep()): for a blur of 0.7 pixels the third-order term is then 0.1 % of the derivative, the simulator's own
  error in an edge (1.4e-4 pixels at worst, of either sign) 0.3 % in a pixel and far less in a sum. Steps from 0.02 to
  0.1 pixels change the bounds by less than 0.5 % (1 % facing the camera). The image is rendered around the marker only.

  What surrounds the ring matters where the blur reaches across the quiet zone:
  - WHITE_SURROUND: white paper without end, and this is known. The most optimistic case, and free of arbitrary choices.
  - UNKNOWN_SURROUND: beyond the sheet may be anything. A pixel that sees a share s beyond the sheet has the additional
    standard deviation s * 74 grey levels (an evenly distributed grey level), independent of its neighbours'.
  The edge of the sheet itself is never used.
*/
class VISP_EXPORT vpMarkerPoseBound
{
public:
  /*! What is known of the scene around the marker. */
  enum Surround
  {
    WHITE_SURROUND,
    UNKNOWN_SURROUND
  };

  explicit vpMarkerPoseBound(const vpCameraParameters &cam, const vpScenePhotometry &photometry = vpScenePhotometry());

  void setSurround(Surround surround);
  void setStep(double step);

  vpPoseBound bound(const vpSimulatedMarker &marker) const;
  vpPoseSeparation separation(const vpSimulatedMarker &marker) const;

private:
  vpCameraParameters m_cam;             //!< Camera parameters.
  vpScenePhotometry m_photometry;       //!< Levels, blur and noise.
  Surround m_surround = WHITE_SURROUND; //!< What is known of the scene around the marker.
  double m_step = 0.05;                 //!< Greatest motion of the marker's edge for a difference, in pixels.
};

END_VISP_NAMESPACE

#endif
