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
 * How a pose follows the edges of its marker when they are moved in the image.
 */

#ifndef VP_CIRCLE_MARKER_EDGE_EQUATIONS_H
#define VP_CIRCLE_MARKER_EDGE_EQUATIONS_H

#include <visp3/circle_marker/vpConfigCircleMarker.h>

#include <cmath>

#include <Eigen/Core>

#include "pose/marker_plane.h"
#include "refine/marker_pattern.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! A point of an edge of a marker. */
struct MarkerEdge
{
  Eigen::Vector2d place; //!< In the marker's plane, outer radii.
  Eigen::Vector2d along; //!< Direction of the edge there, unit vector.
  //! To the other side of the line that it is a side of: across the ring, or the mean run of sectors alike; outer
  //! radii.
  Eigen::Vector2d toOther;
};

/*!
  Points of the ring's edges, evenly, and if there is a code of the borders of its sectors.
  \param pattern : What is printed.
  \param visit : Called as visit(MarkerEdge) for each.
*/
template <typename Visitor> void forEachEdge(const MarkerPattern &pattern, Visitor visit)
{
  // Points along each circle, and along each border between sectors: the least squares of smooth functions.
  constexpr int pointsOfCircle = 32;
  constexpr int pointsOfBorder = 2;
  constexpr double meanRun = 2.; // sectors, where each is as often black as white
  for (unsigned int ring = 0; ring < pattern.ringEdges; ++ring) {
    const double radius = pattern.ring[ring].radius;
    const double other = pattern.ringEdges > 1 ? pattern.ring[1 - ring].radius : -radius; // of a disc, the far side
    for (int i = 0; i < pointsOfCircle; ++i) {
      const double angle = 2. * M_PI * i / pointsOfCircle;
      const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
      const Eigen::Vector2d along(-direction.y(), direction.x());
      visit(MarkerEdge{radius * direction, along, (other - radius) * direction});
    }
  }
  for (unsigned int k = 0; k < pattern.sectors; ++k) {
    const Eigen::Vector2d direction(pattern.across[k].y(), -pattern.across[k].x());
    for (int i = 0; i < pointsOfBorder; ++i) {
      const double share = (i + 0.5) / pointsOfBorder;
      const double radius = pattern.track[1].radius + share * (pattern.track[0].radius - pattern.track[1].radius);
      const double run = meanRun * 2. * M_PI * radius / pattern.sectors;
      visit(MarkerEdge{radius * direction, direction, run * pattern.across[k]});
    }
  }
}

/*! Motions of a pose (t, w), or right sides of its equations, one in each column: so many at most, without the heap. */
using PoseColumns = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, 16>;

/*!
  The least squares of n^T (dm/d(t, w) delta - moved) over points of edges, of which only the way n across is seen:
  by how much the pose (t, w) of FittedPose follows when the points' normalised coordinates m are moved.
*/
class EdgeEquations
{
public:
  /*! \param plane : The pose; it must stay. */
  explicit EdgeEquations(const MarkerPlane &plane) : m_plane(plane) {}

  /*! What a point of an edge is in the image. */
  struct Seen
  {
    Eigen::Vector2d meter;              //!< Where it is, normalised coordinates.
    Eigen::RowVector2d across;          //!< The edge's unit normal n there.
    Eigen::Matrix<double, 6, 1> byPose; //!< Derivative of n^T m by (t, w).
    Eigen::Matrix2d byPlace;            //!< Derivative of m by the place in the marker's plane, outer radii.
  };

  /*! Adds a point; it must be in front of the camera. What moves it adds byPose times n^T moved to a right side. */
  Seen add(const MarkerEdge &edge);

  /*! The pose's motion for each right side, a sum over all points. The spin of a marker without a code stays. */
  PoseColumns solve(const PoseColumns &right) const;

private:
  const MarkerPlane &m_plane;
  Eigen::Matrix<double, 6, 6> m_matrix = Eigen::Matrix<double, 6, 6>::Zero();
};
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
