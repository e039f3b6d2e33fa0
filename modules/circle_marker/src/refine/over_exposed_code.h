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
 * A code that paper hides which is brighter than the sensor can tell.
 */

/*!
  \file over_exposed_code.h
  \brief What proves a code where paper is brighter than the sensor can tell.

  There a black sector that is no wider than the blur may be as bright as can be told, too, and the word that is read is
  another one: of 3000 golay23 of 12 to 45 pixels in light 2.5 times too strong five were read as others, with all
  sectors clear. So what a pixel shows is compared with the more of two: the black that a word gives it, and the least
  that the sensor can tell. Words that differ in what is hidden only are as likely as each other.
*/

#ifndef VP_CIRCLE_MARKER_OVER_EXPOSED_CODE_H
#define VP_CIRCLE_MARKER_OVER_EXPOSED_CODE_H

#include <cstdint>
#include <optional>

#include "refine/code_image.h"

#include <visp3/circle_marker/vpCircleMarkerFamily.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Odds, ln, of a codeword against all others of its code, and a white track, where the paper is over-exposed.
  \param view : The marker; its plane's x axis is the marker's own, with which the word begins.
  \param family : Family of the marker, with a code.
  \param word : The codeword.
  \param track : Working memory.
  \return Below 0 if another word is likelier; nothing if all sectors are longer than four standard deviations of the
  blur, if the sensor can tell how bright the paper is, to a tenth of the contrast (mostLikelyCode() compares codes
  then), or at the image's border.
*/
std::optional<double> oddsIfOverExposed(const MeasuredView &view, const vpCircleMarkerFamily &family,
                                        std::uint32_t word, CodeImage &track);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
