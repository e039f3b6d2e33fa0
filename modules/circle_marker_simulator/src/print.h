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
 * What is printed on a marker's sheet, as regions of the marker's plane.
 */

#ifndef VP_SIMULATOR_PRINT_H
#define VP_SIMULATOR_PRINT_H

#include <vector>

#include <visp3/circle_marker_simulator/vpSimulatedMarker.h>

#include "lens.h"
#include "outline.h"
#include "paper.h"

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

//! A straight line, or an arc around the origin, in the marker's plane, in metres.
class PlaneCurve
{
public:
  static PlaneCurve line(const PlanePoint &from, const PlanePoint &to);
  static PlaneCurve arc(double radius, double fromAngle, double toAngle);

  //! Point at t, from 0 (first end) to 1 (last end).
  PlanePoint at(double t) const;
  //! The same from its last end to its first.
  PlaneCurve reversed() const;
  //! Whether it is a straight line.
  bool isLine() const { return m_radius == 0.; }
  //! Number of equal parts in which no detail can hide between their ends and their middle.
  int parts() const;

private:
  PlanePoint m_from = {0., 0.}; //!< First end of a line.
  PlanePoint m_to = {0., 0.};   //!< Last end of a line.
  double m_radius = 0.;         //!< Radius of an arc, 0 for a line.
  double m_fromAngle = 0.;      //!< First angle of an arc, in radians from +x toward +y.
  double m_toAngle = 0.;        //!< Last angle of an arc.
};

//! A region of one shade: its boundary in the sense of Outline.
struct PrintedRegion
{
  std::vector<PlaneCurve> boundary;
  double whiteness; //!< 0 is ink, 1 is paper.
};

//! The sheet of paper.
PrintedRegion sheetOf(const vpSimulatedMarker &marker);

//! The regions printed on the sheet; no two of them overlap.
std::vector<PrintedRegion> printOn(const vpSimulatedMarker &marker);

/*!
  Image of a region, in pixels: straight pieces within 1.4e-4 pixels of the exact curve, which enclose its area.

  \exception vpException::badValue : a part of it cannot be seen by the camera.
*/
Outline project(const PrintedRegion &region, const Paper &paper, const Lens &lens);

} // namespace marker_simulator
END_VISP_NAMESPACE

#endif
