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
 * An image from a file of any kind.
 */

#ifndef VP_TUTORIAL_IMAGE_FILE_H
#define VP_TUTORIAL_IMAGE_FILE_H

#include <string>

#include <visp3/core/vpImage.h>

#include "../visp_names.h"

namespace tutorial {
/*! The extension of a name with its dot, in small letters. */
std::string extensionOf(const std::string &path);

/*!
  Reads an image: by ViSP, or by OpenCV what ViSP does not know, of 16 bits a channel, or by another name than its kind.
  \exception vpException::ioError : It is damaged, or is none.
*/
vpImage<unsigned char> readImage(const std::string &path);
} // namespace tutorial

#endif
