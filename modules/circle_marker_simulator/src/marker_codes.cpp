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
 * Codewords of the circular families, recomputed from the generator polynomials.
 */

#include <algorithm>

#include <visp3/core/vpException.h>

#include "marker_codes.h"

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

namespace {

std::uint32_t rotate(std::uint32_t word, unsigned int length)
{
  const std::uint32_t all = (std::uint32_t(1) << length) - 1;
  return ((word << 1) | (word >> (length - 1))) & all;
}

bool isSmallestRotation(std::uint32_t word, unsigned int length)
{
  std::uint32_t rotated = word;
  for (unsigned int i = 1; i < length; ++i) {
    rotated = rotate(rotated, length);
    if (rotated <= word) {
      return false; // equal: an orbit shorter than the length, a constant word, which would leave the spin open
    }
  }
  return true;
}

// Product of two polynomials over the field of two elements.
std::uint32_t multiply(std::uint32_t a, std::uint32_t b)
{
  std::uint32_t product = 0;
  for (; b != 0; b >>= 1, a <<= 1) {
    if (b & 1) {
      product ^= a;
    }
  }
  return product;
}

std::vector<std::uint32_t> enumerate(const CyclicCode &code)
{
  std::vector<std::uint32_t> representatives;
  for (std::uint32_t message = 1; message < (std::uint32_t(1) << code.dimension); ++message) {
    const std::uint32_t word = multiply(code.generator, message);
    if (isSmallestRotation(word, code.length)) {
      representatives.push_back(word);
    }
  }
  std::sort(representatives.begin(), representatives.end());
  return representatives;
}

} // namespace

std::optional<CyclicCode> codeOf(const std::string &family)
{
  if (family == "golay23") {
    return CyclicCode{23, 12, 0xAE3}; // x^11 + x^9 + x^7 + x^6 + x^5 + x + 1
  }
  if (family == "bch31") {
    return CyclicCode{31, 16, 0x8FAF}; // minimal polynomials of a, a^3, a^5 over x^5 + x^2 + 1
  }
  if (family == "bch31r") {
    return CyclicCode{31, 11, 0x1626D5}; // and of a^7
  }
  return std::nullopt;
}

const std::vector<std::uint32_t> &representativesOf(const std::string &family)
{
  static const std::vector<std::uint32_t> golay23 = enumerate(*codeOf("golay23"));
  static const std::vector<std::uint32_t> bch31 = enumerate(*codeOf("bch31"));
  static const std::vector<std::uint32_t> bch31r = enumerate(*codeOf("bch31r"));
  if (family == "golay23") {
    return golay23;
  }
  if (family == "bch31") {
    return bch31;
  }
  if (family == "bch31r") {
    return bch31r;
  }
  throw vpException(vpException::badValue, "family %s has no code: use golay23, bch31 or bch31r", family.c_str());
}

} // namespace marker_simulator
END_VISP_NAMESPACE
