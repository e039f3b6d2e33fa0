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
 * Share of a pixel that may see what lies beyond the paper.
 */

/*!
  \file surround_share.h
  \brief Share of a pixel that may see what lies beyond the paper.
*/

#ifndef VP_CIRCLE_MARKER_SURROUND_SHARE_H
#define VP_CIRCLE_MARKER_SURROUND_SHARE_H

#include <algorithm>
#include <array>

#include "refine/surround.h"
#include "refine/tile_view.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
// A pixel that may see more than this share of what lies beyond the quiet zone is not used.
constexpr double mostSurround = 0.9;
// What a tile's pixels see to first order around its centre is off by less than this, pixels: at 70 degrees and a focal
// length of 600 pixels their place is by 0.1, in its corners, and how far a blur of 6 pixels reaches by 0.9. With a
// shorter one, or farther aslant, a pixel is passed over of which a share of 0.003 at most lies beyond the paper: at 75
// degrees, 300 pixels and such a blur.
constexpr double firstOrderError = 1.;
// Hypotheses that are served.
constexpr std::size_t mostHypotheses = 2;

/*! Completes pixels with what they see beyond the paper. */
class SurroundShare
{
public:
  SurroundShare(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane *planes,
                std::size_t count, const PaperEnds &papers, const BlurParameters &blur)
      : m_planes(planes), m_count(count), m_outermost(papers[0].extent), m_blur(blur.sigma), m_blurShape(blur.shape()),
        m_papers(papers), m_surrounds{{{I, camera, planes[0], papers[0], blur.widest()},
                                       {I, camera, planes[0], papers[1], blur.widest()}}}
  {
  }

  // Whether any pixel of the tile may see the surround.
  bool isNear() const { return m_isNear; }

  // Puts what a pixel (u, v) of such a tile sees; whether it sees enough of the marker. meter: where it is, exactly.
  bool complete(int u, int v, const Eigen::Vector2d &meter, FitPixel &pixel)
  {
    const ModelPixel model = {meter, pixel.meterPerPixel.cast<double>()};
    const Eigen::Vector2d fromMiddle = Eigen::Vector2d(u, v) - m_middle;
    for (std::size_t i = 0; i < m_count; ++i) {
      if (isClearlyInside(m_tiles[i], fromMiddle)) {
        continue;
      }
      const PlanePoint point = planePoint({model.meter, model.meterPerPixel * m_blurShape}, m_planes[i]);
      if (point.q.norm() < m_outermost - clearOfSurround * m_blur * point.byPixel.norm()) {
        continue;
      }
      for (std::size_t shape = 0; shape < paperShapes; ++shape) {
        const double share = shareBeyond(point, m_papers[shape], m_blur).share;
        if (share > mostSurround) {
          return false;
        }
        BeyondPaper &beyond = pixel.beyond[shape];
        if (share > std::max(static_cast<double>(beyond.share), leastSurround)) {
          const Ground &ground = m_surrounds[shape].toward(Surround::directionOf(point.q));
          beyond = {static_cast<float>(share), ground.grey, ground.spread};
        }
      }
    }
    return true;
  }

  // Goes to the tile around a pixel that the hypotheses look at.
  void enter(const Eigen::Vector2d &middle, const std::array<TileView, mostHypotheses> &hypotheses)
  {
    m_middle = middle;
    m_isNear = false;
    for (std::size_t i = 0; i < m_count; ++i) {
      const PlanePoint &point = hypotheses[i].center();
      const double reach = clearOfSurround * m_blur * (point.byPixel * m_blurShape).norm();
      m_isNear = m_isNear || point.q.norm() > m_outermost - reach - tileRadius * point.byPixel.norm();
      m_tiles[i] = {point.q, point.byPixel, m_outermost - reach - firstOrderError * point.byPixel.norm()};
    }
  }

private:
  // Where a tile's pixels lie on a hypothesis's plane, to first order around its centre.
  struct LinearTile
  {
    Eigen::Vector2d q;       // of the plane, in the centre
    Eigen::Matrix2d byPixel; // derivative of q with respect to the pixel
    double clear = 0.;       // at a smaller radius nothing is seen of what lies beyond the paper
  };

  // Most pixels of a tile that is near are: their exact place is not asked for.
  static bool isClearlyInside(const LinearTile &tile, const Eigen::Vector2d &fromMiddle)
  {
    return tile.clear > 0. && (tile.q + tile.byPixel * fromMiddle).squaredNorm() < tile.clear * tile.clear;
  }

  bool m_isNear = true;
  Eigen::Vector2d m_middle = Eigen::Vector2d::Zero(); // of the tile, pixels
  std::array<LinearTile, mostHypotheses> m_tiles;     // as each hypothesis sees it
  const MarkerPlane *m_planes;
  const std::size_t m_count;
  const double m_outermost;
  const double m_blur; // pixels, in the coordinates where it is round
  const Eigen::Matrix2d m_blurShape;
  const PaperEnds &m_papers;
  std::array<Surround, paperShapes> m_surrounds;
};
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
