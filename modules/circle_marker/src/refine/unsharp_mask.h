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
 * Sharpening of the camera: told from a marker's ring, and undone.
 */

/*!
  \file unsharp_mask.h
  \brief A camera that sharpens its images: its mask is undone around a marker.
*/

#ifndef VP_CIRCLE_MARKER_UNSHARP_MASK_H
#define VP_CIRCLE_MARKER_UNSHARP_MASK_H

#include <opencv2/core.hpp>

#include <visp3/circle_marker/vpConfigCircleMarker.h>
#include <visp3/core/vpImage.h>

#include "support/deadline.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! To the image was added, so many times, what a Gaussian takes from it: most cameras sharpen by something like it. */
struct UnsharpMask
{
  double amount = 0.;  //!< How many times.
  double sigma = 0.;   //!< Standard deviation of the Gaussian, pixels.
  double white = 255.; //!< Grey level of paper beside the marker,
  double ink = 0.;     //!< and of its ink.
};

/*! Mean of the logarithm of a mask's gain over all frequencies of pixels. */
double lnGainOf(const UnsharpMask &mask);

/*!
  Makes what was sharpened as it was: 1 + a (1 - G) takes no frequency away, so that its inverse is a mild blur, and
  noise that the camera sharpened with the image is as white again as it was.
  \param mask : What it was sharpened with.
  \param I : The image.
  \param box : The part of it that is wanted, within the image.
  \param deadline : Asked before each of up to some twenty steps, of 2 to 8 ms for a million pixels.
  \param restored : The result, of the same size as the image; only the box of it is written.
  \return False if there was no time.
*/
bool undo(const UnsharpMask &mask, const vpImage<unsigned char> &I, const cv::Rect &box, const Deadline &deadline,
          vpImage<unsigned char> &restored);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
