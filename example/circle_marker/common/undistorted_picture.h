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
 * A picture as if its lens had no distortion.
 */

#ifndef VP_COMMON_UNDISTORTED_PICTURE_H
#define VP_COMMON_UNDISTORTED_PICTURE_H

#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpImage.h>
#include <visp3/core/vpImagePoint.h>

#include "common/visp_names.h"

namespace common {
/*! A camera without its distortion. */
vpCameraParameters straightened(const vpCameraParameters &camera);

/*! Where a point of a camera's picture is in the undistorted one, pixels. */
vpImagePoint undistortedPlace(const vpCameraParameters &camera, const vpImagePoint &place);

/*!
  Undistorts a picture with linear interpolation. vpImageTools::undistort() takes the coefficient kud, from metres to
  pixels, which is no exact inverse of kdu; here it is the conversion from pixels to metres that is inverted, so that
  the camera of the result is exactly straightened(). What comes from outside of the picture is black.

  \param camera : The picture's camera, with a radial distortion of less than a third of the radius.

  \param I : The picture.
*/
void undistort(const vpCameraParameters &camera, vpImage<unsigned char> &I);
} // namespace common

#endif
