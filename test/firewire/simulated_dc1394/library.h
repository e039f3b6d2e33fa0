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
 * What the parts of the simulated libdc1394 share.
 */

#ifndef VP_TEST_DC1394_LIBRARY_H
#define VP_TEST_DC1394_LIBRARY_H

#include <memory>
#include <string>
#include <vector>

#include <dc1394/dc1394.h>

#include "simulated_camera.h"

/*! A handle to a camera: what the program sees comes first, as in libdc1394. */
struct SimulatedHandle
{
  dc1394camera_t camera = {};
  std::string vendor, model;
  std::shared_ptr<simulated_bus::SimulatedCamera> simulated;
};

namespace simulated_bus {
inline SimulatedCamera &cameraOf(dc1394camera_t *camera)
{
  return *reinterpret_cast<SimulatedHandle *>(camera)->simulated;
}

/*! What every access to a register of a camera gives that is gone. */
constexpr dc1394error_t noAnswer = DC1394_FAILURE;
} // namespace simulated_bus

#endif
