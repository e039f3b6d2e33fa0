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
 * The ink on which most directions from the centre of a covered marker agree.
 */

#ifndef VP_CIRCLE_MARKER_USUAL_INK_H
#define VP_CIRCLE_MARKER_USUAL_INK_H

#include <algorithm>
#include <cstddef>

#include <visp3/circle_marker/vpConfigCircleMarker.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! Share of the light that the ink takes away, at least: contrast of 25 grey levels on paper of 130 leaves 0.19. */
constexpr double leastInk = 0.1;

/*! Where blur leaves less than this share of a step, noise is not enlarged to tell it. */
constexpr double leastExpected = 0.15;

/*! The ink of a marker, as share of the light that it takes away, and how many directions agree on it. */
struct UsualInk
{
  double ink = 0.;
  std::size_t agreeing = 0;
};

/*!
  Of the inks that directions show, some of which see something else, the most that are alike: the middle one.
  \param inks : They are sorted.
  \param count : Their number.
*/
inline UsualInk usualInk(double *inks, std::size_t count)
{
  // The ink of one marker differs from direction to direction by this ratio, through noise and an outline that is off.
  constexpr double sameInk = 1.5;
  std::sort(inks, inks + count);
  UsualInk usual;
  std::size_t end = 0;
  for (std::size_t begin = 0; begin < count; ++begin) {
    while (end < count && inks[end] <= sameInk * inks[begin]) {
      ++end;
    }
    if (end - begin > usual.agreeing) {
      usual = {inks[(begin + end) / 2], end - begin};
    }
  }
  return usual;
}
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
