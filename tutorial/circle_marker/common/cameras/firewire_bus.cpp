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

#include "firewire_bus.h"

#ifdef CIRCLE_MARKER_HAVE_FIREWIRE
#include <iomanip>
#include <mutex>
#include <sstream>
#include <utility>

#include "firewire_camera.h"

namespace tutorial {
namespace {
/*! Takes what libdc1394 would write to the standard error, from whatever thread. */
struct Complaints
{
  std::mutex mutex;
  std::string text;
};

void keepComplaint(dc1394log_t, const char *message, void *user)
{
  Complaints &complaints = *static_cast<Complaints *>(user);
  const std::lock_guard<std::mutex> lock(complaints.mutex);
  constexpr std::size_t longest = 400; // characters; more of the same helps nobody
  if (complaints.text.size() < longest) {
    complaints.text += (complaints.text.empty() ? "" : "; ") + std::string(message);
    complaints.text.erase(complaints.text.find_last_not_of(" \r\n") + 1);
  }
}

/*! libdc1394 has one log for the whole program. It is never destroyed: threads may still complain at the end. */
Complaints &complaintsOfLibrary()
{
  static Complaints *const complaints = [] {
    auto *made = new Complaints;
    dc1394_log_register_handler(DC1394_LOG_ERROR, keepComplaint, made);
    dc1394_log_register_handler(DC1394_LOG_WARNING, keepComplaint, made);
    return made;
  }();
  return *complaints;
}

std::string inBrackets(const std::string &text)
{
  return text.empty() ? "" : " (libdc1394: " + text + ")";
}
} // namespace

std::string fireWireComplaints()
{
  Complaints &complaints = complaintsOfLibrary();
  const std::lock_guard<std::mutex> lock(complaints.mutex);
  return std::exchange(complaints.text, "");
}

FireWireHandle::FireWireHandle(std::shared_ptr<dc1394_t> library, std::uint64_t guid) : m_library(std::move(library))
{
  if (dc1394camera_t *camera = dc1394_camera_new(m_library.get(), guid)) {
    m_camera.reset(camera, dc1394_camera_free);
  }
}

bool FireWireHandle::answers() const
{
  dc1394switch_t status = DC1394_OFF;
  const bool isSuccess = dc1394_video_get_transmission(m_camera.get(), &status) == DC1394_SUCCESS;
  fireWireComplaints();
  return isSuccess;
}

dc1394feature_info_t FireWireHandle::info(dc1394feature_t feature) const
{
  dc1394feature_info_t result = {};
  result.id = feature;
  if (dc1394_feature_get(m_camera.get(), &result) != DC1394_SUCCESS) {
    result.available = DC1394_FALSE;
  }
  fireWireComplaints();
  return result;
}

bool FireWireHandle::canBeSet(dc1394feature_t feature) const
{
  const dc1394feature_info_t result = info(feature);
  bool hasManualMode = false;
  for (std::uint32_t i = 0; i < result.modes.num; ++i) {
    hasManualMode = hasManualMode || result.modes.modes[i] == DC1394_FEATURE_MODE_MANUAL;
  }
  return result.available == DC1394_TRUE && hasManualMode;
}

std::string FireWireHandle::rangeOf(dc1394feature_t feature) const
{
  const dc1394feature_info_t result = info(feature);
  return result.available == DC1394_TRUE ? std::to_string(result.min) + " to " + std::to_string(result.max) : "";
}

std::string FireWireHandle::model() const
{
  const auto textOf = [](const char *text) { return std::string(text != nullptr ? text : ""); };
  return textOf(m_camera->vendor) + " " + textOf(m_camera->model);
}

std::vector<FireWireHandle> fireWireCameras()
{
  fireWireComplaints();
  const std::shared_ptr<dc1394_t> library(dc1394_new(), [](dc1394_t *started) {
    if (started != nullptr) {
      dc1394_free(started);
    }
  });
  if (!library) {
    throw SourceError("libdc1394 cannot be started" + inBrackets(fireWireComplaints()) + ": " + fireWireAdvice());
  }
  dc1394camera_list_t *list = nullptr;
  if (dc1394_camera_enumerate(library.get(), &list) != DC1394_SUCCESS || list == nullptr) {
    throw SourceError("the FireWire cameras cannot be listed" + inBrackets(fireWireComplaints()) + ": " +
                      fireWireAdvice());
  }
  const std::shared_ptr<dc1394camera_list_t> owner(list, dc1394_camera_free_list);
  std::vector<FireWireHandle> cameras;
  for (std::uint32_t i = 0; i < list->num; ++i) {
    cameras.emplace_back(library, list->ids[i].guid);
    if (!cameras.back().isOpen()) {
      std::ostringstream message;
      message << "the camera 0x" << std::hex << std::setw(16) << std::setfill('0') << list->ids[i].guid
              << " cannot be opened" << inBrackets(fireWireComplaints())
              << "; ViSP's grabber needs all cameras: unplug it, or end the program that uses it";
      throw SourceError(message.str());
    }
  }
  return cameras;
}
} // namespace tutorial
#endif
