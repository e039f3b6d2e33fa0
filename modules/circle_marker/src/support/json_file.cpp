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
 * What all files of settings and markers have in common, whatever is in them.
 */

#include "support/json_file.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <system_error>

#include <visp3/core/vpException.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
namespace fs = std::filesystem;

// A name beside the file that is nobody's: fopen's x refuses one that is there.
fs::path createBeside(const fs::path &target)
{
  constexpr int mostAttempts = 10;
  std::random_device number;
  for (int i = 0; i < mostAttempts; ++i) {
    const fs::path place = target.string() + ".part" + std::to_string(number());
    if (std::FILE *const file = std::fopen(place.string().c_str(), "wbx")) {
      std::fclose(file);
      return place;
    }
  }
  return fs::path();
}

bool write(const fs::path &place, const std::string &text)
{
  std::ofstream file(place, std::ios::binary);
  file << text;
  file.close();
  return static_cast<bool>(file);
}
} // namespace

std::optional<std::string> readWhole(const std::string &filename)
{
  std::error_code error;
  std::ifstream file(filename, std::ios::binary);
  if (!file || fs::is_directory(filename, error)) { // a folder can be opened
    return std::nullopt;
  }
  return std::string(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
}

bool writeWhole(const std::string &filename, const std::string &text)
{
  std::error_code error;
  const fs::path target = fs::weakly_canonical(filename, error); // through links, to replace what they point to
  if (error || (fs::exists(filename, error) && !fs::is_regular_file(filename, error))) {
    return write(filename, text);
  }
  const fs::path place = createBeside(target);
  if (place.empty()) {
    return false;
  }
  bool isWritten = write(place, text);
  if (isWritten) {
    const fs::file_status replaced = fs::status(target, error);
    if (fs::exists(replaced)) { // a file that its owner alone may read stays one
      fs::permissions(place, replaced.permissions(), error);
    }
    fs::rename(place, target, error);
    isWritten = !error;
  }
  if (!isWritten) {
    fs::remove(place, error);
  }
  return isWritten;
}

void refuseWithoutJson(const std::string &action, const std::string &filename)
{
  throw vpException(vpException::functionNotImplementedError,
                    "cannot %s \"%s\": this build is without nlohmann-json; install it and build again", action.c_str(),
                    filename.c_str());
}
} // namespace circle_marker
END_VISP_NAMESPACE
