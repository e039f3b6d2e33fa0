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

#ifndef VP_TEST_SCREEN_H
#define VP_TEST_SCREEN_H

#include <cstddef>
#include <filesystem>

namespace test {
/*! What a screen showed: how many pixels of some colours. */
struct Screen
{
  std::size_t pixels = 0; //!< All pixels.
  std::size_t grey = 0;   //!< Neither black nor white nor coloured: a camera's image.
  std::size_t green = 0;  //!< Pure green: the outline of a marker.
  std::size_t white = 0;  //!< Pure white: the ground of the curves.
  std::size_t orange = 0; //!< vpColor::orange: the second pose.
  std::size_t yellow = 0; //!< Pure yellow: texts in the picture.
};

/*! Counts the pixels of a file in the X window dump format, 24 bits in 32, as Xvfb keeps its screen. */
Screen readScreen(const std::filesystem::path &file);
} // namespace test

#endif
