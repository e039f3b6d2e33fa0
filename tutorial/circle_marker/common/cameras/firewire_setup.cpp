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
 * How a FireWire camera is set.
 */

#include "firewire_setup.h"

#ifdef CIRCLE_MARKER_HAVE_FIREWIRE
#include <algorithm>
#include <cctype>
#include <cmath>
#include <list>

#include "../arguments.h"

namespace tutorial {
namespace {
using Grabber = vp1394TwoGrabber;

/*! ViSP's names without their first word and in small letters: MODE_1280x960_MONO8 is 1280x960_mono8. */
std::string shortName(const std::string &name, const std::string &prefix)
{
  std::string result = name.substr(name.rfind(prefix, 0) == 0 ? prefix.size() : 0);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return result;
}

std::string nameOf(Grabber::vp1394TwoVideoModeType mode)
{
  return shortName(Grabber::videoMode2string(mode), "MODE_");
}

std::string nameOf(Grabber::vp1394TwoColorCodingType coding)
{
  return shortName(Grabber::colorCoding2string(coding), "COLOR_CODING_");
}

/*! Images per second: the rates double from 1.875 on. */
double valueOf(Grabber::vp1394TwoFramerateType rate)
{
  return 1.875 * std::pow(2., static_cast<int>(rate) - static_cast<int>(Grabber::vpFRAMERATE_1_875));
}

std::string nameOf(Grabber::vp1394TwoFramerateType rate)
{
  std::string text = std::to_string(valueOf(rate));
  text.erase(text.find_last_not_of('0') + 1);
  return text.back() == '.' ? text.substr(0, text.size() - 1) : text;
}

template <typename Type> std::string namesOf(const std::list<Type> &values)
{
  std::string names;
  for (const Type value : values) {
    names += (names.empty() ? "" : ", ") + nameOf(value);
  }
  return names;
}

/*! The value of a list that is wanted. */
template <typename Type, typename Test>
Type chosen(const std::list<Type> &values, const Test &isWanted, const std::string &option)
{
  const auto found = std::find_if(values.begin(), values.end(), isWanted);
  if (found == values.end()) {
    throw UsageError("the camera does not have this " + option + "; it has " + namesOf(values));
  }
  return *found;
}

Grabber::vp1394TwoVideoModeType setVideoMode(Grabber &grabber, const CameraSettings &settings)
{
  Grabber::vp1394TwoVideoModeType mode;
  grabber.getVideoMode(mode);
  if (settings.videoMode) {
    std::list<Grabber::vp1394TwoVideoModeType> modes;
    grabber.getVideoModeSupported(modes);
    mode = chosen(
        modes, [&](auto candidate) { return nameOf(candidate) == *settings.videoMode; }, "--video-mode");
  }
  // Also with the mode it has: this starts the camera.
  grabber.setVideoMode(mode);
  return mode;
}

void setFramerate(Grabber &grabber, Grabber::vp1394TwoVideoModeType mode, double wanted)
{
  if (grabber.isVideoModeFormat7(mode)) {
    throw UsageError("the camera is in a Format7 mode, which has no --framerate: the size of the region sets it");
  }
  std::list<Grabber::vp1394TwoFramerateType> rates;
  grabber.getFramerateSupported(mode, rates);
  constexpr double rounding = 0.05; // 3.75 may be written 3.8
  grabber.setFramerate(chosen(
      rates, [&](auto candidate) { return std::abs(valueOf(candidate) - wanted) <= rounding; },
      "--framerate in the mode " + nameOf(mode)));
}

void setFormat7(Grabber &grabber, Grabber::vp1394TwoVideoModeType mode, const CameraSettings &settings)
{
  if (settings.colorCoding) {
    std::list<Grabber::vp1394TwoColorCodingType> codings;
    grabber.getColorCodingSupported(mode, codings);
    grabber.setColorCoding(chosen(
        codings, [&](auto candidate) { return nameOf(candidate) == *settings.colorCoding; }, "--color-coding"));
  }
  // The whole image unless told: the region of the camera's last user would shift the image unnoticed.
  const ImageRegion region = settings.region.value_or(ImageRegion{});
  // ViSP makes a region that is too large fit without a word, and its camera then differs from what was asked for.
  grabber.setFormat7ROI();
  const unsigned int width = grabber.getWidth(), height = grabber.getHeight();
  if (region.left + region.width > width || region.top + region.height > height) {
    throw UsageError("--format7-roi goes beyond the camera's image of " + std::to_string(width) + " x " +
                     std::to_string(height) + " pixels");
  }
  if (settings.region) {
    grabber.setFormat7ROI(region.left, region.top, region.width, region.height);
    if (grabber.getWidth() != region.width || grabber.getHeight() != region.height) {
      throw UsageError("the camera makes the region " + std::to_string(grabber.getWidth()) + " x " +
                       std::to_string(grabber.getHeight()) + " pixels large; give --format7-roi in its steps");
    }
  }
}

void setFeature(Grabber &grabber, const FireWireHandle &handle, bool isShutter, const FeatureSetting &setting)
{
  const dc1394feature_t feature = isShutter ? DC1394_FEATURE_SHUTTER : DC1394_FEATURE_GAIN;
  const std::string option = isShutter ? "--shutter" : "--gain";
  if (!setting.value) {
    isShutter ? grabber.setAutoShutter(true) : grabber.setAutoGain(true);
    return;
  }
  if (!handle.canBeSet(feature)) {
    throw UsageError("the camera has no " + option + " that can be set; leave it out");
  }
  grabber.setParameterValue(isShutter ? Grabber::vpFEATURE_SHUTTER : Grabber::vpFEATURE_GAIN, *setting.value);
  const unsigned int taken =
      grabber.getParameterValue(isShutter ? Grabber::vpFEATURE_SHUTTER : Grabber::vpFEATURE_GAIN);
  if (taken != *setting.value) {
    throw UsageError("the camera does not take " + option + " " + std::to_string(*setting.value) + "; it takes " +
                     handle.rangeOf(feature));
  }
}
} // namespace

std::string videoModesOf(vp1394TwoGrabber &grabber)
{
  std::list<Grabber::vp1394TwoVideoModeType> modes;
  grabber.getVideoModeSupported(modes);
  return namesOf(modes);
}

std::optional<double> setUpFireWireCamera(vp1394TwoGrabber &grabber, const FireWireHandle &handle,
                                          const CameraSettings &settings)
{
  const Grabber::vp1394TwoVideoModeType mode = setVideoMode(grabber, settings);
  if (settings.framerate) {
    setFramerate(grabber, mode, *settings.framerate);
  }
  const bool isFormat7 = grabber.isVideoModeFormat7(mode);
  if (isFormat7) {
    setFormat7(grabber, mode, settings);
  }
  if (settings.shutter) {
    setFeature(grabber, handle, true, *settings.shutter);
  }
  if (settings.gain) {
    setFeature(grabber, handle, false, *settings.gain);
  }
  if (isFormat7) {
    return std::nullopt;
  }
  Grabber::vp1394TwoFramerateType rate;
  grabber.getFramerate(rate);
  return 1. / valueOf(rate);
}
} // namespace tutorial
#endif
