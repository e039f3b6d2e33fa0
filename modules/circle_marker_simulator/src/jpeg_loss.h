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
 * What JPEG compression takes from a grey image.
 */

#ifndef VP_SIMULATOR_JPEG_LOSS_H
#define VP_SIMULATOR_JPEG_LOSS_H

#include <visp3/core/vpImage.h>

#include <visp3/circle_marker_simulator/vpConfigCircleMarkerSimulator.h>

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

/*! Throws vpException::badValue unless a quality is from 1 to 100. */
void checkJpegQuality(int quality);

/*!
  Replaces an image by what is left of it after baseline JPEG compression (ITU-T T.81) at a quality of 1 to 100.

  Only the quantised cosine transform loses anything; the coding of its coefficients does not and is left out. The
  tables are the recommended one for luminance (annex K.1), scaled with the quality as the IJG's library does it.
*/
void loseToJpeg(int quality, vpImage<unsigned char> &I);

} // namespace marker_simulator
END_VISP_NAMESPACE

#endif
