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
 * Pictures as the bytes of PDF, SVG and PNG files.
 */

#ifndef VP_CREATE_ENCODE_H
#define VP_CREATE_ENCODE_H

#include <string>
#include <vector>

#include "shapes.h"

namespace create {
/*! The pixels of a PNG picture. */
struct Raster
{
  int width, height;          //!< Pixels.
  double pixelsPerMillimetre; //!< The same in x and y.
};

/*!
  A PDF document in true size, one page a picture.
  \exception std::runtime_error : If cairo fails.
*/
std::string encodePdf(const std::vector<Picture> &pictures);

/*! An SVG picture in true size, with circles that are exact circles. */
std::string encodeSvg(const Picture &picture);

/*!
  A greyscale PNG picture, each pixel the mean of the paper under it, that knows its density.
  \exception std::runtime_error : If cairo fails.
*/
std::string encodePng(const Picture &picture, const Raster &raster);

/*! A PNG file with its density, pixels a metre, recorded in a pHYs chunk (PNG specification, 11.3.5.3). */
std::string withDensity(const std::string &png, double pixelsPerMetre);
} // namespace create

#endif
