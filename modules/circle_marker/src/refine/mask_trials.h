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
 * Masks of a camera that sharpens, as they were tried, and what lies between them.
 */

/*!
  \file mask_trials.h
  \brief Masks of a camera that sharpens, as they were tried, and what lies between them.

  Masks have two coordinates: their strength, which is what they add at one frequency, where masks that leave nearly the
  same image are alike; and the logarithm of their width in pixels.
*/

#ifndef VP_CIRCLE_MARKER_MASK_TRIALS_H
#define VP_CIRCLE_MARKER_MASK_TRIALS_H

#include <cmath>
#include <optional>

#include <Eigen/Core>

#include "refine/unsharp_mask.h"
#include "support/few.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! The coordinates of a mask: strength and ln of the width. */
Eigen::Vector2d placeOf(double amount, double sigma);

/*! And the mask, of no paper and ink. */
UnsharpMask maskOf(const Eigen::Vector2d &place);

/*! Strength of the largest amount at a width. */
double mostStrengthOf(double lnSigma);

/*! A mask that was tried. */
struct MaskTrial
{
  Eigen::Vector2d place;   //!< Its coordinates.
  double noise = HUGE_VAL; //!< What the marker's fit leaves, grey levels.
  double left = HUGE_VAL;  //!< That by the mask's gain, squared, grey levels^2: its likelihood.
  double pixels = 0.;      //!< That have noise of their own.
  std::optional<Eigen::Matrix<double, 6, 1>> pose{}; //!< From a pose before, (t, w); nothing: it is the other one.
};

/*! All that were tried, the first of them no mask, and what lies between them. */
class MaskTrials
{
public:
  /*! As many are tried at most. */
  static constexpr std::size_t most = 30;

  /*! Parabola through what the trials left, about the best one, in units() of the coordinates. */
  struct Surface
  {
    Eigen::Vector2d slope;
    Eigen::Matrix2d curvature;
  };

  /*! \return Whether it leaves less than all before; the first does not. */
  bool add(const MaskTrial &trial);

  std::size_t count() const { return m_trials.size(); }

  /*! What was tried at a place; nullptr if nothing was. */
  const MaskTrial *at(const Eigen::Vector2d &place) const;

  /*! Whether one was tried that is nearer than a share of a unit. */
  bool isNear(const Eigen::Vector2d &place, double share) const;

  const MaskTrial &none() const { return m_trials[0]; }

  const MaskTrial &best() const { return m_trials[m_best]; }

  /*! Steps of the coordinates about the best trial. */
  Eigen::Vector2d units() const;

  /*! Nothing if there are too few trials. */
  std::optional<Surface> surface() const;

  /*! Change of the pose, (t, w), by the coordinates in units(): a plane through the poses of the trials. */
  Eigen::Matrix<double, 6, 2> poseSlope() const;

private:
  Eigen::Vector2d offBest(const MaskTrial &trial) const;
  double weightOf(const MaskTrial &trial) const;

  Few<MaskTrial, most> m_trials;
  std::size_t m_best = 0;
};
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
