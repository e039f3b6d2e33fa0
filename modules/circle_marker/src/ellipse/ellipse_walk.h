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
 * Points around an ellipse.
 */

#ifndef VP_CIRCLE_MARKER_ELLIPSE_WALK_H
#define VP_CIRCLE_MARKER_ELLIPSE_WALK_H

#include <cmath>

#include "edges/edge_points.h"
#include "ellipse/fit_conic.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! Walks round an ellipse in equal steps of its parameter: point and outward normal. */
class EllipseWalk
{
public:
  EllipseWalk(const EllipseParameters &ellipse, int steps)
      : m_ellipse(ellipse), m_major(std::cos(ellipse.angle), std::sin(ellipse.angle)),
        m_minor(-m_major.y(), m_major.x()), m_step(std::cos(2. * M_PI / steps), std::sin(2. * M_PI / steps))
  {
  }

  EdgePoint here() const
  {
    EdgePoint point;
    point.position = m_ellipse.center + m_ellipse.a * m_at.x() * m_major + m_ellipse.b * m_at.y() * m_minor;
    point.across = m_ellipse.b * m_at.x() * m_major + m_ellipse.a * m_at.y() * m_minor;
    return point;
  }

  void next()
  {
    m_at =
        Eigen::Vector2d(m_step.x() * m_at.x() - m_step.y() * m_at.y(), m_step.y() * m_at.x() + m_step.x() * m_at.y());
  }

private:
  EllipseParameters m_ellipse;
  Eigen::Vector2d m_major;
  Eigen::Vector2d m_minor;
  Eigen::Vector2d m_step;                          // cosine and sine of the step
  Eigen::Vector2d m_at = Eigen::Vector2d::UnitX(); // and of the parameter
};
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
