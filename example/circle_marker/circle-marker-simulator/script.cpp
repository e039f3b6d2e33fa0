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
 * Events for the simulator: from a script.
 */

#include "script.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "controls.h"

namespace simulator {
namespace {
constexpr unsigned int mostImages = 100000; // more is a mistake

ScriptEvent eventOf(const std::string &line)
{
  std::istringstream in(line);
  std::string word, rest;
  ScriptEvent event;
  bool isGood = false;
  in >> word;
  if (word == "key") {
    std::string key;
    event.kind = ScriptEvent::Kind::Key;
    isGood = static_cast<bool>(in >> key) && (key.size() == 1 || key == "Escape");
    event.key = key == "Escape" ? '\x1b' : (key.empty() ? ' ' : key[0]);
    Controls unused;
    if (isGood && !pressKey(unused, event.key)) {
      throw std::runtime_error("the key \"" + key + "\" means nothing; --help lists the keys");
    }
    if (!(in >> event.count)) {
      in.clear();
      event.count = 1;
    }
  }
  else if (word == "drag") {
    event.kind = ScriptEvent::Kind::Drag;
    isGood = static_cast<bool>(in >> event.button >> event.du >> event.dv) && (event.button == 1 || event.button == 2);
  }
  else if (word == "wait") {
    event.kind = ScriptEvent::Kind::Wait;
    isGood = static_cast<bool>(in >> event.count);
  }
  else if (word == "shot") {
    event.kind = ScriptEvent::Kind::Shot;
    isGood = static_cast<bool>(in >> event.file);
  }
  if (!isGood || in >> rest || event.count > mostImages) {
    throw std::runtime_error("\"" + line + "\" is none of: key w, key N 5, drag 1 120 -40, wait 10, shot name.png");
  }
  return event;
}
} // namespace

std::vector<ScriptEvent> readScript(const std::string &file)
{
  std::ifstream in(file);
  if (!in) {
    throw std::runtime_error("the script \"" + file + "\" cannot be read; is it there?");
  }
  std::vector<ScriptEvent> events;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    line = line.substr(0, line.find('#'));
    const std::size_t last = line.find_last_not_of(" \t\r");
    if (last == std::string::npos) {
      continue;
    }
    try {
      events.push_back(eventOf(line.substr(0, last + 1)));
    }
    catch (const std::exception &e) {
      throw std::runtime_error("the script \"" + file + "\", line " + std::to_string(number) + ": " + e.what());
    }
  }
  return events;
}
} // namespace simulator
