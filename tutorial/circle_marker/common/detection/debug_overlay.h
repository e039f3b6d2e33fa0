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
 * What the rooms of the detector saw, drawn over the image.
 */

#ifndef VP_TUTORIAL_DEBUG_OVERLAY_H
#define VP_TUTORIAL_DEBUG_OVERLAY_H

#include <string>
#include <vector>

#include <visp3/circle_marker/vpDetectorCircleMarker.h>
#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpImage.h>
#include <visp3/core/vpRGBa.h>

#include "../visp_names.h"

namespace tutorial {
/*! A picture with a name: the number of the room in the order an image visits them, and the room. */
struct RoomPicture
{
  std::string name;        //!< For instance "3-ellipses".
  vpImage<vpRGBa> picture; //!< The image with what the room saw.
};

/*!
  \param I : The image.
  \param detector : The detector after detect() with setDebug(true).
  \param cam : The camera.
  \return A picture for each room: pixels of edges, chains of them, ellipses with what was refused, codes as they were
  read with the reasons, poses.
*/
std::vector<RoomPicture> roomPictures(const vpImage<unsigned char> &I, const vpDetectorCircleMarker &detector,
                                      const vpCameraParameters &cam);

/*! \return A table, CSV, of all candidates with what became of them. */
std::string candidateTable(const vpCircleMarkerDebug &debug);
} // namespace tutorial

#endif
