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
 * Outlines found so far, each of them once.
 */

#ifndef VP_CIRCLE_MARKER_KNOWN_OUTLINES_H
#define VP_CIRCLE_MARKER_KNOWN_OUTLINES_H

#include <cstddef>
#include <vector>

#include "ellipse/ellipse_candidate.h"
#include "support/cell_index.h"
#include "support/reused_list.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! Whether two ellipses that were found in the same way are one outline, to a tenth of their size and a pixel. */
bool isSameOutline(const EllipseParameters &p, const EllipseParameters &q);

/*! Outlines without two of the same, found by place. */
class KnownOutlines
{
public:
  /*! Forgets all; the memory is kept. */
  void reset(int width, int height);

  /*!
    Keeps an outline, whose memory is swapped in, or drops it: of two that are the same the better supported stays,
    and one that was found by its edge before one that was found as a thin ring.
    \return Whether it was new; if not, \e candidate is what was dropped.
  */
  bool take(EllipseCandidate &candidate);

  /*! Whether an outline of these axes is known; isThin: whether they were found as thin rings. */
  bool hasSame(const EllipseParameters &ellipse, bool isThin = false) const { return find(ellipse, isThin) >= 0; }

  /*!
    Whether most of the points lie on an outline that is known.
    \param points, count : Points.
    \param scale, shift : Where they are, in pixels of the known outlines: scale * position + shift.
    \param leastSupport : Share of the outline that must be found for it to count.
  */
  bool holds(const EdgePoint *points, std::size_t count, double scale = 1., double shift = 0.,
             double leastSupport = 0.) const;

  /*!
    The largest of the outlines along which most of the points of one of them lie, and of which a greater share is
    found; or that are well found by their edge, where it is a thin ring.
    \return Nothing if there is none.
  */
  const EllipseCandidate *betterAlong(const EllipseCandidate &outline) const;

  /*! Whether a point is inside of an outline of which this share at least is found, leaving out the first ones. */
  bool surrounds(const Eigen::Vector2d &point, double leastSupport, std::size_t first = 0) const;

  ReusedList<EllipseCandidate> outlines; //!< All of them. Sorting them is the end of this index.

private:
  int find(const EllipseParameters &ellipse, bool isThin) const;
  template <typename IsOn>
  bool anyAlong(const EdgePoint *points, std::size_t count, double scale, double shift, const IsOn &isOn) const;
  double shareOn(const EllipseCandidate &known, const EdgePoint *points, std::size_t count, std::size_t stride,
                 double scale, double shift) const;

  CellIndex m_centers;      //!< Outlines by their centres.
  CellIndex m_points;       //!< Outlines by the points along them.
  std::vector<int> m_large; //!< Outlines that may be the same though their centres are cells apart.
};
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
