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

#include "region_camera.h"

#include <filesystem>
#include <sstream>
#include <utility>

#include "../moved_camera.h"

namespace tutorial {
vpCameraParameters shiftedCamera(const vpCameraParameters &cam, const ImageRegion &region)
{
  return movedPrincipalPoint(cam, -static_cast<double>(region.left), -static_cast<double>(region.top));
}

RegionCamera::RegionCamera(const std::string &file, const std::string &name) : m_file(file), m_name(name)
{
  // Told before the camera starts; which of its entries fits is known with the first image.
  if (!std::filesystem::is_regular_file(file)) {
    throw CameraError("there is no file \"" + file + "\"; --intrinsic takes a file of vpXmlParserCamera");
  }
}

vpCameraParameters RegionCamera::forImage(unsigned int width, unsigned int height, const ImageRegion &region)
{
  if (width == m_width && height == m_height) {
    return m_camera;
  }
  const NamedCamera camera = readCamera(m_file, m_name, width, height);
  const bool isForImage = camera.width == width && camera.height == height;
  const bool isRegion = region.width != 0;
  std::ostringstream note;
  if (isRegion && !isForImage) {
    m_camera = shiftedCamera(camera.parameters, region);
    if (camera.width != 0 && (region.left + width > camera.width || region.top + height > camera.height)) {
      note << "the region goes beyond the image of " << camera.width << " x " << camera.height << " pixels that \""
           << m_file << "\" is for: check that it is the right camera";
    }
  }
  else {
    m_camera = camera.parameters;
    if (isRegion) {
      note << "\"" << m_file << "\" has parameters for images of " << width << " x " << height
           << " pixels; they are taken to be those of the region itself";
    }
    else if (camera.width != 0 && !isForImage) {
      note << "the camera \"" << m_name << "\" of \"" << m_file << "\" is for images of " << camera.width << " x "
           << camera.height << " pixels, but the images have " << width << " x " << height
           << "; its parameters are used as they are: check that they are the right ones";
    }
  }
  if (!note.str().empty()) {
    m_notes.push_back(note.str());
  }
  m_width = width;
  m_height = height;
  return m_camera;
}

std::vector<std::string> RegionCamera::newNotes()
{
  return std::exchange(m_notes, {});
}
} // namespace tutorial
