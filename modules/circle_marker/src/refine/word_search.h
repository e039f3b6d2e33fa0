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
 * The codewords of a cyclic code that leave the least of a code track.
 */

#ifndef VP_CIRCLE_MARKER_WORD_SEARCH_H
#define VP_CIRCLE_MARKER_WORD_SEARCH_H

#include <array>
#include <cmath>

#include "decode/cyclic_code.h"
#include "refine/code_image.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! A codeword and the squared residuals that it leaves. */
struct CostedWord
{
  CyclicCode::Word word = 0;
  double squares = HUGE_VAL; //!< This where there is no such word.
};

/*!
  The two codewords that leave the least squared residuals, the best first; the zero word, a white track, is one of
  them.

  The words are the leaves of a tree in which four sectors at a time are fixed, as the generator polynomial fixes a
  word's highest bits by the message's. A branch is left when what its fixed sectors cost, and the rest at least, is
  more than the second best word (A. Land, A. Doig, An automatic method of solving discrete programming problems,
  Econometrica 28 (1960)). The least of the rest is that of all words of the same bits whose neighbouring groups of
  four fit together, codewords or not. The same words come out as if all had been tried, up to ties.

  \param squares : Of the track; no entry of its matrix is negative but for rounding: a pixel sees no less than nothing.
  \param code : The code.
  \param limit : Squared residuals from which a word is of no interest; without two that leave less, some are missing.
*/
std::array<CostedWord, 2> bestTwoWords(const Squares &squares, const CyclicCode &code, double limit = HUGE_VAL);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
