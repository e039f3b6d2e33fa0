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
 * Outlines of markers at three scales of the image.
 */

#ifndef VP_CIRCLE_MARKER_OUTLINES_H
#define VP_CIRCLE_MARKER_OUTLINES_H

#include <array>

#include "ellipse/ellipse_candidates.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! Memory of findOutlines(), used again from image to image. */
struct OutlineMemory
{
  /*! One scale of the image on its way through the first rooms. */
  struct Scale
  {
    Gradient gradient;
    EdgeChains chains;
    EllipseMemory ellipses;
  };
  /*! A smaller scale, and the image there. */
  struct ReducedScale : Scale
  {
    vpImage<unsigned char> image;
    bool isUsed = false; //!< Whether it has room for a marker.
  };
  Scale full;
  std::array<ReducedScale, 2> reduced; //!< Half and quarter.

  /*! Sets whether the refusals of all scales are kept, to be shown. */
  void keepsRefusals(bool kept)
  {
    full.ellipses.keepsRefusals = kept;
    for (ReducedScale &scale : reduced) {
      scale.ellipses.keepsRefusals = kept;
    }
  }

  /*! Takes over the noise of all scales, for NoiseSource::KNOWN. */
  void takeNoise(const OutlineMemory &other)
  {
    full.gradient.noise = other.full.gradient.noise;
    for (std::size_t i = 0; i < reduced.size(); ++i) {
      reduced[i].gradient.noise = other.reduced[i].gradient.noise;
    }
  }
};

/*!
  Finds the outlines that may be markers: segment, edges and ellipse rooms, on the image, its half and its quarter.

  Edges of several pixels' width (blur, motion, enlarged or compressed pictures) break into pieces at full size and are
  sharp at half or at a quarter; thin rings are seen at full size only. An outline that several see is taken from the
  largest.
  \param I : The image.
  \param sought : What the markers have inside.
  \param workers : Threads; the result does not depend on their number.
  \param deadline : When to stop; what is found by then is kept.
  \param memory : Working memory.
  \param noise : Where the noise of all scales is known from.
  \return The outlines in pixels of \e I, largest first; they stay in \e memory.
*/
const ReusedList<EllipseCandidate> &findOutlines(const vpImage<unsigned char> &I, const SoughtCenters &sought,
                                                 Workers &workers, const Deadline &deadline, OutlineMemory &memory,
                                                 NoiseSource noise = NoiseSource::IMAGE);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
