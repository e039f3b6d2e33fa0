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
 * Images of a file, a numbered sequence, a list or a video, one after the other.
 */

#ifndef VP_TUTORIAL_IMAGE_SOURCE_H
#define VP_TUTORIAL_IMAGE_SOURCE_H

#include <memory>
#include <optional>
#include <string>

#include <visp3/core/vpImage.h>

#include "../visp_names.h"

namespace tutorial {
/*! An image of a source, or the reason why it could not be read. */
struct SourceImage
{
  std::string name;                            //!< Its path; of a video, the video's path and "#" and the number.
  long number = 0;                             //!< Number in the names, frame of the video, or place in the list.
  std::optional<vpImage<unsigned char>> image; //!< The image, if it could be read.
  std::string problem;                         //!< Why it could not be read.
};

/*!
  Images one after the other.
*/
class ImageSource
{
public:
  virtual ~ImageSource() = default;

  /*!
    \return The next image, nothing after the last.
  */
  virtual std::optional<SourceImage> next() = 0;

  /*!
    \return Number of images, as far as it is known before they are read.
  */
  virtual std::size_t size() const = 0;
};

/*!
  Opens a source.

  \param input : An image, a video, a pattern such as img%04d.png, or \@list.txt with a path on each line. Paths of a
  list that do not exist from the working folder are looked for in the list's folder.
  \param first : First number of a pattern or a video (from 0); nothing: the first there is.
  \param last : Last number; nothing: the last there is. With both, images that are missing between them are problems.
  \exception vpException::ioError : If there is nothing to be opened.
  \exception UsageError : If a list or an image is asked for a first or last number.
*/
std::unique_ptr<ImageSource> openSource(const std::string &input, std::optional<long> first, std::optional<long> last);
} // namespace tutorial

#endif
