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
 * What a screen without a monitor showed.
 */

#include "screen.h"

#include <cstdint>
#include <string>

#include "run_program.h"

namespace test {
Screen readScreen(const std::filesystem::path &file)
{
  const std::string bytes = test::contentOf(file);
  const auto field = [&bytes](std::size_t index) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      value = value << 8 | static_cast<unsigned char>(bytes.at(4 * index + i));
    }
    return value;
  };
  Screen screen;
  constexpr std::size_t bitsPerPixelField = 11, headerSizeField = 0, numberOfColorsField = 19, bytesOfAColor = 12;
  if (bytes.size() < 100 || field(bitsPerPixelField) != 32) {
    return screen;
  }
  for (std::size_t i = field(headerSizeField) + bytesOfAColor * field(numberOfColorsField); i + 4 <= bytes.size();
       i += 4) {
    const int blue = static_cast<unsigned char>(bytes[i]), green = static_cast<unsigned char>(bytes[i + 1]),
              red = static_cast<unsigned char>(bytes[i + 2]);
    ++screen.pixels;
    screen.grey += red == green && green == blue && red > 20 && red < 250 ? 1 : 0;
    screen.green += green == 255 && red == 0 && blue == 0 ? 1 : 0;
    screen.white += red == 255 && green == 255 && blue == 255 ? 1 : 0;
    screen.orange += red == 255 && green == 165 && blue == 0 ? 1 : 0;
    screen.yellow += red == 255 && green == 255 && blue == 0 ? 1 : 0;
  }
  return screen;
}
} // namespace test
