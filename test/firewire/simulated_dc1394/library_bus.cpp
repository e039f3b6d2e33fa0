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
 * The C interface of libdc1394: bus, capture, video modes.
 */

#include <algorithm>
#include <cstdlib>
#include <map>
#include <mutex>

#include "library.h"

using namespace simulated_bus;

struct __dc1394_t
{
  int lists; //!< How often cameras were listed; as in libdc1394, a library that is not there ends the program.
};

namespace {
std::shared_ptr<SimulatedCamera> cameraWithGuid(std::uint64_t guid)
{
  static auto *const mutex = new std::mutex;
  static auto *const cameras = new std::map<std::uint64_t, std::shared_ptr<SimulatedCamera>>;
  const std::lock_guard<std::mutex> lock(*mutex);
  for (const CameraEntry &entry : scenario().cameras) {
    if (entry.guid == guid) {
      std::shared_ptr<SimulatedCamera> &camera = (*cameras)[guid];
      camera = camera ? camera : std::make_shared<SimulatedCamera>(entry);
      return camera;
    }
  }
  return nullptr;
}

std::string onOff(dc1394switch_t state)
{
  return state == DC1394_ON ? "on" : "off";
}
} // namespace

extern "C" {
dc1394_t *dc1394_new(void)
{
  return scenario().libraryFails ? nullptr : new dc1394_t{0};
}

void dc1394_free(dc1394_t *library)
{
  delete library;
}

dc1394error_t dc1394_log_register_handler(dc1394log_t, void (*)(dc1394log_t, const char *, void *), void *)
{
  return DC1394_SUCCESS;
}

dc1394error_t dc1394_camera_enumerate(dc1394_t *library, dc1394camera_list_t **list)
{
  ++library->lists;
  if (scenario().listFails) {
    return DC1394_FAILURE;
  }
  const std::vector<CameraEntry> &cameras = scenario().cameras;
  *list = static_cast<dc1394camera_list_t *>(std::calloc(1, sizeof(dc1394camera_list_t)));
  (*list)->num = static_cast<std::uint32_t>(cameras.size());
  (*list)->ids = static_cast<dc1394camera_id_t *>(
      std::calloc(std::max<std::size_t>(1, cameras.size()), sizeof(dc1394camera_id_t)));
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    (*list)->ids[i].guid = cameras[i].guid;
  }
  return DC1394_SUCCESS;
}

void dc1394_camera_free_list(dc1394camera_list_t *list)
{
  std::free(list->ids); // as libdc1394 2.2.6: a list that is not there ends the program
  std::free(list);
}

dc1394camera_t *dc1394_camera_new(dc1394_t *, std::uint64_t guid)
{
  const std::shared_ptr<SimulatedCamera> simulated = cameraWithGuid(guid);
  if (!simulated || scenario().openFails) {
    return nullptr;
  }
  auto *handle = new SimulatedHandle;
  handle->simulated = simulated;
  handle->vendor = simulated->entry.vendor;
  handle->model = simulated->entry.model;
  handle->camera.guid = guid;
  handle->camera.vendor = handle->vendor.data();
  handle->camera.model = handle->model.data();
  handle->camera.bmode_capable = DC1394_FALSE;
  return &handle->camera;
}

void dc1394_camera_free(dc1394camera_t *camera)
{
  delete reinterpret_cast<SimulatedHandle *>(camera);
}

dc1394error_t dc1394_camera_print_info(dc1394camera_t *camera, FILE *file)
{
  std::fprintf(file, "%s %s\n", camera->vendor, camera->model);
  return DC1394_SUCCESS;
}

dc1394error_t dc1394_camera_set_power(dc1394camera_t *camera, dc1394switch_t power)
{
  log("power " + onOff(power));
  return cameraOf(camera).answers() ? DC1394_SUCCESS : noAnswer;
}

dc1394error_t dc1394_reset_bus(dc1394camera_t *)
{
  log("bus reset");
  return DC1394_SUCCESS;
}

dc1394error_t dc1394_set_control_registers(dc1394camera_t *camera, std::uint64_t, const std::uint32_t *, std::uint32_t)
{
  return cameraOf(camera).answers() ? DC1394_SUCCESS : noAnswer;
}

dc1394error_t dc1394_capture_setup(dc1394camera_t *camera, std::uint32_t buffers, std::uint32_t)
{
  SimulatedCamera &simulated = cameraOf(camera);
  if (!simulated.answers()) {
    return noAnswer;
  }
  if (scenario().setupFails) {
    return DC1394_NO_BANDWIDTH;
  }
  simulated.setUp(buffers);
  log("capture set up with " + std::to_string(buffers) + " buffers");
  return DC1394_SUCCESS;
}

dc1394error_t dc1394_capture_stop(dc1394camera_t *camera)
{
  SimulatedCamera &simulated = cameraOf(camera);
  if (!simulated.isSetUp()) {
    return DC1394_CAPTURE_IS_NOT_SET;
  }
  simulated.tearDown();
  log("capture stopped");
  return DC1394_SUCCESS;
}

dc1394error_t dc1394_capture_dequeue(dc1394camera_t *camera, dc1394capture_policy_t, dc1394video_frame_t **frame)
{
  return cameraOf(camera).dequeue(*frame, camera);
}

dc1394error_t dc1394_capture_enqueue(dc1394camera_t *camera, dc1394video_frame_t *frame)
{
  cameraOf(camera).enqueue(frame);
  return DC1394_SUCCESS;
}

dc1394bool_t dc1394_capture_is_frame_corrupt(dc1394camera_t *camera, dc1394video_frame_t *frame)
{
  return cameraOf(camera).isCorrupt(frame) ? DC1394_TRUE : DC1394_FALSE;
}

dc1394error_t dc1394_video_get_transmission(dc1394camera_t *camera, dc1394switch_t *state)
{
  *state = cameraOf(camera).transmission;
  return cameraOf(camera).answers() ? DC1394_SUCCESS : noAnswer;
}

dc1394error_t dc1394_video_set_transmission(dc1394camera_t *camera, dc1394switch_t state)
{
  SimulatedCamera &simulated = cameraOf(camera);
  if (!simulated.answers()) {
    return noAnswer;
  }
  simulated.transmission = state;
  log("transmission " + onOff(state));
  return DC1394_SUCCESS;
}

dc1394error_t dc1394_video_get_iso_speed(dc1394camera_t *, dc1394speed_t *speed)
{
  *speed = DC1394_ISO_SPEED_400;
  return DC1394_SUCCESS;
}

dc1394error_t dc1394_video_set_iso_speed(dc1394camera_t *, dc1394speed_t)
{
  return DC1394_SUCCESS;
}

dc1394error_t dc1394_video_get_operation_mode(dc1394camera_t *, dc1394operation_mode_t *mode)
{
  *mode = DC1394_OPERATION_MODE_LEGACY;
  return DC1394_SUCCESS;
}

dc1394error_t dc1394_video_set_operation_mode(dc1394camera_t *, dc1394operation_mode_t)
{
  return DC1394_SUCCESS;
}
} // extern "C"
