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
 * Images of a file, a numbered sequence, a list or a video, one after the other.
 */

#include "image_source.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <utility>
#include <vector>

#include <visp3/core/vpException.h>

#include "../arguments.h"
#include "../numbered_name.h"
#include "image_file.h"
#include "video_source.h"

namespace fs = std::filesystem;

namespace tutorial {
namespace {
/*! Name of an image and its number. */
using Entry = std::pair<std::string, long>;

/*! Image files. */
class FileSource : public ImageSource
{
public:
  explicit FileSource(std::vector<Entry> entries) : m_entries(std::move(entries)) {}

  std::optional<SourceImage> next() override
  {
    if (m_next == m_entries.size()) {
      return std::nullopt;
    }
    const Entry &entry = m_entries[m_next++];
    SourceImage result{entry.first, entry.second, std::nullopt, ""};
    try {
      if (fs::is_directory(entry.first)) {
        throw vpException(vpException::ioError,
                          "it is a folder; give the images in it with a number in their name, folder/image-%%04d.png");
      }
      if (!fs::is_regular_file(entry.first)) {
        throw vpException(vpException::ioError,
                          "there is no such file; check the path, which starts from the folder the program runs in");
      }
      result.image = readImage(entry.first);
    }
    catch (const std::exception &e) {
      result.problem = e.what();
    }
    return result;
  }

  std::size_t size() const override { return m_entries.size(); }

private:
  std::vector<Entry> m_entries; //!< The files.
  std::size_t m_next = 0;       //!< Which is next.
};

std::vector<Entry> numberedFiles(const std::string &input, const NumberedName &pattern, std::optional<long> first,
                                 std::optional<long> last)
{
  std::vector<Entry> entries;
  if (first && last) {
    constexpr long mostFiles = 10000000; // names in memory: a gigabyte
    if (*last - *first >= mostFiles) {
      throw vpException(vpException::badValue, "--first %ld to --last %ld are more than %ld images; take them in parts",
                        *first, *last, mostFiles);
    }
    for (long number = *first; number <= *last; ++number) {
      entries.emplace_back(pattern(number), number);
    }
    return entries;
  }
  // As it is written, with two slashes perhaps: names are compared with the pattern.
  const std::string name = pattern(0);
  const std::string folder = name.substr(0, name.find_last_of('/') + 1);
  std::error_code error;
  for (const fs::directory_entry &file : fs::directory_iterator(folder.empty() ? "./" : folder, error)) {
    const std::string path = folder + file.path().filename().string();
    const std::optional<long> number = pattern.numberOf(path);
    if (number && (!first || *number >= *first) && (!last || *number <= *last)) {
      entries.emplace_back(path, *number);
    }
  }
  std::sort(entries.begin(), entries.end(), [](const Entry &a, const Entry &b) { return a.second < b.second; });
  if (entries.empty()) {
    throw vpException(vpException::ioError, "no file is named like \"%s\"; check the folder, --first and --last",
                      input.c_str());
  }
  return entries;
}

std::vector<Entry> listedFiles(const std::string &list)
{
  std::ifstream file(list);
  if (!file) {
    throw vpException(vpException::ioError, "the list \"%s\" cannot be read; it must have a path on each line",
                      list.c_str());
  }
  std::vector<Entry> entries;
  std::string line;
  while (std::getline(file, line)) {
    line.erase(line.find_last_not_of(" \t\r") + 1);
    if (line.empty()) {
      continue;
    }
    const fs::path besideList = fs::path(list).parent_path() / line;
    const bool isThere = fs::exists(line) || !fs::exists(besideList);
    entries.emplace_back(isThere ? line : besideList.string(), static_cast<long>(entries.size()));
  }
  if (entries.empty()) {
    throw vpException(vpException::ioError, "the list \"%s\" is empty; it must have a path on each line", list.c_str());
  }
  return entries;
}
} // namespace

std::unique_ptr<ImageSource> openSource(const std::string &input, std::optional<long> first, std::optional<long> last)
{
  const auto refuseNumbers = [&](const std::string &what) {
    if (first || last) {
      throw UsageError("--first and --last choose from a pattern or a video; " + what + " takes neither");
    }
  };
  if (!input.empty() && input.front() == '@') {
    refuseNumbers("a list");
    return std::make_unique<FileSource>(listedFiles(input.substr(1)));
  }
  const std::optional<NumberedName> pattern = NumberedName::parse(input);
  if (pattern && !fs::exists(input)) {
    return std::make_unique<FileSource>(numberedFiles(input, *pattern, first, last));
  }
  if (!fs::exists(input)) {
    throw vpException(vpException::ioError,
                      "there is no file \"%s\"; check the path, which starts from the folder the program runs in",
                      input.c_str());
  }
  if (isVideo(input)) {
    return openVideo(input, first, last);
  }
  refuseNumbers("an image");
  return std::make_unique<FileSource>(std::vector<Entry>{{input, 0}});
}
} // namespace tutorial
