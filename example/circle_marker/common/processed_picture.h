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
 * What becomes of a picture between the sensor and the detector.
 */

#ifndef VP_COMMON_PROCESSED_PICTURE_H
#define VP_COMMON_PROCESSED_PICTURE_H

#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpImage.h>
#include <visp3/core/vpImagePoint.h>

#include "common/visp_names.h"

namespace common {
/*! What a camera, its driver or a program makes of a picture: neighbouring pixels share their noise after each. */
enum class Processing
{
  NONE,
  DEMOSAICED, //!< A colour sensor's: each pixel sees one colour, the other two are interpolated; then made grey.
  SMOOTHED,   //!< By a Gaussian of one pixel.
  ENLARGED    //!< To twice its size, with linear interpolation.
};

/*! How much larger a picture becomes. */
double enlargementBy(Processing processing);

/*!
  Processes a picture.
  \param processing : What is done.
  \param I : The picture, of a grey scene: to a colour sensor with the mosaic BGGR all colours are as bright.
*/
void process(Processing processing, vpImage<unsigned char> &I);

/*! Where a point of the sensor's picture is in the processed one, pixels. */
vpImagePoint placeIn(Processing processing, const vpImagePoint &place);

/*!
  The camera of the processed picture.
  \exception vpException::badValue : If an enlarged picture's lens has a distortion.
*/
vpCameraParameters cameraOf(Processing processing, const vpCameraParameters &sensor);
} // namespace common

#endif
