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
 * The fitter with the lanes of this compilation.
 */

#ifndef VP_CIRCLE_MARKER_LANES_FITTER_H
#define VP_CIRCLE_MARKER_LANES_FITTER_H

#include "refine/fitter.h"
#include "refine/maximum_likelihood.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
/*! Fits poses by the functions of its own namespace. */
class LanesFitter : public Fitter
{
public:
  std::optional<FittedPose> fitPose(const std::vector<FitPixel> &pixels, const FitStart &start,
                                    const MarkerPattern &pattern, const FitSettings &settings) override
  {
    return CIRCLE_MARKER_LANES::fitPose(pixels, start, pattern, settings, m_memory);
  }

  double robustSquares(const std::vector<FitPixel> &pixels, const FittedPose &fit, const MarkerPattern &pattern,
                       const Photometry &surround, double noise, bool exactBends) override
  {
    return CIRCLE_MARKER_LANES::robustSquares(pixels, fit, pattern, surround, noise, exactBends, m_memory);
  }

  void explainPixels(const std::vector<FitPixel> &pixels, const FittedPose &fit, const MarkerPattern &pattern,
                     std::vector<ExplainedPixel> &explained) override
  {
    CIRCLE_MARKER_LANES::explainPixels(pixels, fit, pattern, m_memory, explained);
  }

private:
  FitMemory m_memory;
};
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
