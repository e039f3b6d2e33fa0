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
 * What pixels see beyond the paper, as a function of the pose.
 */

/*!
  \file surround_model.h
  \brief What pixels see beyond the paper, as a function of the pose.

  On dark ground the paper's end is an edge as strong as the ring's, and a small marker's pixels see both. It moves with
  the pose that is sought: held where the pose was before, it holds the pose there. And it moves by how the sheet is cut
  (PaperPlacement), which is fitted as well: a sheet that is turned against its print would draw the pose along.
*/

#ifndef VP_CIRCLE_MARKER_SURROUND_MODEL_H
#define VP_CIRCLE_MARKER_SURROUND_MODEL_H

#include "refine/edge_motion.h"
#include "refine/grey_model.h"
#include "refine/surround_lanes.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
/*! The surround as the pixels see it at a pose. */
class SurroundModel
{
public:
  /*!
    \param plane : The pose.
    \param papers : Where the paper should end.
    \param photometry : Light, blur and how the paper is cut; has to outlive this.
    \param blocks : The pixels; have to outlive this.
    \param seesBend : Whether derivatives by the sheet's bend are wanted.
  */
  SurroundModel(const MarkerPlane &plane, const PaperEnds &papers, const Photometry &photometry,
                const PixelBlocks &blocks, bool seesBend = false)
      : m_papers(placedAt(papers, photometry.paper)), m_photometry(photometry), m_blocks(blocks),
        m_homography(plane, blocks.reference, photometry.blur.shape()), m_motion(motionAt(plane, seesBend))
  {
  }

  /*! What a block sees, until the next is asked for; nullptr if nothing. */
  const SurroundLanes *at(const PixelBlock &block)
  {
    const SurroundLanes *judged = m_blocks.surroundOf(block);
    if (judged == nullptr) {
      return nullptr;
    }
    m_homography.apply(block.place, m_point);
    m_seen = *judged;
    for (std::size_t shape = 0; shape < paperShapes; ++shape) {
      m_shares[shape] = shareBeyond(m_point, m_papers[shape], static_cast<float>(m_photometry.blur.sigma));
      m_seen.share[shape] = m_seen.isKnown[shape] * m_shares[shape].share;
    }
    return &m_seen;
  }

  /*! Adds what the paper's ends do to the derivatives of that block's grey levels. */
  void addTo(const GreyLanes &grey, RowLanes &row) const
  {
    DarknessLanes change; // of the grey level
    change.setZero();
    for (std::size_t shape = 0; shape < paperShapes; ++shape) {
      const ShareLanes &share = m_shares[shape];
      Lanes weight = static_cast<float>(m_photometry.surround[shape]) * m_seen.isKnown[shape] *
                     (m_seen.beyond[shape] - grey.white);
      if (grey.isCut) {
        weight *= grey.tells;
      }
      row[sigmaAt] += weight * share.bySigma;
      row[elongationAt] += weight * share.byElongation[0];
      row[elongationAt + 1] += weight * share.byElongation[1];
      row[paperAt + 3] += weight * share.byExtent;
      const Eigen::Vector2f center = m_papers[shape].center.cast<float>();
      for (std::size_t i = 0; i < share.endCount; ++i) {
        const EndLanes &end = share.ends[i];
        const Lanes byX = weight * end.byX;
        const Lanes byY = weight * end.byY;
        m_motion.addMotion(end.footX, end.footY, byX, byY, change);
        row[paperAt] -= byX;
        row[paperAt + 1] -= byY;
        row[paperAt + 2] += byX * (end.footY - center.y()) - byY * (end.footX - center.x());
      }
    }
    for (std::size_t k = 0; k < poseSize; ++k) {
      row[k] += change.byTwist[k];
    }
    for (std::size_t k = 0; k < bendSize; ++k) {
      row[bendAt + k] += change.byBend[k];
    }
  }

private:
  static EdgeMotion motionAt(const MarkerPlane &plane, bool seesBend)
  {
    const Eigen::Vector3d c = -plane.rotation.transpose() * plane.center / plane.radius;
    return {static_cast<float>(c.x()), static_cast<float>(c.y()), static_cast<float>(-1. / c.z()), seesBend};
  }

  const PaperEnds m_papers;
  const Photometry &m_photometry;
  const PixelBlocks &m_blocks;
  const PlaneHomography m_homography;
  const EdgeMotion m_motion;
  PlaneLanes m_point;                             // of the block
  std::array<ShareLanes, paperShapes> m_shares{}; // and what of its pixels' view lies beyond the paper
  SurroundLanes m_seen;
};
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
