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

#include "decode/recognise.h"
#include "ellipse/ellipse_candidate.h"
#include "pose/marker_plane.h"
#include "support/camera_model.h"
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
    Keeps the place of a marker. Another may lie in its white: in the middle of a code, or of a ring without one.
    \param outline : Image of its outer edge, pixels.
    \param marker : What it was read as.
  */
  void add(const EllipseCandidate &outline, const Recognition &marker);

  /*! Keeps the place of an outline of which nothing else is known: it has no room for another. */
  void add(const EllipseCandidate &outline);

  /*! Whether an outline is a piece of a marker whose outline is of at least its rank: its code, or its ring again. */
  bool hold(const EllipseCandidate &outline, const CameraModel &camera) const;

private:
  /*! The affine map that makes a marker's outline the unit circle, and what room there is inside. */
  struct Place
  {
    EllipseParameters outline;
    double rank = 0.; // that of the outline
    Eigen::Matrix2d toUnit;
    double room = 0.; // radius of its white, in units of the outer radius; 0 if there is no room
    PosePair poses;   // either may be the marker's
  };

  void keep(Place place);

  std::vector<Place> m_places;
  CellIndex m_index; //!< By the boxes around them.
};
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
