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
 * The two ends of one narrow thing.
 */

#ifndef VP_CIRCLE_MARKER_CAP_PAIRS_H
#define VP_CIRCLE_MARKER_CAP_PAIRS_H

#include <array>
#include <cstddef>
#include <vector>

#include "edges/edge_caps.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! The longest narrow thing that is put together from its ends, pixels. */
constexpr double longestNarrow = 420.;

/*! Where a cap is and what way it looks. Most pairs are refused by that alone, and there may be a hundred thousand. */
struct CapOutlook
{
  explicit CapOutlook(const EdgeCap &cap) : tip(cap.tip), axis(cap.axis), isDark(cap.isDark) {}

  Eigen::Vector2d tip;  //!< EdgeCap::tip.
  Eigen::Vector2d axis; //!< EdgeCap::axis.
  bool isDark;          //!< EdgeCap::isDark.
};

/*! Whether two caps, dark or bright both, look away from each other along the line from tip to tip, which is neither
  too long nor too short. */
bool lookApart(const CapOutlook &one, const CapOutlook &other);

/*! The outlooks of many caps, number by number: as many pairs as fit into a register are looked at together. */
class CapOutlooks
{
public:
  void clear();
  void add(const EdgeCap &cap);

  /*!
    Numbers of the caps of a run that look apart from one of them: see lookApart().
    \param one : Number of that cap.
    \param begin, end : Half-open range of the run.
    \param apart : The numbers, in their order.
  */
  void findApart(std::size_t one, std::size_t begin, std::size_t end, std::vector<std::size_t> &apart) const;

private:
  std::vector<double> m_tipU;
  std::vector<double> m_tipV;
  std::vector<double> m_axisU;
  std::vector<double> m_axisV;
  std::vector<double> m_side; // 1: dark, -1: bright
};

/*!
  Whether two caps may be the ends of one thing: dark or bright both, they look away from each other, together they are
  most of an outline, and their sides lie to either side of the line from tip to tip, not too far from it.
*/
bool mayBeEnds(const EdgeChains &chains, const EdgeCap &one, const EdgeCap &other);

/*! A half-open range of caps. */
struct CapRange
{
  std::size_t begin;
  std::size_t end;
};

/*! Sorts caps for candidatesFor(): by bands of rows, then from the left to the right. */
void sortCaps(std::vector<const EdgeCap *> &caps);

/*!
  The caps near enough to one of them to be the other end, of which those before it in the list are left out: all pairs
  of a large image would be too many.
*/
std::array<CapRange, 2> candidatesFor(const std::vector<const EdgeCap *> &caps, std::size_t i);

/*!
  The edge points of two ends, first those of the one and then those of the other, each as far as half the way to the
  other's tip.
*/
void locateEnds(const Gradient &gradient, const EdgeChains &chains, const EdgeCap &one, const EdgeCap &other,
                std::vector<EdgePoint> &points);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
