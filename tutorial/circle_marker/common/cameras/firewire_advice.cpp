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
 * Why there is no FireWire camera.
 */

#include <fstream>
#include <vector>

#include <unistd.h>

#include "firewire_camera.h"

namespace fs = std::filesystem;

namespace tutorial {
namespace {
constexpr const char *rightsAdvice =
    "give yourself the right: copy data/udev/60-circle-marker-cameras.rules of this project to /etc/udev/rules.d, run "
    "\"udevadm control --reload && udevadm trigger\" as root and plug the camera in again; or join the group video "
    "(\"adduser <you> video\" as root) and log in again";

/*! What a file of one line says. */
std::string lineOf(const fs::path &file)
{
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  return line;
}

/*! Device files of FireWire nodes; the computer's own controller has one as well. */
std::vector<fs::path> fireWireNodes(const fs::path &root)
{
  std::vector<fs::path> nodes;
  std::error_code error;
  for (const fs::directory_entry &entry : fs::directory_iterator(root / "dev", error)) {
    const std::string name = entry.path().filename().string();
    if (name.size() > 2 && name.compare(0, 2, "fw") == 0 && name.find_first_not_of("0123456789", 2) == name.npos) {
      nodes.push_back(entry.path());
    }
  }
  return nodes;
}

/*! Whether a USB camera of Point Grey (vendor 1e10) is plugged in. */
bool hasPointGreyUsb(const fs::path &root)
{
  std::error_code error;
  for (const fs::directory_entry &entry : fs::directory_iterator(root / "sys/bus/usb/devices", error)) {
    if (lineOf(entry.path() / "idVendor") == "1e10") {
      return true;
    }
  }
  return false;
}
} // namespace

std::string fireWireAdvice(const fs::path &root)
{
  const std::vector<fs::path> nodes = fireWireNodes(root);
  for (const fs::path &node : nodes) {
    if (access(node.c_str(), R_OK | W_OK) != 0) {
      return node.string() + " is there, but you may not read and write it; " + rightsAdvice;
    }
  }
  if (hasPointGreyUsb(root)) {
    return std::string("a USB camera of Point Grey is plugged in, but cannot be opened; ") + rightsAdvice +
           ". USB 3 cameras of other series need the maker's own driver";
  }
  if (!nodes.empty()) {
    return "this computer has FireWire (" + nodes.front().string() +
           "), but no camera answers on it; check the cable and the camera's power, and unplug and plug it in again";
  }
  return "this computer has no FireWire device (/dev/fw*) and no USB camera of Point Grey (lsusb: 1e10). Plug the "
         "camera in; for FireWire, the computer needs an IEEE 1394 card and the kernel's driver (\"modprobe "
         "firewire-ohci\" as root); in a container or a virtual machine, pass the device on. Then, if the camera is "
         "still not found, " +
         std::string(rightsAdvice) +
         ". Other sources: --source v4l2, --source opencv, or a recording such as --source img%04d.png";
}
} // namespace tutorial
