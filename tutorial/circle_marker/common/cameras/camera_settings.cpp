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

#include "camera_settings.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <sstream>

#include "../arguments.h"
#include "../numbered_name.h"
#include "../parse.h"
#include "firewire_camera.h"
#include "opencv_camera.h"
#include "recording.h"
#include "v4l2_camera.h"

namespace tutorial {
namespace {
using Kind = CameraSettings::Kind;

std::string lowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

/*! Reads numbers with a character between them, as 1280x960 or 320,240,640,480. */
std::vector<unsigned int> numbersOf(const std::string &text, char separator, std::size_t count,
                                    const std::string &complaint)
{
  std::vector<unsigned int> numbers;
  std::istringstream in(text);
  std::string part;
  while (std::getline(in, part, separator)) {
    constexpr std::size_t mostDigits = 5; // of a number of pixels
    const bool isNumber =
        !part.empty() && part.size() <= mostDigits && part.find_first_not_of("0123456789") == std::string::npos;
    if (!isNumber) {
      throw UsageError(complaint + ", not \"" + text + "\"");
    }
    numbers.push_back(static_cast<unsigned int>(std::stoul(part)));
  }
  if (numbers.size() != count) {
    throw UsageError(complaint + ", not \"" + text + "\"");
  }
  return numbers;
}

FeatureSetting featureOf(const std::string &text, const std::string &option)
{
  if (lowerCase(text) == "auto") {
    return FeatureSetting{};
  }
  return FeatureSetting{numbersOf(text, ',', 1, option + " takes auto or a number in the camera's own units")[0]};
}

/*! Splits firewire:0 into kind and address; everything else is a recording. */
void readSource(const std::string &source, CameraSettings &settings)
{
  const std::size_t colon = source.find(':');
  const std::string word = lowerCase(source.substr(0, colon));
  const std::string rest = colon == std::string::npos ? "" : source.substr(colon + 1);
  const std::pair<const char *, Kind> kinds[] = {
      {"firewire", Kind::FireWire}, {"v4l2", Kind::V4L2}, {"opencv", Kind::OpenCV}};
  const char *defaults[] = {"0", "/dev/video0", "0"};
  settings.name = source;
  settings.kind = Kind::Recording;
  settings.address = source;
  for (std::size_t i = 0; i < 3; ++i) {
    if (word == kinds[i].first) {
      settings.kind = kinds[i].second;
      settings.address = rest.empty() ? defaults[i] : rest;
      settings.name = word + ":" + settings.address;
    }
  }
}

/*! Refuses options that the source would silently ignore. */
void refuse(bool isGiven, const std::string &option, const CameraSettings &settings, const std::string &instead)
{
  if (isGiven) {
    throw UsageError(option + " is not for the source " + settings.name + "; " + instead);
  }
}

void check(const CameraSettings &settings)
{
  const bool isFireWire = settings.kind == Kind::FireWire;
  const bool isRecording = settings.kind == Kind::Recording;
  if (!isFireWire) {
    const std::string only = "only FireWire cameras take it";
    refuse(settings.videoMode.has_value(), "--video-mode", settings, only + ", use --image-size");
    refuse(settings.region.has_value(), "--format7-roi", settings, only);
    refuse(settings.colorCoding.has_value(), "--color-coding", settings, only);
    refuse(settings.shutter.has_value(), "--shutter", settings, only);
    refuse(settings.gain.has_value(), "--gain", settings, only);
  }
  if (settings.kind == Kind::V4L2) {
    refuse(settings.framerate.has_value(), "--framerate", settings,
           "ViSP's grabber takes the camera's own; set it before with v4l2-ctl --set-parm");
  }
  const bool hasSize = settings.size.first != 0;
  if (isFireWire || isRecording) {
    refuse(hasSize, "--image-size", settings, isFireWire ? "use --video-mode" : "a recording has its own");
  }
  const bool isFormat7 = settings.videoMode && settings.videoMode->rfind("format7_", 0) == 0;
  if (isFireWire && !isFormat7 && (settings.region || settings.colorCoding)) {
    throw UsageError("--format7-roi and --color-coding need a Format7 mode; add --video-mode format7_0");
  }
  if (isFormat7 && settings.framerate) {
    throw UsageError("Format7 has no --framerate: the size of the region sets it; leave it out");
  }
}
} // namespace

void CameraOptions::addTo(CLI::App &app, const std::string &more)
{
  app.add_option("--source", source,
                 more + "firewire[:index or GUID], v4l2[:device], opencv[:number or address], or a recording: "
                        "img%04d.png, a video, @list.txt")
      ->capture_default_str();
  app.add_option("--video-mode", videoMode,
                 "FireWire: width x height and coding, as 1280x960_mono8, or format7_0 to format7_7");
  app.add_option("--framerate", framerate,
                 "FireWire: 1.875, 3.75, 7.5, 15, 30, 60, 120 or 240 images per second; OpenCV: any; "
                 "a recording: pace at which it is shown")
      ->check(positiveNumber());
  app.add_option("--format7-roi", region, "FireWire, Format7: region left,top,width,height, pixels");
  app.add_option("--color-coding", colorCoding, "FireWire, Format7: mono8, mono16, yuv422, rgb8, raw8, ...");
  app.add_option("--shutter", shutter, "FireWire: auto, or a number in the camera's own units");
  app.add_option("--gain", gain, "FireWire: auto, or a number in the camera's own units");
  app.add_option("--image-size", size, "V4L2, OpenCV: size of the images, as 1280x960");
}

CameraSettings CameraOptions::settings() const
{
  CameraSettings result;
  readSource(source, result);
  result.framerate = framerate;
  if (videoMode) {
    result.videoMode = lowerCase(*videoMode);
  }
  if (colorCoding) {
    result.colorCoding = lowerCase(*colorCoding);
  }
  if (region) {
    const auto numbers = numbersOf(*region, ',', 4, "--format7-roi takes left,top,width,height in pixels");
    result.region = ImageRegion{numbers[0], numbers[1], numbers[2], numbers[3]};
    if (numbers[2] == 0 || numbers[3] == 0) {
      throw UsageError("--format7-roi needs a width and a height");
    }
  }
  if (shutter) {
    result.shutter = featureOf(*shutter, "--shutter");
  }
  if (gain) {
    result.gain = featureOf(*gain, "--gain");
  }
  if (size) {
    const auto numbers = numbersOf(*size, 'x', 2, "--image-size takes width and height, as 1280x960");
    result.size = {numbers[0], numbers[1]};
  }
  check(result);
  return result;
}

std::unique_ptr<FrameSource> openFrameSource(const CameraSettings &settings)
{
  switch (settings.kind) {
  case Kind::FireWire:
    return openFireWireCamera(settings);
  case Kind::V4L2:
    return openV4l2Camera(settings);
  case Kind::OpenCV:
    return openOpenCvCamera(settings);
  default:
    return openRecording(settings);
  }
}

std::string listCameras()
{
  return listFireWireCameras() + listV4l2Cameras();
}
} // namespace tutorial
