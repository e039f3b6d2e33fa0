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
 * Darkness of strongly bent edges, integrated along lines.
 */

/*!
  \file line_model.h
  \brief Darkness of pixels where edges bend within the blur, or all of a marker lies within it: integrated along lines.

  A Gaussian blur is the product of one along the lines of a direction u and one across them. Along a line the print is
  black or white between crossings whose places are known without approximation, whatever the edges' bend: two of each
  circle, by a quadratic equation, and one of each border between sectors. So the share of black is a sum of the
  cumulative normal distribution at the crossings. Across the lines a sum over a few of them does: its terms are smooth,
  because u is chosen to cross edges steeply.

  It takes several times as long as ImageModel, whose edges are parabolas, and gives no derivatives: a fit uses it for
  the difference between both, which hardly depends on the pose.
*/

#ifndef VP_CIRCLE_MARKER_LINE_MODEL_H
#define VP_CIRCLE_MARKER_LINE_MODEL_H

#include <array>

#include "refine/pixel_blocks.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
/*! The print at a pose, seen along lines. */
class LineModel
{
public:
  LineModel(const MarkerPlane &plane, const MarkerPattern &pattern, const BlurParameters &blur,
            const ImageReference &reference);

  /*! Share of black that each pixel of a block sees. */
  Lanes darkness(const PixelBlock &block, PixelSight sight) const;

  /*!
    Whether parabolas are not enough for a pixel of the block: an edge that it may see bends by too much within the
    blur, or both sides of a circle are seen, or more borders between sectors than a block has.
  */
  bool isBent(const PixelBlock &block, PixelSight sight) const;

private:
  static constexpr std::size_t bordersOfCode = 31; // at most

  struct Line;
  struct Chord;
  struct Crossing;
  using Crossings = std::array<Crossing, bordersOfCode>; // with each of the borders

  float bendAt(const PlaneLanes &p) const;
  bool hasManyBorders(const PlaneLanes &p) const;
  Chord chordOf(const Line &line, float radius, const Lanes &growth) const;
  Lanes ringAlong(const Line &line) const;
  void crossBorders(const PlaneLanes &p, const Lanes &u, const Lanes &v, const Line &line, Crossings &crossings) const;
  Lanes trackAlong(const Line &line, const Crossings &crossings) const;

  // A border between a white and a black sector.
  struct Border
  {
    float alongX, alongY; // unit vector from the centre along the border
    float change;         // 1 if black follows in the sense of growing angles, -1 if white does
    bool isLower;         // whether its angle is between pi and 2 pi
  };

  PlaneHomography m_homography;
  std::array<float, 2> m_ring;  // radii of the ring's edges; 0 is no edge
  std::array<float, 2> m_track; // radii of the track's rims
  std::array<Border, bordersOfCode> m_borders;
  std::size_t m_borderCount = 0;
  float m_first = 0.f;       // 1 if the sector that ends at the full turn is black
  float m_sectorAngle = 0.f; // rad
  float m_perSigma, m_spread;
};

/*!
  Corrects blocks whose edges bend too much within the blur for the parabolas of ImageModel (PixelBlock::correction).
  \param plane, pattern, blur : The marker as it is known by now: the correction changes with it, but little.
  \param blocks : The pixels.
  \return Whether there are such blocks.
*/
bool correctBends(const MarkerPlane &plane, const MarkerPattern &pattern, const BlurParameters &blur,
                  PixelBlocks &blocks);
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
