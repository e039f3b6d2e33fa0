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
 * Files that appear whole or not at all, and their folders.
 */

#ifndef VP_TUTORIAL_WHOLE_FILE_H
#define VP_TUTORIAL_WHOLE_FILE_H

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <system_error>

#include <unistd.h>

#include <visp3/core/vpException.h>

#include "visp_names.h"

namespace tutorial {
/*!
  Writes a file beside its final name and gives it this name when it is complete; on an error nothing is left of it.
  What is no ordinary file, such as /dev/stdout, is written directly.

  \param path : Path of the file.
  \param write : Writes the file of the path it is given; the path has the extension of the final one.
  \exception vpException::ioError : If the file cannot be written.
*/
inline void writeWhole(const std::string &path, const std::function<void(const std::string &)> &write)
{
  namespace fs = std::filesystem;
  std::error_code error;
  const auto cannotWrite = [&path](const std::string &reason) {
    return vpException(vpException::ioError, "\"%s\" cannot be written (%s); is its folder there and writable?",
                       path.c_str(), reason.c_str());
  };
  if (fs::is_directory(path, error)) {
    throw cannotWrite("it is a folder");
  }
  if (fs::exists(path, error) && !fs::is_regular_file(path, error)) {
    try {
      write(path);
    }
    catch (const std::exception &e) {
      throw cannotWrite(e.what());
    }
    return;
  }
  const fs::path target = fs::weakly_canonical(path, error); // through links, to replace what they point to
  if (error) {
    throw cannotWrite(error.message());
  }
  const fs::path temporary = target.parent_path() / ("." + target.stem().string() + ".part" + std::to_string(getpid()) +
                                                     target.extension().string());
  try {
    write(temporary.string());
  }
  catch (const std::exception &e) {
    const fs::space_info disk = fs::space(target.parent_path(), error); // the writers of pictures do not tell why
    const bool isFull = !error && disk.available == 0;
    fs::remove(temporary, error);
    throw cannotWrite(isFull ? "the disk is full" : e.what());
  }
  fs::rename(temporary, target, error);
  if (error) {
    const std::string reason = error.message();
    fs::remove(temporary, error);
    throw cannotWrite(reason);
  }
}

/*!
  Makes a folder, and those it is in, unless it is there.
  \param folder : Its path; nothing is done if it is empty.
  \param option : Option of the command line that names another one.
  \exception vpException::ioError : If it cannot be made.
*/
inline void makeFolder(const std::filesystem::path &folder, const std::string &option)
{
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!folder.empty() && !std::filesystem::is_directory(folder, error)) {
    throw vpException(vpException::ioError, "the folder \"%s\" cannot be made; name another with %s",
                      folder.string().c_str(), option.c_str());
  }
}

/*!
  Finds out before the work that a file could not be written after it: for want of its folder, or of permission.
  \exception vpException::ioError : If so.
*/
inline void checkWritable(const std::string &path)
{
  namespace fs = std::filesystem;
  const fs::path folder = fs::path(path).has_parent_path() ? fs::path(path).parent_path() : fs::path(".");
  std::error_code error;
  const bool isFile = fs::exists(path, error);
  const bool isGood = isFile ? access(path.c_str(), W_OK) == 0 && !fs::is_directory(path, error)
                             : fs::is_directory(folder, error) && access(folder.c_str(), W_OK) == 0;
  if (!isGood) {
    throw vpException(vpException::ioError, "\"%s\" cannot be written; is its folder there and writable?",
                      path.c_str());
  }
}

/*!
  Writes a text file, whole or not at all.
  \exception vpException::ioError : If the file cannot be written.
*/
inline void writeWholeText(const std::string &path, const std::string &text)
{
  writeWhole(path, [&text](const std::string &temporary) {
    std::ofstream file(temporary, std::ios::binary);
    file << text;
    file.close();
    if (!file) {
      throw vpException(vpException::ioError, "writing failed");
    }
  });
}
} // namespace tutorial

#endif
