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
 * Codewords compared by what they leave of a blurred image.
 */

/*!
  \file blurred_words.h
  \brief Codewords compared by what they leave of a blurred image.
*/

#ifndef VP_CIRCLE_MARKER_BLURRED_WORDS_H
#define VP_CIRCLE_MARKER_BLURRED_WORDS_H

#include <cmath>

#include "decode/blurred_marker.h"
#include "decode/cyclic_code.h"
#include "support/deadline.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! The codeword that explains an image best. */
struct BestWords
{
  CyclicCode::Word best = 0;
  double squares = HUGE_VAL; //!< Residuals that it leaves, grey levels^2.
  double next = HUGE_VAL;    //!< Those that the next one leaves.
};

/*!
  Compares all codewords by what they leave unexplained, each with its own light and contrast.
  \param fit : The equations of sectors of any grey, at the pose and blur that explain the image best with them.
  \param code : The code.
  \param deadline : When to stop: those are told then that are the best so far.
*/
BestWords bestWords(const BlurredFit &fit, const CyclicCode &code, const Deadline &deadline);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
