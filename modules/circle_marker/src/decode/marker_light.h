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

#include <cstddef>

#include <Eigen/Core>

#include <visp3/circle_marker/vpConfigCircleMarker.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Grey level of white paper over a marker's plane: a plane, or, where the edge of a shadow crosses the marker, two
  levels on the two sides of a straight line (straight lines of the image are straight in the plane).
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
  bool hasShadow() const { return m_hasShadow; }

  double getBright() const { return m_bright; } //!< White beside the shadow, grey levels; only if there is one.
  double getDark() const { return m_dark; }     //!< White in it; only if there is one.

  /*! Grey level of white paper at a point of the plane, in outer radii. */
  double at(const Eigen::Vector2d &q) const
  {
    return m_hasShadow ? (distanceToShadow(q) > 0. ? m_bright : m_dark) : m_mean + m_slope.dot(q);
  }

  /*! How far inside the light a point lies, in outer radii; only if there is a shadow. */
  double distanceToShadow(const Eigen::Vector2d &q) const { return m_toLight.dot(q) - m_edge; }

private:
  void seekShadow(const double *whites, std::size_t count, double radius, double first);

  double m_mean = 0.;                                  //!< Of all directions.
  Eigen::Vector2d m_slope = Eigen::Vector2d::Zero();   //!< Of the plane, by outer radii.
  bool m_hasShadow = false;                            //!< Whether two levels are far better than the plane.
  double m_bright = 0.;                                //!< Beside the shadow.
  double m_dark = 0.;                                  //!< In it.
  Eigen::Vector2d m_toLight = Eigen::Vector2d::Zero(); //!< Unit vector across the shadow's edge.
  double m_edge = 0.;                                  //!< Where it lies along that, outer radii.
};
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
