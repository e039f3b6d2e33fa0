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
 * What a pixel sees of the ring and of each sector of a code, where they are small or bend sharply.
 */

/*!
  \file track_lines.h
  \brief Sectors of a code that are smaller than the blur: integrated along lines.

  The code's counterpart of line_model.h, sector by sector: which of them are black is what is asked for. A Gaussian
  blur is the product of one along the lines of a direction and one across them. Within a few standard deviations of a
  pixel the plane is taken for a linear map of the image, which it is to a hundredth on a marker as far away as it has
  to be to be as small. Where a line crosses circles and borders is known without approximation then.
*/

#ifndef VP_CIRCLE_MARKER_TRACK_LINES_H
#define VP_CIRCLE_MARKER_TRACK_LINES_H

#include <vector>

#include <Eigen/Core>

#include <visp3/circle_marker/vpCircleMarkerFamily.h>

#include "refine/plane_point.h"
#include "refine/sector_borders.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
using SectorVector = Eigen::Matrix<double, mostSectors, 1>;

/*! A piece of a line within the track: the points from + s along, s in standard deviations of the blur. */
struct TrackPiece
{
  Eigen::Vector2d from, along;
  double before, after; //!< Share of the blur before its beginning and its end.
  double angle;         //!< Where it begins on the plane, from the x axis, rad.
  double turn;          //!< From there to where it ends, rad: monotone in between, less than half a turn.
  double weight;        //!< Of the line.
};

/*!
  Whether a pixel sees edges that bend by too much within the blur for an approximation, both sides of a circle, or more
  than a few borders between sectors.
  \param point : The pixel, its derivative by one standard deviation of the blur.
  \param layout : Radii of ring and track.
  \param sectors : Of the code.
*/
bool wantsLines(const PlanePoint &point, const vpCircleMarkerLayout &layout, int sectors);

/*!
  Cuts lines through what such a pixel sees.
  \param point, layout : As wantsLines().
  \param pieces : What lies within the track is added.
  \return Share of the pixel that is black by the ring.
*/
double cutLines(const PlanePoint &point, const vpCircleMarkerLayout &layout, std::vector<TrackPiece> &pieces);

/*!
  Adds the share of each sector.
  \param piece : What is seen of the track along a line.
  \param borders : Between the sectors.
  \param shares : Of the pixel.
*/
void addSectors(const TrackPiece &piece, const SectorBorders &borders, SectorVector &shares);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
