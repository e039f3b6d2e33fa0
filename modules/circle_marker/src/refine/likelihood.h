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
 * Likelihood of the grey levels around a marker, and its normal equations.
 */

/*!
  \file likelihood.h
  \brief Likelihood of the grey levels around a marker, and its normal equations.

  A pixel's deviation from the model is noise of standard deviation s and, near the end of the quiet zone, what the
  surround may change (PixelBlock::variance). Deviations are weighed by Tukey's biweight, so that what covers the marker
  counts nothing.
*/

#ifndef VP_CIRCLE_MARKER_LIKELIHOOD_H
#define VP_CIRCLE_MARKER_LIKELIHOOD_H

#include <vector>

#include "refine/fit_step.h"
#include "refine/image_model.h"
#include "refine/maximum_likelihood.h"
#include "support/sensor_range.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
/*! Normal equations of one pass over the pixels. */
struct Equations
{
  ParameterMatrix matrix = ParameterMatrix::Zero();
  ParameterVector right = ParameterVector::Zero();
  UsedParameters used; //!< The others' rows and columns have a prior at most.
  double cost = 0.;    //!< Robust sum of squares, grey levels^2.
  //! Weighted sum of squared residuals, grey levels^2, and number of pixels, each as far as it is not taken for an
  //! outlier; of pixels that tell the noise: what the surround may add is not known well enough.
  double squares = 0.;
  double kept = 0.;
  //! Of the same pixels, each with its weight: sum of the squared slopes of the image, which say how much a pixel tells
  //! of the pose, sum of their squares, and sum of the squared residuals, once more with their weights, times these.
  double steepness = 0.;
  double squaredSteepness = 0.;
  double steepSquares = 0.;
};

/*! Standard deviations that normal noise with the same quantiles would have, grey levels. */
struct ResidualSpread
{
  double median = 0.; //!< Of the median: right when the fit is, even with half of the marker covered.
  double wide = 0.;   //!< Of the 80 % quantile: before the fit is right the edges' large residuals show in this one.
  double steep = 0.;  //!< Of the median where pixels count by the squared slope of the image: of the edges alone.
};

/*! How well a model explains the image. */
struct Explanation
{
  double correlation = 0.; //!< Between model and image, each pixel with its weight, in [-1, 1].
  double inliers = 0.;     //!< Share of the pixels that the model explains, in [0, 1].
};

/*! How far a pull of each parameter that is used moves the pose, when all others follow: the pose's rows of the
    inverse of the equations' matrix. */
using PoseInfluence = Eigen::Matrix<double, poseSize, Eigen::Dynamic, 0, poseSize, parameters>;

/*! Covariance of the pose by what neighbouring pixels pull together: Likelihood::coherentCovariance(). */
struct CoherentCovariance
{
  Eigen::Matrix<double, poseSize, poseSize> covariance; //!< If the noise had variance 1.
  double ratio = 1.; //!< To that of independent pixels, mean over the pose's parameters; 1 if that is within chance.
};

/*! The robust likelihood of the pixels of a marker as a function of pose, light, contrast and blur. */
class Likelihood
{
public:
  Likelihood(const MarkerPattern &pattern, const FitSettings &settings, FitMemory &memory);

  /*! Takes the pixels to be explained; plane, photometry and noise are known roughly (noise 0: not at all). */
  void setPixels(const std::vector<FitPixel> &pixels, const MarkerPlane &plane, const Photometry &photometry,
                 double noise);

  /*!
    Takes the pixels that the memory has as they are sorted, if that serves at another pose; only the surround is judged
    again. If not, they have to be set again.
    \param pixels : The pixels, those that the memory has.
    \param plane, photometry : Pose, light and blur, known roughly.
    \param noise : Standard deviation, grey levels.
    \param room : How far a fit may go from there, pixels.
  */
  bool keepPixels(const std::vector<FitPixel> &pixels, const MarkerPlane &plane, const Photometry &photometry,
                  double noise, double room);

  /*! Corrects the model where edges bend strongly, if the settings want it; whether there are such edges. */
  bool correct(const MarkerPlane &plane, const Photometry &photometry);

  /*! Light and contrast that explain the image best at a pose, by linear least squares; false if there is no print. */
  bool startPhotometry(const MarkerPlane &plane, Photometry &photometry) const;

  /*! One pass over the pixels. */
  Equations linearise(const MarkerPlane &plane, const Photometry &photometry, double noise);

  /*! The same with the matrix of the last pass of linearise() that was kept: the parameters are near those. */
  Equations pull(const MarkerPlane &plane, const Photometry &photometry, double noise);

  /*! Their cost alone. */
  double cost(const MarkerPlane &plane, const Photometry &photometry, double noise) const;

  /*! The residuals and sums of the last pass are those of the present parameters. */
  void keepResiduals();

  /*!
    Covariance of the pose if the noise had variance 1, by what neighbouring pixels pull together: that of the normal
    equations, unless the sandwich covariance (White, Econometrica 48, 1980), with the pixels of a direction from the
    centre taken together, is larger by more than chance. Then it is wider by the mean over the pose's parameters of the
    ratio of both, and in the directions in which the sandwich is wider than that, by as much as that is: the print is
    bent, moved or lit in a way that the model does not know.
    \param influence : By the equations kept.
    \param step : Last step from where these were made, of the parameters that are used.
    \param noise : Grey levels.
  */
  CoherentCovariance coherentCovariance(const PoseInfluence &influence, const UsedVector &step, double noise) const;

  /*! The residuals at a pose, without equations. */
  void evaluate(const MarkerPlane &plane, const Photometry &photometry);

  /*! Spread of the residuals kept that see no surround; HUGE_VAL if there are none. */
  ResidualSpread spreadOfResiduals();

  /*! How much the share of the surround differs from direction to direction, by the residuals kept. */
  double unevenShareOfResiduals(double noise) const;

  /*!
    What light that bends over the marker would take off the squares of the residuals kept, grey levels^2, if light and
    ink alone followed it: to first order no more than it really would, where pose and blur follow as well.
    \param photometry : The light by which they are left.
    \param noise : By which the pixels are weighed, grey levels.
  */
  double bendOfResiduals(const Photometry &photometry, double noise) const;

  /*! Cost of the residuals kept at a noise. */
  double costOfResiduals(const MarkerPlane &plane, const Photometry &photometry, double noise) const;

  /*!
    How well the residuals kept leave the image explained.
    \param noise : By which the pixels are weighed, grey levels.
    \param lacking : Standard deviation of what the model may lack without leaving anything out, grey levels.
  */
  Explanation explain(double noise, double lacking) const;

private:
  Equations pass(const MarkerPlane &plane, const Photometry &photometry, double noise, bool formsProducts);
  UsedParameters usedBy(const Photometry &photometry) const;
  double spreadPriorOf(const MarkerPlane &plane, const Photometry &photometry) const;
  double priorCost(const MarkerPlane &plane, const Photometry &photometry, double noise) const;
  void constrain(const MarkerPlane &plane, const Photometry &photometry, double noise, Equations &equations) const;

  const MarkerPattern &m_pattern; //!< The print that explains the pixels.
  FitSettings m_settings;         //!< What is fitted.
  FitMemory &m_memory;            //!< The pixels and their residuals.
  ParameterMatrix m_matrix;       //!< Of the last pass of linearise() that was kept, without the priors.
  ParameterMatrix m_trialMatrix;  //!< And of the last one.
  bool m_trialHasProducts = false;
  bool m_isOverExposed = false; //!< Whether gamma is held, because the paper is brighter than the sensor can tell.
};
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
