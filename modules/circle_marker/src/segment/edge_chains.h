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
 * Chains of edge pixels that follow the ridges of the gradient.
 */

#ifndef VP_CIRCLE_MARKER_EDGE_CHAINS_H
#define VP_CIRCLE_MARKER_EDGE_CHAINS_H

#include <cstddef>
#include <cstdint>
#include <vector>

#include "segment/gradient.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! A pixel of an edge. */
struct EdgePixel
{
  short x;
  short y;
};

/*! A run of EdgeChains::pixels, walked with the bright side on the left of the walker as the image is seen. */
struct EdgeChain
{
  std::size_t begin = 0; //!< Index of the first pixel.
  std::size_t end = 0;   //!< Index after the last pixel.
  bool closed = false;   //!< Whether the last pixel neighbours the first.

  std::size_t length() const { return end - begin; }
};

/*! All edge chains of an image; its memory is used again from image to image. */
struct EdgeChains
{
  std::vector<EdgePixel> pixels;
  std::vector<EdgeChain> chains;
  std::vector<std::uint8_t> visited; //!< One per image pixel: 0, or how a chain has passed there.
};

/*!
  Links edge pixels into oriented chains: from each local maximum of the gradient the walk goes on to the strongest of
  the three neighbours ahead along the edge (the routing of Edge Drawing: Topal & Akinlar, 2012), as long as the
  gradient keeps its direction and strength. Both edges of a thin dark line make a chain of their own, since their
  gradients oppose.
  \param gradient : Gradient of the image.
  \param shortest : Chains of fewer pixels are dropped.
  \param result : The chains.
  \param deadline : When to stop; what is linked by then is kept.
*/
void linkEdgeChains(const Gradient &gradient, std::size_t shortest, EdgeChains &result,
                    const Deadline &deadline = Deadline());

/*!
  Twice the signed area that a chain of pixels (closed by its chord) encloses, square pixels: positive if it runs
  clockwise as the image is seen, which is the outline of something dark.
*/
std::int64_t doubledArea(const EdgeChains &edges, const EdgeChain &chain);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
