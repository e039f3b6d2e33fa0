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
 * A plain shape in front of the markers of a simulated scene.
 */

/*!
  \file vpSceneOccluder.h
  \brief A plain shape in front of the markers of a simulated scene.
*/

#ifndef VP_SCENE_OCCLUDER_H
#define VP_SCENE_OCCLUDER_H

#include <vector>

#include <visp3/core/vpImagePoint.h>

#include <visp3/circle_marker_simulator/vpConfigCircleMarkerSimulator.h>

BEGIN_VISP_NAMESPACE

/*!
  \class vpSceneOccluder
  \ingroup group_circle_marker_simulator
  \brief A shape of one grey level, given in the image, in pixels; integer coordinates are pixel centres.

  A polygon must not cross itself; the direction in which its corners are listed does not matter.
*/
class VISP_EXPORT vpSceneOccluder
{
public:
  static vpSceneOccluder polygon(const std::vector<vpImagePoint> &corners, double grey);
  static vpSceneOccluder bar(const vpImagePoint &from, const vpImagePoint &to, double width, double grey);
  static vpSceneOccluder ellipse(const vpImagePoint &center, double semiAxisA, double semiAxisB, double angle,
                                 double grey);

  /*! Corners of the outline, in pixels; those of an ellipse lie densely enough for any blur or none. */
  const std::vector<vpImagePoint> &getCorners() const { return m_corners; }
  /*! Grey level under the reference light. */
  double getGrey() const { return m_grey; }

private:
  vpSceneOccluder(const std::vector<vpImagePoint> &corners, double grey);

  std::vector<vpImagePoint> m_corners; //!< Outline, in pixels, turning from +u toward +v.
  double m_grey;                       //!< Grey level.
};

END_VISP_NAMESPACE

#endif
