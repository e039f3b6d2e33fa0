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
 * Numbers for people.
 */

#ifndef VP_COMMON_NUMBERS_H
#define VP_COMMON_NUMBERS_H

#include <cstddef>
#include <string>

namespace common {
/*! Three digits as a rule, without an exponent: "0.012", "1.23", "12.3", "12345"; "-" for what is no number. */
std::string digits(double value);

/*! A share in per cent, with one digit after the point; "-" of nothing. */
std::string percent(std::size_t part, std::size_t whole);
} // namespace common

#endif
