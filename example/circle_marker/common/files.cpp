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
 * Files that appear whole or not at all, and gnuplot.
 */

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <stdexcept>
#include <system_error>

#include "files.h"

namespace common {
namespace {
namespace fs = std::filesystem;

/*! The end of the names of files that are not complete; two programs that run at once do not share it. */
std::string temporarySuffix()
{
  std::random_device random;
  return ".part" + std::to_string(random());
}

void removeQuietly(const fs::path &path)
{
  std::error_code ignored; // Nothing more can be done about a file that cannot be removed.
  fs::remove(path, ignored);
}

void giveFinalName(const fs::path &from, const fs::path &to)
{
  std::error_code error;
  fs::rename(from, to, error);
  if (error) {
    removeQuietly(from);
    throw std::runtime_error("cannot write \"" + to.string() + "\": " + error.message());
  }
}

/*! Takes all of a text's occurrences of a part away. */
void takeAway(const std::string &part, std::string &text)
{
  for (std::size_t place = text.find(part); place != std::string::npos; place = text.find(part, place)) {
    text.erase(place, part.size());
  }
}

/*!
  Takes away what gnuplot says too often: SVG's own defaults, and groups with nothing in them. Halves the files.
  \return Whether the file is whole, as it was drawn and as it is now.
*/
bool makeSmaller(const fs::path &svg)
{
  std::ifstream in(svg, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(in), {});
  in.close();
  for (const char *part : {" stroke-width=\"1.00\" stroke-linecap=\"butt\" stroke-linejoin=\"miter\"",
                           "<g fill=\"none\" color=\"black\" stroke=\"currentColor\">\n</g>\n",
                           "<g fill=\"none\" color=\"#FFFFFF\" stroke=\"currentColor\">\n</g>\n"}) {
    takeAway(part, text);
  }
  std::ofstream out(svg, std::ios::binary);
  out << text;
  out.close();
  return out && text.find("</svg>") != std::string::npos;
}

/*! A word that the shell takes as it is. */
std::string quoted(const std::string &word)
{
  std::string result = "'";
  for (const char letter : word) {
    result += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  }
  return result + "'";
}
} // namespace

void makeFolder(const std::string &folder)
{
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder)) {
    throw std::runtime_error("cannot make the folder \"" + folder + "\"" +
                             (error ? ": " + error.message() : std::string()) + "; name another one with --output");
  }
  const std::string name = "writable" + temporarySuffix();
  writeWhole(folder, name, "");
  removeQuietly(fs::path(folder) / name);
}

void writeWhole(const std::string &folder, const std::string &name, const std::string &content)
{
  const fs::path path = fs::path(folder) / name;
  const fs::path temporary = path.string() + temporarySuffix();
  errno = 0;
  std::ofstream file(temporary, std::ios::binary);
  file.write(content.data(), static_cast<std::streamsize>(content.size()));
  file.close();
  if (!file) {
    const std::string reason = std::strerror(errno);
    removeQuietly(temporary);
    throw std::runtime_error("cannot write \"" + path.string() + "\": " + reason +
                             "; use a folder that can be written and has room");
  }
  giveFinalName(temporary, path);
}

void drawPlots(const std::string &folder, const std::string &script, const std::vector<std::string> &plots)
{
  if (std::system("gnuplot --version > /dev/null 2>&1") != 0) {
    throw std::runtime_error("the plots are not drawn: gnuplot is missing; install it (Debian: gnuplot-nox), then call "
                             "gnuplot " +
                             script + " in " + folder);
  }
  const std::string suffix = temporarySuffix();
  const std::string command = "cd -- " + quoted(fs::absolute(folder).string()) + " && gnuplot -e " +
                              quoted("suffix='" + suffix + "'") + " " + quoted(script);
  const bool drawn = std::system(command.c_str()) == 0;
  std::string incomplete;
  for (const std::string &plot : plots) {
    const fs::path path = fs::path(folder) / plot;
    const fs::path temporary = path.string() + suffix;
    if (drawn && makeSmaller(temporary)) {
      giveFinalName(temporary, path);
    }
    else {
      incomplete += drawn ? "\"" + plot + "\" " : "";
      removeQuietly(temporary);
    }
  }
  if (!drawn) {
    throw std::runtime_error("the plots are not drawn: gnuplot failed; call gnuplot " + script + " in " + folder +
                             " to see why");
  }
  if (!incomplete.empty()) {
    throw std::runtime_error("the plots " + incomplete + "cannot be written whole to \"" + folder +
                             "\"; use a folder that has room");
  }
}
} // namespace common
