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
 * An image from a file of any kind.
 */

#include "image_file.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>

#include <visp3/core/vpException.h>
#include <visp3/io/vpImageIo.h>

#ifdef CIRCLE_MARKER_HAVE_OPENCV_IMGCODECS
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <visp3/core/vpImageConvert.h>
#endif

namespace fs = std::filesystem;

namespace tutorial {
namespace {
/*! What a file holds, as its first bytes say. */
enum class Content
{
  JPEG,
  PNG,
  PNM,
  OTHER
};

Content contentOf(const std::string &path)
{
  std::string start(8, '\0');
  std::ifstream(path, std::ios::binary).read(start.data(), static_cast<std::streamsize>(start.size()));
  if (start.compare(0, 2, "\xff\xd8") == 0) {
    return Content::JPEG;
  }
  if (start.compare(1, 3, "PNG") == 0) {
    return Content::PNG;
  }
  return start[0] == 'P' && start[1] >= '1' && start[1] <= '6' ? Content::PNM : Content::OTHER;
}

// Whether an extension is that of a content; of what is not told by its first bytes any is.
bool isNamedSo(const std::string &extension, Content content)
{
  switch (content) {
  case Content::JPEG:
    return extension == ".jpg" || extension == ".jpeg";
  case Content::PNG:
    return extension == ".png";
  case Content::PNM:
    return extension == ".pgm" || extension == ".ppm";
  default:
    return !extension.empty();
  }
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

#ifdef CIRCLE_MARKER_HAVE_OPENCV_IMGCODECS
// By what the file holds, whatever its name is; empty if it cannot be read. Cameras that are held upright say so: the
// pixels stay where the camera's parameters have them.
vpImage<unsigned char> readByContent(const std::string &path)
{
  vpImage<unsigned char> image;
  const cv::Mat pixels = cv::imread(path, cv::IMREAD_GRAYSCALE | cv::IMREAD_IGNORE_ORIENTATION);
  if (!pixels.empty()) {
    vpImageConvert::convert(pixels, image);
  }
  return image;
}
#endif

// As its extension says. libjpeg, ViSP's own choice for JPEG, ends the program when a file is damaged.
vpImage<unsigned char> readByName(const std::string &path, bool isJpeg)
{
  vpImage<unsigned char> image;
  vpImageIo::read(image, path, isJpeg ? vpImageIo::IO_OPENCV_BACKEND : vpImageIo::IO_DEFAULT_BACKEND);
  return image;
}
} // namespace

std::string extensionOf(const std::string &path)
{
  std::string extension = fs::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return extension;
}

vpImage<unsigned char> readImage(const std::string &path)
{
  const Content content = contentOf(path);
  if (content == Content::JPEG && !endsAsJpeg(path)) {
    throw vpException(vpException::ioError, "the file is cut off; copy or write it again");
  }
  const std::string extension = extensionOf(path);
  const bool isNamed = isNamedSo(extension, content);
  vpImage<unsigned char> image;
#ifdef CIRCLE_MARKER_HAVE_OPENCV_IMGCODECS
  try {
    image = isNamed ? readByName(path, content == Content::JPEG) : readByContent(path);
  }
  catch (const vpException &e) {
    if (content != Content::PNM) { // that has text, or 16 bits, which ViSP does not read
      throw vpException(vpException::ioError, "%s; is the file whole? Copy or write it again", e.what());
    }
    image = readByContent(path);
  }
#else
  if (!isNamed) {
    throw vpException(vpException::ioError, "its name has no extension that tells what it is, such as .png");
  }
  image = readByName(path, content == Content::JPEG);
#endif
  if (image.getSize() == 0) {
    throw vpException(vpException::ioError, "it holds no image");
  }
  return image;
}
} // namespace tutorial
