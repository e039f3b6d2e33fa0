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
 * The density of a PNG picture, so that it prints in true size.
 */

#include <cmath>
#include <cstdint>

#include "encode.h"

namespace create {
namespace {
// The signature (8 bytes) and the IHDR chunk (12 bytes and 13 of data) stand first; pHYs must come before the pixels.
constexpr std::size_t endOfHeader = 8 + 12 + 13;

std::string bigEndian(std::uint32_t value)
{
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) {
    bytes.push_back(static_cast<char>((value >> shift) & 0xFF));
  }
  return bytes;
}

/*! The cyclic redundancy check of PNG's chunks (specification, annex D), bit by bit: a chunk of 13 bytes needs no
 * table. */
std::uint32_t checksum(const std::string &bytes)
{
  std::uint32_t crc = 0xFFFFFFFF;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit) {
      crc = (crc >> 1) ^ ((crc & 1) ? 0xEDB88320 : 0);
    }
  }
  return ~crc;
}
} // namespace

std::string withDensity(const std::string &png, double pixelsPerMetre)
{
  const std::string density = bigEndian(static_cast<std::uint32_t>(std::lround(pixelsPerMetre)));
  const char perMetre = 1;
  const std::string chunk = "pHYs" + density + density + perMetre;
  return png.substr(0, endOfHeader) + bigEndian(static_cast<std::uint32_t>(chunk.size() - 4)) + chunk +
         bigEndian(checksum(chunk)) + png.substr(endOfHeader);
}
} // namespace create
