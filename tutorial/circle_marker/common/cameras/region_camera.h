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
 * Camera parameters for a region of the camera's image.
 */

#ifndef VP_TUTORIAL_REGION_CAMERA_H
#define VP_TUTORIAL_REGION_CAMERA_H

#include <string>
#include <vector>

#include <visp3/core/vpCameraParameters.h>

#include "../camera_file.h"
#include "frame_source.h"

namespace tutorial {
/*!
  \return A camera whose principal point is moved: pixel (u, v) of the region is pixel (u + left, v + top) of the whole
  image, and lens distortion belongs to the whole image.
*/
vpCameraParameters shiftedCamera(const vpCameraParameters &cam, const ImageRegion &region);

/*!
  Camera parameters from a file, for images of a camera that may show a region of its whole image.
*/
class RegionCamera
{
public:
  /*!
    \exception CameraError : If there is no such file.
  */
  RegionCamera(const std::string &file, const std::string &name);

  /*! \return The parameters for images of this size, pixels. */
  vpCameraParameters forImage(unsigned int width, unsigned int height, const ImageRegion &region);

  /*! \return What the user should know of the choice, since the last call. */
  std::vector<std::string> newNotes();

private:
  std::string m_file;               //!< XML file.
  std::string m_name;               //!< Name of the camera in it.
  unsigned int m_width = 0;         //!< Of the last image, pixels.
  unsigned int m_height = 0;        //!< Of the last image, pixels.
  vpCameraParameters m_camera;      //!< For the last image.
  std::vector<std::string> m_notes; //!< Not read yet.
};
} // namespace tutorial

#endif
