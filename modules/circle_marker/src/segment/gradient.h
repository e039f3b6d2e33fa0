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
 * Image gradient with a threshold that follows the image noise.
 */

#ifndef VP_CIRCLE_MARKER_GRADIENT_H
#define VP_CIRCLE_MARKER_GRADIENT_H

#include <cstddef>
#include <cstdint>
#include <vector>

#include <visp3/circle_marker/vpConfigCircleMarker.h>
#include <visp3/core/vpImage.h>

#include "segment/image_noise.h"
#include "support/deadline.h"
#include "support/workers.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Edge chains start in every second row, from the second on: whatever bends enough to be a piece of an ellipse crosses
  some of them, and the search for starts is half as long.
*/
constexpr int rowsBetweenStarts = 2;
constexpr int firstStartRow = 1;

/*! Sobel gradient of a sharp step of one grey level. */
constexpr double sobelStepGain = 4.;

/*! Gradient at a pixel. */
struct GradientVector
{
  short dx; //!< Derivative along u.
  short dy; //!< Derivative along v.

  int squared() const { return dx * dx + dy * dy; }
};

/*!
  Sobel gradient of an image (3 x 3, unnormalised: a step of s grey levels gives up to 4 s) and the magnitudes from
  which a pixel counts as an edge. The gradient points to the brighter side; it is zero along the image's border.
*/
struct Gradient
{
  int width = 0;                       //!< Pixels.
  int height = 0;                      //!< Pixels.
  std::vector<GradientVector> vectors; //!< Row by row.
  std::vector<std::uint8_t>
      strong;            //!< Of the rows where chains start: 1 where dx or dy may start a chain, otherwise 0.
  ImageNoise noise;      //!< Of the image.
  int startAt = 0;       //!< An edge chain starts at a pixel whose gradient magnitude is at least this.
  int continueAbove = 0; //!< An edge chain goes on over pixels whose gradient magnitude is at least this.

  std::size_t index(int x, int y) const
  {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }

  /*! Where Gradient::strong has a row in which chains start. */
  std::size_t strongIndex(int y) const
  {
    return static_cast<std::size_t>(y / rowsBetweenStarts) * static_cast<std::size_t>(width);
  }

  const GradientVector &at(int x, int y) const { return vectors[index(x, y)]; }

  int squaredMagnitude(int x, int y) const { return at(x, y).squared(); }
};

/*! Where the noise of an image is known from. */
enum class NoiseSource
{
  IMAGE, //!< It is estimated.
  KNOWN  //!< Gradient::noise has it already: a region of an image is too small to tell.
};

/*!
  Fills \e gradient from \e I. Its memory is used again from call to call. What is not done by the deadline is zero.
*/
void computeGradient(const vpImage<unsigned char> &I, Gradient &gradient, const Deadline &deadline = Deadline(),
                     NoiseSource noise = NoiseSource::IMAGE);

/*! The same, its rows shared among threads. */
void computeGradient(const vpImage<unsigned char> &I, Gradient &gradient, Workers &workers, const Deadline &deadline,
                     NoiseSource noise);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
