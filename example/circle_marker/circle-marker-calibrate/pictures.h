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
 * The pictures, and what is seen in them.
 */

#ifndef VP_CALIBRATE_PICTURES_H
#define VP_CALIBRATE_PICTURES_H

#include <functional>
#include <string>
#include <vector>

#include <visp3/core/vpImage.h>

#include "command_line.h"
#include "view.h"

namespace calibrate {
struct Picture
{
  std::string name;
  vpImage<unsigned char> image;
};

/*! Told of what cannot be used; the rest goes on. */
using Complain = std::function<void(const std::string &)>;

/*!
  The pictures of an order: read, simulated, or taken live.
  \exception std::runtime_error : If there are none at all.
*/
std::vector<Picture> gatherPictures(const Order &order, const Complain &complain);

/*! Takes pictures of the target from a live camera: see circle-marker-calibrate --help. */
std::vector<Picture> takePictures(const Order &order, const Complain &complain);
} // namespace calibrate

#endif
