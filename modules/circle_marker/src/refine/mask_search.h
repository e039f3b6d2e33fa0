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
 * The mask of a camera that sharpens, by how well it explains a whole marker.
 */

/*!
  \file mask_search.h
  \brief The unsharp mask behind which a marker is explained best.
*/

#ifndef VP_CIRCLE_MARKER_MASK_SEARCH_H
#define VP_CIRCLE_MARKER_MASK_SEARCH_H

#include <functional>
#include <optional>

#include <Eigen/Core>

#include "refine/fitted_pose.h"
#include "refine/mask_trials.h"
#include "refine/unsharp_mask.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! A mask, and how well a marker's pose is known behind it. */
struct SearchedMask
{
  /*!
    Covariance of a pose of the marker by what is not known of the mask: of (t, w) in the camera frame, as FittedPose's.
    \param plane : The pose, in any unit of length: one of both that the marker may have.
  */
  Eigen::Matrix<double, 6, 6> doubtOf(const MarkerPlane &plane) const;

  UnsharpMask mask;
  double gain = 0.; //!< Of log-likelihood, against the image as it is.
  MarkerPlane pose; //!< The marker's pose from which masks were searched,
  Eigen::Matrix<double, 6, 6> doubt = Eigen::Matrix<double, 6, 6>::Zero(); //!< and its doubtOf().
};

/*! A marker behind a mask. */
struct FitBehind
{
  FittedPose fit;
  std::size_t pixels = 0; //!< Number of pixels that it was fitted to.
};

/*!
  The maximum-likelihood estimate of a mask. An image y that was sharpened by a mask M from what a marker and white
  noise of standard deviation sigma make has the negative log-likelihood N (ln sigma + ln |M|), where ln |M| is the mean
  of the logarithm of the mask's gain over all frequencies, and sigma is what the marker leaves of the N pixels once the
  mask is undone. Its minimum is looked for by the parabola through what was measured behind other masks; and its
  curvature, with the change of the pose from mask to mask, tells how well the pose is known though the mask is not.
*/
class MaskSearch
{
public:
  /*!
    Measures the marker in the image before a mask, or finds that it is none there. The second argument is where it was
    measured behind the best mask so far, nullptr if nowhere.
  */
  using MeasureBehind = std::function<std::optional<FitBehind>(const UnsharpMask &, const FittedPose *)>;

  /*! What is known before. */
  enum class Known
  {
    NOTHING, //!< The marker is like none in the image as it is.
    POSE,    //!< It was measured.
    HALO     //!< And a halo is seen beside it.
  };

  /*!
    \param start : The marker as it was measured, or, where it was like none, only its pose, paper and ink.
    \param known : Which of both, and whether a halo is seen.
    \param noise : Standard deviation of the image's noise, grey levels.
    \param measureBehind : Measures it behind a mask.
  */
  MaskSearch(const FittedPose &start, Known known, double noise, MeasureBehind measureBehind);

  /*!
    Looks for the mask.
    \return Nothing if no mask explains the image better than none.
  */
  std::optional<SearchedMask> run();

private:
  UnsharpMask maskAt(const Eigen::Vector2d &place) const;
  double leftAt(const Eigen::Vector2d &place);
  std::optional<FitBehind> measureBehind(const UnsharpMask &mask) const;
  double tryAt(const Eigen::Vector2d &place);
  void searchFrom(const UnsharpMask &start);
  bool isLikelierBehindAny();
  double leftByTone() const;
  bool isExplained() const;
  bool isBetterThanNone() const;
  bool isOver() const;
  bool searchStrength(const Eigen::Vector2d &start);
  void searchWidth();
  void searchBoth();
  SearchedMask result() const;

  MarkerPlane m_start;
  Known m_known;
  double m_noise;
  MeasureBehind m_measureBehind;
  MaskTrials m_trials;
  std::optional<FittedPose> m_nearest; // where the marker was measured in the best of them
  std::optional<FittedPose> m_toned;   // the start, if it has a tone curve
  double m_white;                      // grey level of paper beside the marker,
  double m_ink;                        // and of its ink
};
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
