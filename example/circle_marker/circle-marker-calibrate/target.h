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
 * What is photographed: a plane with points whose places are known.
 */

#ifndef VP_CALIBRATE_TARGET_H
#define VP_CALIBRATE_TARGET_H

#include <string>
#include <vector>

#include <Eigen/Core>
#include <visp3/circle_marker/vpCircleMarkerFamily.h>

#include "common/visp_names.h"

namespace calibrate {
enum class TargetKind
{
  Chessboard, //!< Inner corners of a chessboard.
  Grid,       //!< Discs in rows and columns.
  Asymmetric, //!< Discs in rows of which every second one is shifted by half a step.
  Markers     //!< Markers of this project; each says which it is.
};

/*! A point of the target's plane, z into the plane; metres. */
struct TargetPoint
{
  Eigen::Vector2d place;
  double radius = 0.; //!< Of the circle around it; 0: a corner.
  int id = -1;        //!< Of a marker.
};

struct Target
{
  TargetKind kind = TargetKind::Chessboard;
  int columns = 0; //!< Points in a row; of no meaning for markers.
  int rows = 0;
  vpCircleMarkerFamily family; //!< Of the circles.
  std::vector<TargetPoint> points;

  bool hasCircles() const { return kind != TargetKind::Chessboard; }
  /*! Name as on the command line. */
  std::string name() const;
};

/*!
  A chessboard or a grid of discs.
  \param kind : Which of them.
  \param columns : Points in a row.
  \param rows : Rows of points.
  \param spacing : Side of a square; distance of discs in a row, and of rows; of asymmetric grids the distance of two
  rows, half the distance of discs in a row, as OpenCV has it; metres.
  \param diameter : Of the discs, metres; of no meaning for a chessboard.
*/
Target makeGrid(TargetKind kind, int columns, int rows, double spacing, double diameter);

/*!
  A sheet of markers as circle-marker-create describes it: the lines of JSON that it has written.
  \exception std::runtime_error : If the file cannot be used: which line, and what is wrong.
*/
Target readSheet(const std::string &file);
} // namespace calibrate

#endif
