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
 * The C interface of libdc1394: video modes, Format7, features.
 */

#include <algorithm>

#include "library.h"

using namespace simulated_bus;

namespace {
/*! As libdc1394: registers of features that a camera lacks can be read and written, without effect. */
Feature *featureOf(dc1394camera_t *camera, dc1394feature_t feature)
{
  auto &features = cameraOf(camera).features;
  const auto found = features.find(feature);
  return found == features.end() ? nullptr : &found->second;
}
} // namespace

extern "C" {
dc1394error_t dc1394_video_get_supported_modes(dc1394camera_t *camera, dc1394video_modes_t *modes)
{
  const std::vector<dc1394video_mode_t> all = cameraOf(camera).modes();
  modes->num = static_cast<std::uint32_t>(all.size());
  std::copy(all.begin(), all.end(), modes->modes);
  return cameraOf(camera).answers() ? DC1394_SUCCESS : noAnswer;
}

dc1394error_t dc1394_video_get_mode(dc1394camera_t *camera, dc1394video_mode_t *mode)
{
  *mode = cameraOf(camera).mode;
  return cameraOf(camera).answers() ? DC1394_SUCCESS : noAnswer;
}

dc1394error_t dc1394_video_set_mode(dc1394camera_t *camera, dc1394video_mode_t mode)
{
  SimulatedCamera &simulated = cameraOf(camera);
  if (!simulated.answers()) {
    return noAnswer;
  }
  simulated.mode = mode;
  log("mode " + std::to_string(mode - DC1394_VIDEO_MODE_MIN));
  return DC1394_SUCCESS;
}

dc1394error_t dc1394_video_get_supported_framerates(dc1394camera_t *camera, dc1394video_mode_t mode,
                                                    dc1394framerates_t *framerates)
{
  const std::vector<dc1394framerate_t> all = cameraOf(camera).framerates(mode);
  framerates->num = static_cast<std::uint32_t>(all.size());
  std::copy(all.begin(), all.end(), framerates->framerates);
  return DC1394_SUCCESS;
}

dc1394error_t dc1394_video_get_framerate(dc1394camera_t *camera, dc1394framerate_t *framerate)
{
  *framerate = cameraOf(camera).framerate;
  return cameraOf(camera).answers() ? DC1394_SUCCESS : noAnswer;
}

dc1394error_t dc1394_video_set_framerate(dc1394camera_t *camera, dc1394framerate_t framerate)
{
  cameraOf(camera).framerate = framerate;
  log("framerate " + std::to_string(framerate - DC1394_FRAMERATE_MIN));
  return cameraOf(camera).answers() ? DC1394_SUCCESS : noAnswer;
}

dc1394bool_t dc1394_is_video_mode_scalable(dc1394video_mode_t mode)
{
  return isFormat7(mode) ? DC1394_TRUE : DC1394_FALSE;
}

dc1394bool_t dc1394_is_video_mode_still_image(dc1394video_mode_t mode)
{
  return mode == DC1394_VIDEO_MODE_EXIF ? DC1394_TRUE : DC1394_FALSE;
}

dc1394error_t dc1394_get_image_size_from_video_mode(dc1394camera_t *camera, dc1394video_mode_t mode,
                                                    std::uint32_t *width, std::uint32_t *height)
{
  const SimulatedCamera &simulated = cameraOf(camera);
  const ModeLayout layout = layoutOf(mode);
  *width = isFormat7(mode) ? simulated.width : layout.width;
  *height = isFormat7(mode) ? simulated.height : layout.height;
  return simulated.answers() ? DC1394_SUCCESS : noAnswer;
}

dc1394error_t dc1394_get_color_coding_from_video_mode(dc1394camera_t *, dc1394video_mode_t mode,
                                                      dc1394color_coding_t *coding)
{
  *coding = layoutOf(mode).coding;
  return DC1394_SUCCESS;
}

dc1394error_t dc1394_format7_get_color_codings(dc1394camera_t *camera, dc1394video_mode_t,
                                               dc1394color_codings_t *codings)
{
  const std::vector<dc1394color_coding_t> all = cameraOf(camera).codings();
  codings->num = static_cast<std::uint32_t>(all.size());
  std::copy(all.begin(), all.end(), codings->codings);
  return DC1394_SUCCESS;
}

dc1394error_t dc1394_format7_get_color_coding(dc1394camera_t *camera, dc1394video_mode_t, dc1394color_coding_t *coding)
{
  *coding = cameraOf(camera).format7Coding;
  return DC1394_SUCCESS;
}

dc1394error_t dc1394_format7_set_color_coding(dc1394camera_t *camera, dc1394video_mode_t, dc1394color_coding_t coding)
{
  cameraOf(camera).format7Coding = coding;
  return DC1394_SUCCESS;
}

dc1394error_t dc1394_format7_get_max_image_size(dc1394camera_t *, dc1394video_mode_t mode, std::uint32_t *width,
                                                std::uint32_t *height)
{
  *width = layoutOf(mode).width;
  *height = layoutOf(mode).height;
  return DC1394_SUCCESS;
}

dc1394error_t dc1394_format7_get_image_size(dc1394camera_t *camera, dc1394video_mode_t, std::uint32_t *width,
                                            std::uint32_t *height)
{
  *width = cameraOf(camera).width;
  *height = cameraOf(camera).height;
  return DC1394_SUCCESS;
}

dc1394error_t dc1394_format7_set_roi(dc1394camera_t *camera, dc1394video_mode_t mode, dc1394color_coding_t,
                                     std::int32_t, std::int32_t left, std::int32_t top, std::int32_t width,
                                     std::int32_t height)
{
  SimulatedCamera &simulated = cameraOf(camera);
  const auto largestWidth = static_cast<std::int32_t>(layoutOf(mode).width);
  const auto largestHeight = static_cast<std::int32_t>(layoutOf(mode).height);
  width = width == DC1394_USE_MAX_AVAIL ? largestWidth - left : width;
  height = height == DC1394_USE_MAX_AVAIL ? largestHeight - top : height;
  constexpr std::int32_t step = 8; // pixels; real cameras have one as well
  const bool isInSteps = left % step == 0 && top % step == 0 && width % step == 0 && height % step == 0;
  if (!simulated.answers() || !isInSteps || left < 0 || top < 0 || left + width > largestWidth ||
      top + height > largestHeight) {
    return DC1394_FORMAT7_ERROR_FLAG_2;
  }
  simulated.left = static_cast<unsigned int>(left);
  simulated.top = static_cast<unsigned int>(top);
  simulated.width = static_cast<unsigned int>(width);
  simulated.height = static_cast<unsigned int>(height);
  return DC1394_SUCCESS;
}

dc1394error_t dc1394_feature_get(dc1394camera_t *camera, dc1394feature_info_t *info)
{
  const Feature *feature = featureOf(camera, info->id);
  info->available = feature != nullptr ? DC1394_TRUE : DC1394_FALSE;
  if (feature != nullptr) {
    info->value = feature->value;
    info->min = 0;
    info->max = feature->largest;
    dc1394_feature_get_modes(camera, info->id, &info->modes);
  }
  return cameraOf(camera).answers() ? DC1394_SUCCESS : noAnswer;
}

dc1394error_t dc1394_feature_get_all(dc1394camera_t *camera, dc1394featureset_t *)
{
  return cameraOf(camera).answers() ? DC1394_SUCCESS : noAnswer;
}

dc1394error_t dc1394_feature_print_all(dc1394featureset_t *, FILE *)
{
  return DC1394_SUCCESS;
}

dc1394error_t dc1394_feature_get_value(dc1394camera_t *camera, dc1394feature_t id, std::uint32_t *value)
{
  const Feature *feature = featureOf(camera, id);
  *value = feature != nullptr ? feature->value : 0;
  return cameraOf(camera).answers() ? DC1394_SUCCESS : noAnswer;
}

dc1394error_t dc1394_feature_set_value(dc1394camera_t *camera, dc1394feature_t id, std::uint32_t value)
{
  if (Feature *feature = featureOf(camera, id)) {
    feature->value = std::min(value, feature->largest);
    log("feature " + std::to_string(id - DC1394_FEATURE_MIN) + " = " + std::to_string(feature->value));
  }
  return cameraOf(camera).answers() ? DC1394_SUCCESS : noAnswer;
}

dc1394error_t dc1394_feature_get_modes(dc1394camera_t *camera, dc1394feature_t id, dc1394feature_modes_t *modes)
{
  modes->num = 0;
  if (featureOf(camera, id) != nullptr) {
    modes->num = 2;
    modes->modes[0] = DC1394_FEATURE_MODE_MANUAL;
    modes->modes[1] = DC1394_FEATURE_MODE_AUTO;
  }
  return cameraOf(camera).answers() ? DC1394_SUCCESS : noAnswer;
}

dc1394error_t dc1394_feature_get_mode(dc1394camera_t *camera, dc1394feature_t id, dc1394feature_mode_t *mode)
{
  const Feature *feature = featureOf(camera, id);
  *mode = feature != nullptr ? feature->mode : DC1394_FEATURE_MODE_MANUAL;
  return cameraOf(camera).answers() ? DC1394_SUCCESS : noAnswer;
}

dc1394error_t dc1394_feature_set_mode(dc1394camera_t *camera, dc1394feature_t id, dc1394feature_mode_t mode)
{
  if (Feature *feature = featureOf(camera, id)) {
    feature->mode = mode;
    log("feature " + std::to_string(id - DC1394_FEATURE_MIN) +
        (mode == DC1394_FEATURE_MODE_AUTO ? " automatic" : " by hand"));
  }
  return cameraOf(camera).answers() ? DC1394_SUCCESS : noAnswer;
}

dc1394error_t dc1394_feature_set_power(dc1394camera_t *camera, dc1394feature_t, dc1394switch_t)
{
  return cameraOf(camera).answers() ? DC1394_SUCCESS : noAnswer;
}

// AVT's own registers, which other makers' cameras do not have.
dc1394error_t dc1394_avt_get_auto_shutter(dc1394camera_t *, std::uint32_t *, std::uint32_t *)
{
  return DC1394_FAILURE;
}

dc1394error_t dc1394_avt_set_auto_shutter(dc1394camera_t *, std::uint32_t, std::uint32_t)
{
  return DC1394_FAILURE;
}

dc1394error_t dc1394_avt_get_auto_gain(dc1394camera_t *, std::uint32_t *, std::uint32_t *)
{
  return DC1394_FAILURE;
}

dc1394error_t dc1394_avt_set_auto_gain(dc1394camera_t *, std::uint32_t, std::uint32_t)
{
  return DC1394_FAILURE;
}
} // extern "C"
