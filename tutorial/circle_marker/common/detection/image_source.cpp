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
#include <cctype>
#include <filesystem>
#include <fstream>
#include <limits>
#include <utility>
#include <vector>

#include <visp3/core/vpException.h>
#include <visp3/io/vpImageIo.h>
#include <visp3/io/vpVideoReader.h>

#include "../arguments.h"
#include "../camera_file.h"
#include "../numbered_name.h"

namespace fs = std::filesystem;

namespace tutorial {
namespace {
/*! Name of an image and its number. */
using Entry = std::pair<std::string, long>;

std::string extensionOf(const std::string &path)
{
  std::string extension = fs::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return extension;
}

bool isVideo(const std::string &path)
{
  const std::string extensions[] = {".avi", ".mpg", ".mpeg", ".mp4", ".m4v", ".mts",
                                    ".mov", ".mkv", ".wmv",  ".flv", ".ogv", ".webm"};
  return std::find(std::begin(extensions), std::end(extensions), extensionOf(path)) != std::end(extensions);
}

// Whether the mark of its end is there: of a JPEG file that is cut off OpenCV reads what there is, and goes on in grey.
bool endsAsJpeg(const std::string &path)
{
  constexpr std::streamoff atEnd = 4096; // bytes: cameras write a few after the mark
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = file.tellg();
  std::string end(static_cast<std::size_t>(std::clamp<std::streamoff>(size, 0, atEnd)), '\0');
  file.seekg(std::max<std::streamoff>(size - atEnd, 0));
  file.read(end.data(), static_cast<std::streamsize>(end.size()));
  return end.find("\xff\xd9") != std::string::npos;
}

vpImage<unsigned char> readImage(const std::string &path)
{
  vpImage<unsigned char> image;
  const std::string extension = extensionOf(path);
  // libjpeg, ViSP's own choice for these, ends the program when a file is damaged.
  const bool isJpeg = extension == ".jpg" || extension == ".jpeg";
  if (extension.empty()) {
    throw vpException(vpException::ioError, "its name has no extension that tells what it is, such as .png");
  }
  if (isJpeg && !endsAsJpeg(path)) {
    throw vpException(vpException::ioError, "the file is cut off");
  }
  vpImageIo::read(image, path, isJpeg ? vpImageIo::IO_OPENCV_BACKEND : vpImageIo::IO_DEFAULT_BACKEND);
  if (image.getSize() == 0) {
    throw vpException(vpException::ioError, "it holds no image");
  }
  return image;
}

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
      if (!fs::is_regular_file(entry.first)) {
        throw vpException(vpException::ioError, "there is no such file");
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

/*! Frames of a video, numbered from 0. */
class VideoSource : public ImageSource
{
public:
  VideoSource(const std::string &path, long first, long last) : m_path(path), m_first(first), m_last(last)
  {
    m_reader.setFileName(path);
    vpImage<unsigned char> image;
    m_reader.open(image);
    m_frames = m_reader.getLastFrameIndex() - m_reader.getFirstFrameIndex() + 1;
  }

  std::optional<SourceImage> next() override
  {
    // Frames are decoded in order: videos do not seek exactly.
    for (; m_next <= m_last && (m_next < m_frames || m_next == 0); ++m_next) {
      SourceImage result{m_path + "#" + std::to_string(m_next), m_next, vpImage<unsigned char>(), ""};
      try {
        const SilentStream silentErrors(std::cerr), silentOutput(std::cout); // the reader warns there
        m_reader.acquire(*result.image);
      }
      catch (const std::exception &e) {
        // What comes after a frame that the reader does not get over cannot be reached either.
        m_last = -1;
        result.image.reset();
        result.problem = e.what();
        return result;
      }
      if (m_next >= m_first) {
        ++m_next;
        if (result.image->getSize() == 0) {
          result.image.reset();
          result.problem = "the frame cannot be decoded";
        }
        return result;
      }
    }
    if (m_first >= m_frames && m_last >= 0) { // said once
      m_last = -1;
      return SourceImage{m_path + "#" + std::to_string(m_first), m_first, std::nullopt,
                         "the video has " + std::to_string(m_frames) + " frames, from 0"};
    }
    return std::nullopt;
  }

  std::size_t size() const override
  {
    return static_cast<std::size_t>(std::max(0L, std::min(m_last, m_frames - 1) - m_first + 1));
  }

private:
  std::string m_path;     //!< Path of the video.
  long m_first;           //!< First frame that is wanted.
  long m_last;            //!< Last frame that is wanted.
  long m_next = 0;        //!< Frame that is decoded next.
  long m_frames = 0;      //!< Number of frames.
  vpVideoReader m_reader; //!< Decodes it.
};

std::vector<Entry> numberedFiles(const std::string &input, const NumberedName &pattern, std::optional<long> first,
                                 std::optional<long> last)
{
  std::vector<Entry> entries;
  if (first && last) {
    for (long number = *first; number <= *last; ++number) {
      entries.emplace_back(pattern(number), number);
    }
    return entries;
  }
  const fs::path folder = fs::path(input).parent_path();
  std::error_code error;
  for (const fs::directory_entry &file : fs::directory_iterator(folder.empty() ? "." : folder, error)) {
    const std::string path = (folder / file.path().filename()).string();
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
    throw vpException(vpException::ioError, "there is no file \"%s\"", input.c_str());
  }
  if (isVideo(input)) {
    return std::make_unique<VideoSource>(input, first.value_or(0), last.value_or(std::numeric_limits<long>::max()));
  }
  refuseNumbers("an image");
  return std::make_unique<FileSource>(std::vector<Entry>{{input, 0}});
}
} // namespace tutorial
