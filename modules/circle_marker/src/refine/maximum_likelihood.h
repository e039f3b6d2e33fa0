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
  \f[ I = l \, (s \, (1 - a D))^\gamma, \quad s = 1 + s_u u + s_v v, \f]
  with D the share of black (image_model.h), l the grey level of white paper at the marker's centre, s the light, with
  a linear gradient, a the share of it that ink takes and \f$ \gamma \f$ the camera's gamma; where the edge of a
  shadow falls on the marker, s falls along it, and where a lens darkens the corners it has terms of the second order.
  Where a marker leaves more than noise the camera's tone curve may be more than a power, as most cameras raise the
  contrast and bend it where it is brightest: between ink and paper \f[ (1 - a D)^\gamma \to p + \kappa (1 - b) w (1 -
  w) (1 - 2 w), \quad p = (1 - a D)^\gamma, \quad b = (1 - a)^\gamma, \quad w = (p - b) / (1 - b), \f] the first curve
  beyond gamma's that keeps ink and paper as they are. Pose, light, ink, gamma, blur, a spread of the ink common to
  all edges and, where it is asked for, the bend of the sheet are fitted together by Levenberg-Marquardt; what the
  model does not explain, such as an occluder, gets no weight (Tukey's biweight). Near the end of the paper a pixel
  sees a share of what lies beyond, too: that share moves with the pose, and how the paper is cut is fitted
  (surround_model.h). The noise is taken from the residuals, so that the covariance is right for any camera: \f$
  \Sigma = s^2 (J^T W J)^{-1} \f$, its rows and columns of the pose, times what fit_conclusion.h knows of pixels that
  share their noise, of edges that are noisier than paper and of parts of the print that pull the pose apart.
*/

#ifndef VP_CIRCLE_MARKER_MAXIMUM_LIKELIHOOD_H
#define VP_CIRCLE_MARKER_MAXIMUM_LIKELIHOOD_H

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "refine/fitted_pose.h"
#include "refine/pixel_blocks.h"
#include "refine/shadow_split.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
// Places of the parameters in vectors and matrices: twist of the pose (image_model.h), light and its gradient,
// the ink's absorption, blur, its elongation, gamma, spread, share of the surround for each shape of the paper, how
// the paper is cut, bend of the sheet, a shadow's factor, direction, edge and softness, tone curve, curvature of the
// light.
constexpr int poseSize = 6;
constexpr int spinAt = 5;
constexpr int lightAt = 6;
constexpr int gradientAt = 7;
constexpr int absorptionAt = 9;
constexpr int sigmaAt = 10;
constexpr int elongationAt = 11;
constexpr int gammaAt = 13; // its logarithm
constexpr int spreadAt = 14;
constexpr int surroundAt = 15;
constexpr int paperAt = surroundAt + static_cast<int>(paperShapes);
constexpr int paperSize = 4; // PaperPlacement: shift, turn, growth
constexpr int bendAt = paperAt + paperSize;
constexpr int bendSize = 3;
constexpr int shadowAt = bendAt + bendSize;
constexpr int shadowSize = 4;
constexpr int toneAt = shadowAt + shadowSize;
constexpr int curvatureAt = toneAt + 1;
constexpr int curvatureSize = 3;
constexpr int parameters = curvatureAt + curvatureSize;
using ParameterVector = Eigen::Matrix<double, parameters, 1>;
using ParameterMatrix = Eigen::Matrix<double, parameters, parameters>;

/*! The parameters that any pixel depends on: the others are not worked on. */
class UsedParameters
{
public:
  /*! Adds some that follow one another, after all that were added before. */
  void add(int first, int size)
  {
    for (int k = 0; k < size; ++k) {
      m_at[m_count++] = static_cast<std::size_t>(first + k);
    }
  }

  std::size_t count() const { return m_count; }

  /*! Where the k-th of them is among all. */
  std::size_t operator[](std::size_t k) const { return m_at[k]; }

  /*! The same in vectors and matrices. */
  Eigen::Index at(Eigen::Index k) const { return static_cast<Eigen::Index>(m_at[static_cast<std::size_t>(k)]); }

  /*! Whether they are the first ones. */
  bool areFirst() const { return m_count == 0 || m_at[m_count - 1] + 1 == m_count; }

private:
  std::array<std::size_t, parameters> m_at = {};
  std::size_t m_count = 0;
};

// Sums over the pixels of a direction, in whole blocks of lanes: the lower triangle of the equations' matrix, row by
// row; and their right-hand side, the cost and what it takes to know the noise, everywhere and at edges.
constexpr std::size_t wholeBlocks(std::size_t numbers)
{
  return (numbers + laneCount - 1) / laneCount * laneCount;
}
using ProductSums = std::array<double, wholeBlocks(parameters *(parameters + 1) / 2)>;
using PullSums = std::array<double, wholeBlocks(parameters + 6)>;

/*! Sums of a pass over the pixels, direction by direction. */
struct PassSums
{
  std::vector<ProductSums> products;
  std::vector<PullSums> pulls;
};

/*! Working memory of fits, used again from one to the next. */
struct FitMemory
{
  PixelBlocks blocks;           //!< The pixels.
  std::vector<Lanes> residuals; //!< Of the present parameters, block by block, grey levels.
  std::vector<Lanes> trial;     //!< Of the last pass.
  std::vector<Lanes> steepness; //!< Squared slope of the image at each pixel; empty: not known.
  std::vector<Lanes> trialSteepness;
  std::vector<Lanes> sizes; //!< Of the residuals, for their quantiles.
  PassSums sums;            //!< Of the present parameters.
  PassSums trialSums;       //!< Of the last pass.
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
  Robust sum of squared residuals at a given noise, so that two fits can be compared. The pixels must be those of the
  last fit: as they are sorted in the memory they may serve. The surround is judged by the
  photometry \e surround, which is the same for all fits; strong bends are corrected as by FitSettings::exactBends.
*/
double robustSquares(const std::vector<FitPixel> &pixels, const FittedPose &fit, const MarkerPattern &pattern,
                     const Photometry &surround, double noise, bool exactBends, FitMemory &memory);

/*!
  The pixels, in any order, as a fit explains them. They must be those of the last fit, as for robustSquares().
  \param pixels : The pixels.
  \param fit : The fit.
  \param pattern : The print.
  \param memory : Working memory.
  \param explained : The result; its memory is used again.
*/
void explainPixels(const std::vector<FitPixel> &pixels, const FittedPose &fit, const MarkerPattern &pattern,
                   FitMemory &memory, std::vector<ExplainedPixel> &explained);
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
