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
 * Sectors of a cyclic codeword with those beside them.
 */

#ifndef VP_CIRCLE_MARKER_EXTENDED_WORD_H
#define VP_CIRCLE_MARKER_EXTENDED_WORD_H

#include <cstdint>

#include "decode/cyclic_code.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! A word with its last two sectors before the first and its first two after the last. */
inline std::uint64_t extended(CyclicCode::Word word, unsigned int sectors)
{
  return (std::uint64_t(word) << 2) | (word >> (sectors - 2)) | (std::uint64_t(word & 3U) << (sectors + 2));
}

/*! Of such a word the sector after one, that and the one before: bits 0 to 2. */
inline unsigned int coloursAt(std::uint64_t extendedWord, unsigned int sector, unsigned int sectors)
{
  return (extendedWord >> (sectors - sector)) & 7U;
}
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
