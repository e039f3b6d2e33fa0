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
 * Where markers are, so that nothing is sought inside of them.
 */

#ifndef VP_CIRCLE_MARKER_MARKER_PLACES_H
#define VP_CIRCLE_MARKER_MARKER_PLACES_H

#include <vector>

#include "ellipse/conic.h"
#include "support/cell_index.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! Where the markers of an image are, so that nothing is sought inside of them. */
class MarkerPlaces
{
public:
  /*! Forgets all; the memory is kept. */
  void reset(int width, int height);

  /*!
    Keeps the place of a marker.
    \param outline : Image of its outer edge.
    \param isDisc : Whether it is black to its centre; another marker may lie in the white centre of a ring.
  */
  void add(const EllipseParameters &outline, bool isDisc);

  /*! Whether an outline is a piece of a marker: its code, or its ring again. */
  bool hold(const EllipseParameters &outline) const;

private:
  /*! The affine map that makes a marker's outline the unit circle, and how far from its centre there is room. */
  struct Place
  {
    EllipseParameters outline;
    Eigen::Matrix2d toUnit;
    double room;
  };
  std::vector<Place> m_places;
  CellIndex m_index; //!< By the boxes around them.
};
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
