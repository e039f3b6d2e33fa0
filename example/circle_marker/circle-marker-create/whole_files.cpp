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
 * Files that appear whole or not at all.
 */

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>
#include <system_error>

#include "whole_files.h"

namespace create {
namespace {
/*! A name in the same folder, hence on the same disk, that two programs running at once do not share. */
std::string temporaryName(const std::string &path)
{
  std::random_device random;
  return path + ".part" + std::to_string(random());
}
} // namespace

WholeFiles::~WholeFiles()
{
  for (const auto &file : m_files) {
    std::error_code ignored; // Nothing more can be done about a file that cannot be removed.
    std::filesystem::remove(file.first, ignored);
  }
}

void WholeFiles::add(const std::string &path, const std::string &content)
{
  if (std::filesystem::is_directory(path)) {
    throw std::runtime_error("cannot write \"" + path + "\": it is a folder; name a file");
  }
  const std::string temporary = temporaryName(path);
  errno = 0;
  std::ofstream file(temporary, std::ios::binary);
  if (file) {
    m_files.emplace_back(temporary, path);
    file.write(content.data(), static_cast<std::streamsize>(content.size()));
    file.close();
  }
  if (!file) {
    throw std::runtime_error("cannot write \"" + path + "\": " + std::strerror(errno) +
                             "; use a folder that exists, can be written and has room");
  }
}

void WholeFiles::commit()
{
  while (!m_files.empty()) {
    std::error_code error;
    std::filesystem::rename(m_files.back().first, m_files.back().second, error);
    if (error) {
      throw std::runtime_error("cannot write \"" + m_files.back().second + "\": " + error.message());
    }
    m_files.pop_back();
  }
}
} // namespace create
