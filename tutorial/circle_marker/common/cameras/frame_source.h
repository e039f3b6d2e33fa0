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
 * Where live programs get their images from.
 */

#ifndef VP_TUTORIAL_FRAME_SOURCE_H
#define VP_TUTORIAL_FRAME_SOURCE_H

#include <chrono>
#include <optional>
#include <stdexcept>
#include <string>

#include <visp3/core/vpImage.h>

#include "../visp_names.h"

namespace tutorial {
/*! An image and where it is from. */
struct Frame
{
  vpImage<unsigned char> image;
  std::string name;           //!< The source's name, "#" and the number; the path of an image from a file.
  long number = 0;            //!< Counted by the source from 0, damaged images as well.
  std::optional<double> time; //!< When it was taken, Unix time, seconds; nothing if it is not known.
  //! When it came here.
  std::chrono::steady_clock::time_point arrival = std::chrono::steady_clock::now();
  unsigned int missed = 0; //!< Images that the camera has taken before this one, and that never arrived.
};

/*! The camera cannot be used, or no longer; the text says what to do. */
class SourceError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/*! An image arrived damaged; the next one may be good. */
class DamagedFrame : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/*! Part of the camera's whole image that the images show, pixels; empty: all of it. */
struct ImageRegion
{
  unsigned int left = 0;
  unsigned int top = 0;
  unsigned int width = 0;
  unsigned int height = 0;
};

/*!
  Images one after the other: a camera, or a recording.
*/
class FrameSource
{
public:
  virtual ~FrameSource() = default;

  /*!
    Waits for the next image.
    \return The image, nothing after the last.
    \exception DamagedFrame : If an image cannot be used; to be called again.
    \exception SourceError : If there will be no more images.
  */
  virtual std::optional<Frame> next() = 0;

  /*! \return Whether images are lost when they are not asked for. */
  virtual bool isLive() const = 0;

  /*! \return The region of the camera's whole image. */
  virtual ImageRegion region() const { return ImageRegion{}; }
};

/*! \return Unix time, seconds. */
inline double unixSeconds()
{
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}
} // namespace tutorial

#endif
