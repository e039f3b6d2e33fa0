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
 * The frames of a video file.
 */

#ifndef VP_TUTORIAL_VIDEO_SOURCE_H
#define VP_TUTORIAL_VIDEO_SOURCE_H

#include <memory>
#include <optional>
#include <string>

#include "image_source.h"

namespace tutorial {
/*! Whether a file is a video, by its extension. */
bool isVideo(const std::string &path);

/*!
  \param path : A video.
  \param first : First frame that is wanted, from 0; nothing: from the first on.
  \param last : Last one; nothing: to the end.
  \exception vpException::ioError : It cannot be read, or the program was built without what reads it.
*/
std::unique_ptr<ImageSource> openVideo(const std::string &path, std::optional<long> first, std::optional<long> last);
} // namespace tutorial

#endif
