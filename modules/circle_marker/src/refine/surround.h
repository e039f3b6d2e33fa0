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
 * What lies beyond a marker's quiet zone.
 */

/*!
  \file surround.h
  \brief What lies beyond a marker's quiet zone.

  A pixel near the end of the quiet zone sees a part of what lies beyond. What that is can be seen a little farther out:
  white paper that goes on changes nothing; a dark table darkens the pixel by an amount between nothing (the paper may
  be larger than it must) and its share of the table.
*/

#ifndef VP_CIRCLE_MARKER_SURROUND_H
#define VP_CIRCLE_MARKER_SURROUND_H

#include <array>
#include <bitset>

#include "pose/marker_plane.h"
#include "refine/plane_point.h"
#include "support/camera_model.h"

#include <visp3/core/vpImage.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! What is seen beyond the quiet zone in one direction. */
struct Ground
{
  float grey = 0.f;   //!< Mean grey level.
  float spread = 0.f; //!< Standard deviation; HUGE_VALF where the image ends.
};

/*!
  What is seen beyond the quiet zone, in directions around the marker. Most markers see little of it: a direction is
  looked at when it is first asked for.
*/
class Surround
{
public:
  static constexpr unsigned int directions = 64;

  /*!
    \param I : The image, which has to outlive this.
    \param camera : Its camera, which has to outlive this.
    \param plane : The marker's pose.
    \param paper : Where the quiet zone ends.
    \param blur : Standard deviation of the blur, pixels: the looks begin where it no longer mixes both sides.
  */
  Surround(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane &plane, const PaperEnd &paper,
           double blur)
      : m_image(I), m_camera(camera), m_plane(plane), m_paper(paper), m_blur(blur)
  {
  }

  /*! What is seen in a direction, from 0 to before \e directions. */
  const Ground &toward(unsigned int direction);

  /*! The direction in which a point of the marker's plane lies. */
  static unsigned int directionOf(const Eigen::Vector2d &q);

private:
  Ground look(unsigned int direction) const;

  const vpImage<unsigned char> &m_image;
  const CameraModel &m_camera;
  const MarkerPlane m_plane;
  const PaperEnd m_paper;
  const double m_blur;
  std::array<Ground, directions> m_grounds;
  std::bitset<directions> m_isLookedAt;
};

/*! A pixel of which this share at most lies beyond the paper sees nothing of it: a thousandth of the light is below the
 * noise. */
constexpr double leastSurround = 0.001;
/*! So many standard deviations of the blur away from the paper's end it is less. */
constexpr double clearOfSurround = 3.1;

/*! Product of the densities of two sides of a square sheet, at a pixel, below which that does not see their corner. */
constexpr double leastPaperCorner = 1e-6;

/*! What a pixel may see beyond the paper. */
struct ShareBeyond
{
  double share = 0.;      //!< Of what it sees, in [0, 1].
  double byDistance = 0.; //!< How much it changes when the paper ends a pixel earlier.
};

/*!
  Share of what a pixel sees that may lie beyond the paper.
  \param point : The pixel on the marker's plane.
  \param paper : Where the paper ends at the earliest.
  \param blur : Standard deviation of the blur, pixels.
*/
ShareBeyond shareBeyond(const PlanePoint &point, const PaperEnd &paper, double blur);

/*!
  Angle of the square sheet around a marker whose frame does not tell it, up to quarter turns: the one at which a square
  on ground that is darker or brighter explains most of the image. Anything if the paper goes on, where it does not
  matter.
  \param I, camera, plane : As above.
  \param outermost : Half of the square's width, in units of the outer radius.
  \param blur : Standard deviation of the blur, pixels.
*/
double squareAngleOf(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane &plane,
                     double outermost, double blur);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
