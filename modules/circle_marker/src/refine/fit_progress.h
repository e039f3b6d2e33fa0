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
 * How a fit goes on: what it takes for noise, which matrix it works with, and whether a rival has won.
 */

/*!
  \file fit_progress.h
  \brief How a fit goes on: what it takes for noise, which matrix it works with, and whether a rival has won.
*/

#ifndef VP_CIRCLE_MARKER_FIT_PROGRESS_H
#define VP_CIRCLE_MARKER_FIT_PROGRESS_H

#include <cmath>
#include <optional>

#include "refine/likelihood.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
/*!
  The noise comes down from what the edges' residuals are at the start to that of a right fit, so that they are not
  taken for outliers while they are needed.
*/
class NoiseDescent
{
public:
  /*!
    \param isKnown : Whether it is down from the start.
    \param isQuick : Whether it comes down in fewer steps, where the start is near.
  */
  explicit NoiseDescent(bool isKnown, bool isQuick = false);

  /*! Whether the noise is no more than that of the residuals. */
  bool isDown() const { return m_excess == 0.; }

  /*! Whether it stays what it is. */
  bool isOver() const { return m_updates == 0; }

  /*! The noise after a step, grey levels. */
  double next(Likelihood &fit);

private:
  double m_excess;      //!< Share of the wide residuals that the noise is held at.
  double m_leastExcess; //!< Where that ends.
  int m_updates;        //!< Left.
};

/*! Where the matrix of the equations was formed, and whether it serves at other parameters. */
class MatrixPlace
{
public:
  void set(const MarkerPlane &plane, const Photometry &photometry);

  /*!
    Whether it serves at other parameters.
    \param plane, photometry : These.
    \param size : Of the step that leads there, standard deviations.
    \param unit : Size of a pixel, normalised coordinates.
  */
  bool servesAt(const MarkerPlane &plane, const Photometry &photometry, double size, double unit);

private:
  MarkerPlane m_plane;
  Photometry m_photometry;
  double m_lastSize = HUGE_VAL; //!< Of the step before, standard deviations.
};

/*! A fit against a rival that is better already. */
class Race
{
public:
  explicit Race(const std::optional<Rival> &rival) : m_rival(rival) {}

  /*! Whether the fit stays far behind, by the residuals kept after a step. */
  bool isLost(const Likelihood &fit, const MarkerPlane &plane, const Photometry &photometry);

private:
  const std::optional<Rival> m_rival;
  double m_behind = HUGE_VAL; //!< After the step before, grey levels^2.
};
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
