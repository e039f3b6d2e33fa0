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
 * Maximum-likelihood pose of a marker from the grey levels around its edges.
 */

/*!
  \file maximum_likelihood.h
  \brief Maximum-likelihood pose of a marker from the grey levels around its edges.

  The grey level of a pixel is modelled as
  \f[ I = L \, (1 - \kappa D), \quad L = l_0 + l_u u + l_v v, \f]
  with D the share of black (image_model.h), L the light on white paper, with a linear gradient, and \f$ \kappa \f$ the
  contrast of the ink. Pose, light, contrast, blur and a growth of black common to all edges, in the image (gamma) and
  on the print (ink), are fitted together by Levenberg-Marquardt; what the model does not explain, such as an occluder,
  gets no weight (Tukey's biweight). The noise is taken from the residuals, so that the covariance is right for any
  camera: \f$ \Sigma = s^2 (J^T W J)^{-1} \f$, its rows and columns of the pose.
*/

#ifndef VP_CIRCLE_MARKER_MAXIMUM_LIKELIHOOD_H
#define VP_CIRCLE_MARKER_MAXIMUM_LIKELIHOOD_H

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "refine/pixel_blocks.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! Working memory of fits, used again from one to the next. */
struct FitMemory
{
  PixelBlocks blocks;           //!< The pixels.
  std::vector<Lanes> residuals; //!< Of the present parameters, block by block, grey levels.
  std::vector<Lanes> trial;     //!< Of the last pass.
  std::vector<float> absolute;  //!< For the median.
};

/*! A fitted pose. */
struct FittedPose
{
  MarkerPlane plane;
  Photometry photometry;
  double squares = 0.;                    //!< Sum of squared residuals, robust, grey levels^2.
  double noise = 0.;                      //!< Standard deviation of the residuals that count, grey levels.
  double inliers = 0.;                    //!< Share of the pixels that count, in [0, 1].
  double correlation = 0.;                //!< Between model and image, in [-1, 1].
  Eigen::Matrix<double, 6, 6> covariance; //!< Of (t, w): see Darkness::byPose.
};

/*! What is fitted. */
struct FitSettings
{
  bool spinIsKnown = true; //!< Whether the code fixes the spin: else it stays as it is.
  bool growth = true;      //!< Whether black may be larger than designed.
  bool exactBends = true;  //!< Whether edges that bend strongly are corrected (correctBends()).
  int mostIterations = 25; //!< Levenberg-Marquardt steps; 0 only evaluates the start.
  //! A step is the last when what it leaves of the way is expected to be less than this share of a standard deviation.
  double convergence = 0.15;
};

/*! Where a fit starts. */
struct FitStart
{
  MarkerPlane plane;
  std::optional<Photometry> photometry; //!< Nothing: taken from the image, by linear least squares.
  std::optional<double> noise;          //!< Grey levels; nothing: taken from the residuals at the start.
};

/*!
  Refines a pose; nothing if the start explains nothing of the image or the equations are singular.
  \param pixels : What is to be explained.
  \param start : Where to start.
  \param pattern : The print.
  \param settings : What is fitted, and how closely.
  \param memory : Working memory.
*/
std::optional<FittedPose> fitPose(const std::vector<FitPixel> &pixels, const FitStart &start,
                                  const MarkerPattern &pattern, const FitSettings &settings, FitMemory &memory);

/*!
  Robust sum of squared residuals at a given noise, so that two fits can be compared. The surround is judged by the
  photometry \e surround, which is the same for all fits; strong bends are corrected as by FitSettings::exactBends.
*/
double robustSquares(const std::vector<FitPixel> &pixels, const FittedPose &fit, const MarkerPattern &pattern,
                     const Photometry &surround, double noise, bool exactBends, FitMemory &memory);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
