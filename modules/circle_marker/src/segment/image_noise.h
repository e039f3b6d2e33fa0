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
 * The noise of an image.
 */

#ifndef VP_CIRCLE_MARKER_IMAGE_NOISE_H
#define VP_CIRCLE_MARKER_IMAGE_NOISE_H

#include <visp3/circle_marker/vpConfigCircleMarker.h>
#include <visp3/core/vpImage.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! Noise of an image. */
struct ImageNoise
{
  double sigma = 0.; //!< Standard deviation of a pixel's, grey levels.
  /*!
    Number of pixels that share their noise: 1 if it is independent, more after a colour sensor's demosaicing, a change
    of size or a smoothing. It is the spectrum of the noise at a period of some eight pixels, where the edges of markers
    have theirs, over that of independent noise; as many pixels say as much as one.
  */
  double sharing = 1.;
  /*!
    Whether the image is interpolated between the pixels of another, as undistorted ones are: there is noise, and
    neighbouring pixels share some of it, but not so much that sharing tells of it.
  */
  bool isResampled = false;
};

/*!
  Estimates the noise of an image.

  Independent noise is the median absolute response to the difference of two Laplacians, which is blind to planes and
  straight edges (Immerkaer, "Fast noise variance estimation", 1996; the median in place of his mean keeps it from
  rising with texture). Of noise that pixels share those Laplacians see a half to a tenth. The flattest blocks of an
  image show all of it, and how many pixels share it; they decide where they have clearly more,
  or clearly less and what the Laplacians see is texture.
*/
ImageNoise estimateNoise(const vpImage<unsigned char> &I);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
