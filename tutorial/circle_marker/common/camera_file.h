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
 * A camera read from an XML file of ViSP.
 */

#ifndef VP_TUTORIAL_CAMERA_FILE_H
#define VP_TUTORIAL_CAMERA_FILE_H

#include <cmath>
#include <iostream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>

#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpException.h>
#include <visp3/core/vpXmlParserCamera.h>

#include "visp_names.h"

namespace tutorial {
/*! A camera, and the size of the images it was calibrated with. */
struct NamedCamera
{
  vpCameraParameters parameters;
  unsigned int width = 0;  //!< Pixels; 0 if the file does not say.
  unsigned int height = 0; //!< Pixels; 0 if the file does not say.
};

/*! There is no such camera: without it nothing can be done. */
class CameraError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/*!
  Keeps a stream silent as long as it lives: vpXmlParserCamera reports what it finds to std::cout, where the program's
  results go, and complains to std::cerr of every model that is not there.
*/
class SilentStream
{
public:
  explicit SilentStream(std::ostream &stream) : m_stream(stream), m_former(stream.rdbuf(m_buffer.rdbuf())) {}
  SilentStream(const SilentStream &) = delete;
  SilentStream &operator=(const SilentStream &) = delete;
  ~SilentStream() { m_stream.rdbuf(m_former); }

private:
  std::ostringstream m_buffer; //!< Takes what is written.
  std::ostream &m_stream;      //!< The stream.
  std::streambuf *m_former;    //!< Where it wrote to.
};

/*! Camera of one model and image size (0: any), if the file has exactly one such. */
inline std::optional<NamedCamera> findCamera(const std::string &file, const std::string &name,
                                             vpCameraParameters::vpCameraParametersProjType model, unsigned int width,
                                             unsigned int height)
{
  const SilentStream silentErrors(std::cerr), silentOutput(std::cout);
  vpXmlParserCamera parser;
  NamedCamera camera;
  const auto refuse = [&] {
    throw CameraError("of the camera \"" + name + "\" in \"" + file + "\" px and py must be positive, and all finite");
  };
  try {
    if (parser.parse(camera.parameters, file, name, model, width, height) != vpXmlParserCamera::SEQUENCE_OK) {
      return std::nullopt;
    }
  }
  catch (const vpException &) { // of a px or py that is 0, or no number
    refuse();
  }
  const vpCameraParameters &cam = camera.parameters;
  if (!(cam.get_px() > 0. && cam.get_py() > 0. && std::isfinite(cam.get_px() + cam.get_py()) &&
        std::isfinite(cam.get_u0() + cam.get_v0()))) {
    refuse();
  }
  if (model == vpCameraParameters::perspectiveProjWithDistortion && cam.get_kud() == 0. && cam.get_kdu() == 0.) {
    // The same camera, and faster to compute with.
    camera.parameters.initPersProjWithoutDistortion(cam.get_px(), cam.get_py(), cam.get_u0(), cam.get_v0());
  }
  camera.width = parser.getWidth();
  camera.height = parser.getHeight();
  return camera;
}

/*!
  Reads a camera. Where the file has several models of it, one with distortion is taken before one without; where it
  has several image sizes, the one that was asked for.

  \param file : XML file as vpXmlParserCamera writes it.
  \param name : Name of the camera in it.
  \param width : Width of the images, pixels.
  \param height : Height of the images, pixels.
  \exception CameraError : If the file has no such camera.
*/
inline NamedCamera readCamera(const std::string &file, const std::string &name, unsigned int width, unsigned int height)
{
  constexpr vpCameraParameters::vpCameraParametersProjType models[] = {
      vpCameraParameters::perspectiveProjWithDistortion, vpCameraParameters::ProjWithKannalaBrandtDistortion,
      vpCameraParameters::perspectiveProjWithoutDistortion};
  for (const bool anySize : {false, true}) {
    for (const auto model : models) {
      if (const auto camera = findCamera(file, name, model, anySize ? 0 : width, anySize ? 0 : height)) {
        return *camera;
      }
    }
  }
  throw CameraError("no camera \"" + name + "\" can be read from \"" + file +
                    "\"; it must be a file of vpXmlParserCamera with one entry for that name (--camera-name)");
}
} // namespace tutorial

#endif
