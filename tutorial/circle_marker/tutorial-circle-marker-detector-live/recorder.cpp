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
 * Records images while the program goes on.
 */

#include "recorder.h"

#include <filesystem>

#include <visp3/core/vpException.h>
#include <visp3/io/vpImageIo.h>

#include "../common/whole_file.h"

namespace fs = std::filesystem;

namespace tutorial {
namespace {
// Images of 1.2 MB that wait for the disk, two seconds at 15 images a second.
constexpr std::size_t mostWaiting = 30;
} // namespace

Recorder::Recorder(const std::string &pattern)
    : m_name(*NumberedName::parse(pattern)), m_poses((fs::path(pattern).parent_path() / "poses.jsonl").string())
{
  makeFolder(fs::path(pattern).parent_path(), "--record");
  if (fs::exists(m_name(0)) || fs::exists(m_poses)) {
    throw vpException(vpException::ioError, "\"%s\" is there already; record into an empty folder",
                      fs::exists(m_poses) ? m_poses.c_str() : m_name(0).c_str());
  }
  m_thread = std::thread([this] { write(); });
}

Recorder::~Recorder()
{
  try {
    finish();
  }
  catch (const std::exception &) {
    // Who wants to know has called finish().
  }
}

void Recorder::record(const vpImage<unsigned char> &image, const std::string &line)
{
  std::unique_lock<std::mutex> lock(m_mutex);
  m_changed.wait(lock, [this] { return m_waiting.size() < mostWaiting || !m_problem.empty(); });
  if (!m_problem.empty()) {
    throw vpException(vpException::ioError, m_problem);
  }
  m_waiting.emplace_back(m_name(m_number), image);
  m_lines.push_back(line);
  ++m_number;
  m_changed.notify_all();
}

void Recorder::write()
{
  std::unique_lock<std::mutex> lock(m_mutex);
  while (true) {
    m_changed.wait(lock, [this] { return !m_waiting.empty() || m_isEnd; });
    if (m_waiting.empty() || !m_problem.empty()) {
      return;
    }
    // Kept in the queue while it is written: the queue's length is what record() waits for.
    const std::pair<std::string, vpImage<unsigned char>> &next = m_waiting.front();
    lock.unlock();
    std::string problem;
    try {
      writeWhole(next.first, [&next](const std::string &temporary) { vpImageIo::write(next.second, temporary); });
    }
    catch (const std::exception &e) {
      problem = e.what();
    }
    lock.lock();
    m_waiting.pop_front();
    m_problem = problem;
    m_written += problem.empty() ? 1 : 0;
    m_changed.notify_all();
  }
}

void Recorder::finish()
{
  if (!m_thread.joinable()) {
    return;
  }
  {
    const std::lock_guard<std::mutex> lock(m_mutex);
    m_isEnd = true;
    m_changed.notify_all();
  }
  m_thread.join();
  // The lines of the images that are there, also if the disk was full then.
  std::string lines;
  for (std::size_t k = 0; k < m_written; ++k) {
    lines += m_lines[k] + "\n";
  }
  if (!lines.empty()) {
    writeWholeText(m_poses, lines);
  }
  if (!m_problem.empty()) {
    throw vpException(vpException::ioError, m_problem);
  }
}
} // namespace tutorial
