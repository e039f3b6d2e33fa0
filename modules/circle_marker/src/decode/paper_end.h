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
 * Where the paper around a marker ends.
 */

#ifndef VP_CIRCLE_MARKER_PAPER_END_H
#define VP_CIRCLE_MARKER_PAPER_END_H

#include <array>
#include <cmath>

#include <Eigen/Core>

#include <visp3/circle_marker/vpConfigCircleMarker.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! Where the paper around a marker ends, if it ends as early as it may. */
enum class PaperShape
{
  ROUND, //!< At a circle.
  SQUARE //!< At a square, as markers are printed and cut out.
};
constexpr std::size_t paperShapes = 2;

/*! The end of the paper, on the marker's plane. */
struct PaperEnd
{
  PaperShape shape = PaperShape::ROUND;
  double extent = 1.; //!< Radius of the circle or half of the square's width, in units of the outer radius.
  double angle = 0.;  //!< Of the square's axes, rad.
  Eigen::Vector2d center = Eigen::Vector2d::Zero(); //!< Of circle or square, in the same units.

  //! One of the square's two axes.
  Eigen::Vector2d axis(Eigen::Index index) const
  {
    return index == 0 ? Eigen::Vector2d(std::cos(angle), std::sin(angle))
                      : Eigen::Vector2d(-std::sin(angle), std::cos(angle));
  }

  //! A vector of the plane along the square's axes.
  Eigen::Vector2d alongAxes(const Eigen::Vector2d &q) const { return {axis(0).dot(q), axis(1).dot(q)}; }
};

/*! The ends that are taken into account, by their shape. */
using PaperEnds = std::array<PaperEnd, paperShapes>;

/*! How a sheet is cut, or a print lies on it, otherwise than it should be: by little, on the marker's plane. */
struct PaperPlacement
{
  Eigen::Vector2d shift = Eigen::Vector2d::Zero(); //!< Of its centre, outer radii.
  double turn = 0.;                                //!< Of its axes, rad.
  double growth = 0.;                              //!< Of its extent, outer radii.
};

/*! The paper's ends where a sheet is placed so. */
inline PaperEnds placedAt(PaperEnds ends, const PaperPlacement &placement)
{
  for (PaperEnd &end : ends) {
    end.center += placement.shift;
    end.angle += placement.turn;
    end.extent += placement.growth;
  }
  return ends;
}
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
