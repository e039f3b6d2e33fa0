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

#ifndef VP_CIRCLE_MARKER_LIKELIHOOD_H
#define VP_CIRCLE_MARKER_LIKELIHOOD_H

#include <vector>

#include "refine/maximum_likelihood.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
// Places of the parameters in vectors and matrices: pose (t, w), light and its gradient, contrast, blur, growth.
constexpr int poseSize = 6;
constexpr int lightAt = 6;
constexpr int gradientAt = 7;
constexpr int contrastAt = 9;
constexpr int sigmaAt = 10;
constexpr int growthAt = 11;
constexpr int parameters = 12;
using ParameterVector = Eigen::Matrix<double, parameters, 1>;
using ParameterMatrix = Eigen::Matrix<double, parameters, parameters>;

/*! Noise of rounding to whole grey levels: no picture has less. */
constexpr double quantisation = 0.2887;

/*! Normal equations of one pass over the pixels. */
struct Equations
{
  ParameterMatrix matrix = ParameterMatrix::Zero();
  ParameterVector right = ParameterVector::Zero();
  double cost = 0.;    //!< Robust sum of squares, grey levels^2.
  double squares = 0.; //!< Weighted sum of squared residuals, grey levels^2.
  double weight = 0.;  //!< Sum of the weights.
};

/*! Measured less modelled grey level of a pixel. */
double residualOf(const FitPixel &pixel, const Photometry &photometry, double darkness);

/*!
  Share of a pixel's information that the unknown surround leaves: what lies beyond the quiet zone differs from white by
  up to half the light, in either direction.
*/
double shareOfKnown(const FitPixel &pixel, const Photometry &photometry, double noise);

/*! Tukey's biweight loss of a residual, and the weight with which it enters the normal equations. */
struct Loss
{
  double cost;
  double weight;
};

/*! Tukey's biweight at 4.685 standard deviations (95 % efficiency with normal noise). */
Loss biweight(double residual, double noise);

/*! The robust likelihood of the pixels of a marker as a function of pose, light, contrast and blur. */
class Likelihood
{
public:
  Likelihood(const std::vector<FitPixel> &pixels, const MarkerPattern &pattern, const FitSettings &settings);

  /*! Light and contrast that explain the image best at a pose, by linear least squares; false if there is no print. */
  bool startPhotometry(const MarkerPlane &plane, Photometry &photometry) const;

  /*! One pass over the pixels. */
  Equations linearise(const MarkerPlane &plane, const Photometry &photometry, double noise);

  /*! The residuals of the last pass are those of the present parameters. */
  void keepResiduals() { m_residuals.swap(m_trial); }

  /*! Noise at the start, where nothing is known of it, grey levels. */
  double noiseAt(const MarkerPlane &plane, const Photometry &photometry);

  /*! Noise from the median of the residuals kept that see no surround, grey levels. */
  double noiseOfResiduals();

  /*! Cost of the residuals kept at another noise. */
  double costOfResiduals(const Photometry &photometry, double noise) const;

  /*! Correlation between model and image over the pixels, each with its weight. */
  double correlation(const Photometry &photometry, double noise) const;

  /*! Share of the pixels that the model explains. */
  double inliers(double noise) const;

private:
  double priorCost(const Photometry &photometry, double noise) const;
  void constrain(const MarkerPlane &plane, const Photometry &photometry, double noise, Equations &equations) const;

  const std::vector<FitPixel> &m_pixels; //!< What is explained.
  const MarkerPattern &m_pattern;        //!< By this print.
  FitSettings m_settings;                //!< What is fitted.
  std::vector<double> m_residuals;       //!< Of the present parameters, grey levels.
  std::vector<double> m_trial;           //!< Of the last pass.
  std::vector<double> m_absolute;        //!< Working memory of the median.
};
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
