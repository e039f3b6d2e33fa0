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

#include <filesystem>
#include <fstream>
#include <system_error>

#include <visp3/core/vpException.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
bool writeWhole(const std::string &filename, const std::string &text)
{
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path target = fs::weakly_canonical(filename, error); // through links, to replace what they point to
  const bool isDirect = error || (fs::exists(filename, error) && !fs::is_regular_file(filename, error));
  const fs::path place = isDirect ? fs::path(filename) : fs::path(target.string() + ".tmp");
  std::ofstream file(place, std::ios::binary);
  file << text;
  file.close();
  bool isWritten = static_cast<bool>(file);
  if (!isDirect) {
    if (isWritten) {
      fs::rename(place, target, error);
      isWritten = !error;
    }
    if (!isWritten) {
      fs::remove(place, error);
    }
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
