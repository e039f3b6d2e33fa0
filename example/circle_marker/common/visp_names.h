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
 * The namespace of newer ViSP.
 */

#ifndef VP_COMMON_VISP_NAMES_H
#define VP_COMMON_VISP_NAMES_H

#include <string>

#include <visp3/circle_marker/vpConfigCircleMarker.h>
#include <visp3/core/vpConfig.h>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace common {
/*! ViSP's version, such as "3.5.0". */
inline std::string vispVersion()
{
  return std::to_string(VISP_VERSION_MAJOR) + "." + std::to_string(VISP_VERSION_MINOR) + "." +
         std::to_string(VISP_VERSION_PATCH);
}
} // namespace common

#endif
