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
 * Which camera, and how it is set.
 */

#ifndef VP_TUTORIAL_CAMERA_SETTINGS_H
#define VP_TUTORIAL_CAMERA_SETTINGS_H

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "frame_source.h"

namespace CLI {
class App;
} // namespace CLI

namespace tutorial {
/*! A feature of a camera: set by the camera itself, or to a number in the camera's own units. */
struct FeatureSetting
{
  std::optional<unsigned int> value; //!< Nothing: automatic.
};

/*! Which images are wanted. What is not set stays as the camera has it. */
struct CameraSettings
{
  enum class Kind
  {
    FireWire,
    V4L2,
    OpenCV,
    Recording
  };

  Kind kind = Kind::FireWire;
  std::string address;                              //!< Index, GUID, device, number, address or file.
  std::string name;                                 //!< As the user has written it.
  std::optional<std::string> videoMode;             //!< As 1280x960_mono8 or format7_0.
  std::optional<double> framerate;                  //!< Images per second.
  std::optional<ImageRegion> region;                //!< Of Format7.
  std::optional<std::string> colorCoding;           //!< Of Format7, as mono8.
  std::optional<FeatureSetting> shutter;            //!< Exposure time.
  std::optional<FeatureSetting> gain;               //!< Amplification.
  std::pair<unsigned int, unsigned int> size{0, 0}; //!< Width and height of V4L2 and OpenCV cameras, pixels.
};

/*! The options as they were written; lives as long as the CLI::App that fills it. */
struct CameraOptions
{
  std::string source;
  std::optional<std::string> videoMode;
  std::optional<double> framerate;
  std::optional<std::string> region;
  std::optional<std::string> colorCoding;
  std::optional<std::string> shutter;
  std::optional<std::string> gain;
  std::optional<std::string> size;

  /*!
    Adds the options to a program.
    \param app : The program.
    \param more : Sources that the program adds, in words.
  */
  void addTo(CLI::App &app, const std::string &more = "");

  /*!
    \return What the options mean.
    \exception UsageError : If they cannot be used.
  */
  CameraSettings settings() const;
};

/*!
  Opens a camera or a recording.
  \exception SourceError : If it cannot be used; says what to do.
  \exception UsageError : If it does not have what was asked for.
*/
std::unique_ptr<FrameSource> openFrameSource(const CameraSettings &settings);

/*! \return All cameras of this computer, one on each line, or what is missing to find any. */
std::string listCameras();
} // namespace tutorial

#endif
