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
 * A fitted pose, and what is fitted.
 */

#ifndef VP_CIRCLE_MARKER_FITTED_POSE_H
#define VP_CIRCLE_MARKER_FITTED_POSE_H

#include <optional>

#include <Eigen/Core>

#include "pose/marker_plane.h"
#include "decode/photometry.h"
#include "segment/image_noise.h"
#include "support/deadline.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! A fitted pose. */
struct FittedPose
{
  MarkerPlane plane;
  Photometry photometry;
  double squares = 0.;     //!< Sum of squared residuals, robust, grey levels^2.
  double scale = 0.;       //!< Standard deviation by which the residuals are weighed in that, grey levels.
  double noise = 0.;       //!< Standard deviation of the residuals that count, grey levels.
  double inliers = 0.;     //!< Share of the pixels that the model explains, in [0, 1]: Explanation.
  double correlation = 0.; //!< Between model and image, in [-1, 1].
  bool isSettled = false;  //!< Whether it has come to the end of its steps, not to the last allowed.
  double coherence = 1.;   //!< By how much parts of the print pull the pose apart more than noise does.
  //! Variance of the residuals at edges over that of all; the coherence is by how much more the parts pull than that.
  double edgeNoise = 1.;
  //! What light that bends over the marker would take off the squares, or more, grey levels^2:
  //! Likelihood::bendOfResiduals().
  double bendOfLight = 0.;
  double decrement = 0.; //!< What another step would take off the squares, grey levels^2.
  double sharing = 1.;   //!< Number of pixels that share what is left of them (ImageNoise), as far as that is noise.
  double resampled = 1.; //!< By how much less its tilt is known because the image was resampled (ImageNoise).
  //! Information on the lean that its square gives, by that square, 1/rad^4; nothing unless the marker nearly faces the
  //! camera (nearly_frontal.h).
  std::optional<double> leanInformation;
  //! Of (t, w) in the camera frame, about the marker's centre, metres and radians.
  Eigen::Matrix<double, 6, 6> covariance = Eigen::Matrix<double, 6, 6>::Zero();
};

/*! A fit on the same pixels that another one is to be better than. */
struct Rival
{
  double squares = 0.; //!< See FittedPose.
  double scale = 0.;   //!< See FittedPose.
  double odds = 0.;    //!< Who is worse than it by these log-odds, and does not catch up, is given up.
};

/*! What is fitted. */
struct FitSettings
{
  bool spinIsKnown = true; //!< Whether the code fixes the spin: else it stays as it is.
  std::optional<Shadow>
      shadow;                 //!< Where a fit without photometry starts with the shadow on the marker, if there is one.
  bool gammaAndSpread = true; //!< Whether gamma and the ink's spread, which make black look larger, are fitted.
  bool bend = false;          //!< Whether the sheet may be bent.
  bool exactBends = true;     //!< Whether edges that bend strongly are corrected (correctBends()).
  double poseError = 1.;      //!< How far a fit may go until its pixels are sorted anew, pixels.
  int bordersSeen = 5;        //!< Borders between sectors that a pixel may see at most: 1, 3 or 5.
  int mostIterations = 25;    //!< Levenberg-Marquardt steps; 0 only evaluates the start.
  //! A step is the last when what it leaves of the way is expected to be less than this share of a standard deviation.
  double convergence = 0.15;
  std::optional<Rival> rival; //!< Who a fit has to be better than to go on.
  Deadline deadline;          //!< When to stop, with nothing.
  //! Whether the marker is not small and was read for certain, so that starts are near: fits take shorter ways then.
  bool isClear = false;
  ImageNoise noise;        //!< Of the image.
  bool samePixels = false; //!< Whether pixels and print are those of the fit before: what is sorted may serve again.
};

/*! Where a fit starts. */
struct FitStart
{
  MarkerPlane plane;
  std::optional<Photometry> photometry; //!< Nothing: taken from the image, by linear least squares.
  std::optional<double> noise;          //!< Grey levels; nothing: taken from the residuals at the start.
};
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
