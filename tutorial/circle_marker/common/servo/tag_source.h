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
 * Sees the AprilTag of an object.
 */

#ifndef VP_TUTORIAL_TAG_SOURCE_H
#define VP_TUTORIAL_TAG_SOURCE_H

#include <optional>

#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/core/vpImage.h>
#include <visp3/detection/vpDetectorAprilTag.h>

#include "../visp_names.h"
#include "servo_scene.h"

namespace tutorial {
/*!
  Sees the AprilTag of an object, with ViSP's own detector.
*/
class TagSource
{
public:
  /*!
    \param tag : The tag.
    \param cam : The camera.
    \exception vpException : If ViSP was built without AprilTag.
  */
  TagSource(const MountedMarker &tag, const vpCameraParameters &cam);

  /*! \return The object's pose, if its tag is seen. */
  std::optional<vpHomogeneousMatrix> look(const vpImage<unsigned char> &I);

#if defined(VISP_HAVE_APRILTAG)
private:
  MountedMarker m_tag;           //!< What is looked for.
  vpCameraParameters m_cam;      //!< The camera, for AprilTag's pixels.
  vpDetectorAprilTag m_detector; //!< Finds it.
#endif
};
} // namespace tutorial

#endif
