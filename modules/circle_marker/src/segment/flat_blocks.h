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
 * The flattest parts of an image.
 */

#ifndef VP_CIRCLE_MARKER_FLAT_BLOCKS_H
#define VP_CIRCLE_MARKER_FLAT_BLOCKS_H

#include <visp3/circle_marker/vpConfigCircleMarker.h>
#include <visp3/core/vpImage.h>

#include <optional>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! How much blocks of an image, 8 x 8 pixels, differ from the planes nearest to their grey levels. */
struct FlatBlocks
{
  double variance = 0.; //!< Of a pixel where the image is flattest, grey levels^2.
  double sharing = 1.;  //!< Number of pixels that share their noise there, see ImageNoise; 1 if few blocks are flat.
  /*!
    Correlation of pixels side by side less that of pixels two apart, mean of both directions: of independent noise 0,
    of slopes 0, of waves of 20 pixels and more less than 0.15 times their share of the variance.
  */
  double likeness = 0.;
  double medianVariance = 0.; //!< Of a pixel of the median block, grey levels^2.
  double upperVariance = 0.;  //!< Of the block that a fifth of them exceed.
};

/*!
  Asks blocks evenly over the image. The flattest tenth of them are flat, unless a few are flatter by far, as the paper
  of markers is where texture fills the image. Nothing if the image has too few whose grey levels are not cut off.
*/
std::optional<FlatBlocks> findFlatBlocks(const vpImage<unsigned char> &I);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
