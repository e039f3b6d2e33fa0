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
 * What libdc1394 knows and ViSP's grabber does not say.
 */

#ifndef VP_TUTORIAL_FIREWIRE_BUS_H
#define VP_TUTORIAL_FIREWIRE_BUS_H

#include <visp3/core/vpConfig.h>

#if defined(VISP_HAVE_DC1394) && defined(CIRCLE_MARKER_HAVE_LIBDC1394)
#define CIRCLE_MARKER_HAVE_FIREWIRE

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <dc1394/dc1394.h>

namespace tutorial {
/*!
  A second handle to a camera, beside ViSP's. vp1394TwoGrabber (3.5.0 to 3.7) ends the program where it should throw:
  when libdc1394 cannot start or look for cameras, when one of several cameras cannot be opened, when an image cannot be
  delivered (acquire() uses it unseen), and when a camera that is gone is closed (close() and setTransmission() call
  each other without end). All of this is looked at here first.
*/
class FireWireHandle
{
public:
  FireWireHandle(std::shared_ptr<dc1394_t> library, std::uint64_t guid);

  /*! \return Whether the camera could be opened. */
  bool isOpen() const { return m_camera != nullptr; }
  /*! \return Whether the camera still answers: one register is read. */
  bool answers() const;
  /*! \return Whether a feature is there and can be set by hand. */
  bool canBeSet(dc1394feature_t feature) const;
  /*! \return Values that a feature can take, in words; empty if the camera does not say. */
  std::string rangeOf(dc1394feature_t feature) const;
  std::uint64_t guid() const { return m_camera->guid; }
  std::string model() const;

private:
  dc1394feature_info_t info(dc1394feature_t feature) const;

  std::shared_ptr<dc1394_t> m_library;      //!< Must live as long as the camera.
  std::shared_ptr<dc1394camera_t> m_camera; //!< The camera.
};

/*!
  \return All cameras.
  \exception SourceError : If they cannot be looked for, or one of them cannot be opened.
*/
std::vector<FireWireHandle> fireWireCameras();

/*! \return What libdc1394 has complained of since the last call; it is kept from the standard error. */
std::string fireWireComplaints();
} // namespace tutorial
#endif

#endif
