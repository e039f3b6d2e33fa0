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
 * Light on a marker, by the white around it.
 */

#ifndef VP_CIRCLE_MARKER_MARKER_LIGHT_H
#define VP_CIRCLE_MARKER_MARKER_LIGHT_H

#include <cmath>
#include <cstddef>

#include <Eigen/Core>

#include <visp3/circle_marker/vpConfigCircleMarker.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Radius of the circle on which the white of a quiet zone is read, in outer radii: past the blur of the ring, short of
  the surround.
  \param quietZone : Width of the zone, in outer radii.
*/
inline double radiusOfWhite(double quietZone)
{
  constexpr double place = 0.6; // from the ring (0) to where the zone ends (1)
  return 1. + place * quietZone;
}

/*!
  Grey level of white paper over a marker's plane: a plane, or the square of one, as a camera's gamma may leave it,
  which the shadow with a straight edge that may cross the marker multiplies by what it leaves of the light (straight
  lines of the image are straight in the plane).
*/
class MarkerLight
{
public:
  /*!
    \param whites : Grey levels of the white around, equally spaced.
    \param count : Their number, no more than mostSamples.
    \param radius : Of the circle that they lie on, in outer radii.
    \param first : Angle of the first, in steps from the x axis.
  */
  MarkerLight(const double *whites, std::size_t count, double radius, double first = 0.5);

  double mean() const { return m_mean; }

  /*! Whether the edge of a shadow crosses the marker. */
  bool hasShadow() const { return m_factor < 1.; }

  /*! Share of the light that is left in the shadow; 1 without one. */
  double getFactor() const { return m_factor; }

  /*! Grey level of white paper at a point of the plane, in outer radii, if no shadow fell on it. */
  double litAt(const Eigen::Vector2d &q) const
  {
    const double plane = m_center + m_slope.dot(q);
    return m_isSquare ? plane * std::abs(plane) : plane;
  }

  /*! Grey level of white paper at a point of the plane, in outer radii. */
  double at(const Eigen::Vector2d &q) const
  {
    return hasShadow() && distanceToShadow(q) <= 0. ? m_factor * litAt(q) : litAt(q);
  }

  /*! How far inside the light a point lies, in outer radii; only if there is a shadow. */
  double distanceToShadow(const Eigen::Vector2d &q) const { return m_toLight.dot(q) - m_edge; }

private:
  void seekShadow(const double *whites, std::size_t count, double radius, double first);

  double m_mean = 0.;                                  //!< Of all directions.
  double m_center = 0.;                                //!< The plane at the marker's centre, if no shadow fell on it.
  Eigen::Vector2d m_slope = Eigen::Vector2d::Zero();   //!< Its change by outer radii.
  bool m_isSquare = false;                             //!< Whether the light is the plane's square.
  double m_factor = 1.;                                //!< Share of the light that a shadow leaves.
  Eigen::Vector2d m_toLight = Eigen::Vector2d::Zero(); //!< Unit vector across the shadow's edge.
  double m_edge = 0.;                                  //!< Where it lies along that, outer radii.
};
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
