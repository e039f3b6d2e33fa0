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
 * The pixels of a code track, and their likelihood as a function of the sectors.
 */

#ifndef VP_CIRCLE_MARKER_CODE_IMAGE_H
#define VP_CIRCLE_MARKER_CODE_IMAGE_H

#include <array>
#include <vector>

#include <Eigen/Core>

#include "decode/code_track.h"
#include "decode/uneven_light.h"
#include "refine/fit_pixel.h"
#include "refine/fitted_pose.h"
#include "refine/plane_point.h"
#include "refine/sector_borders.h"
#include "refine/track_lines.h"
#include "support/camera_model.h"
#include "support/normal_distribution.h"

#include <visp3/circle_marker/vpCircleMarkerFamily.h>
#include <visp3/core/vpImage.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  An edge at a place: the standardised distance, positive on the side that is asked for, the share of that side and its
  density, and the gradient of the place in the image, in coordinates in which the blur is 1.
*/
struct BlurredEdge
{
  BlurredEdge(double standardised, const Eigen::Vector2d &across) : distance(standardised), gradient(across)
  {
    const auto normal = NormalDistribution::instance().at(standardised);
    share = normal.cumulative;
    density = normal.density;
  }

  double distance, share, density;
  Eigen::Vector2d gradient; // of unit length
};

/*! The rims of the track at a pixel. */
struct Rims
{
  BlurredEdge outer, inner;
};

/*! What a pixel of the track sees. */
struct CodePixel
{
  PlanePoint point;
  Rims rims;
  double angle;           // from the plane's x axis, rad
  double black;           // that is not explained by the ring: 0 for white, 1 for ink
  double leastTold;       // less black than this, of the same, the sensor cannot tell from none: it is too bright
  std::size_t begin, end; // of its pieces, where its edges are no simple ones
};

/*! Pixels of the track, and how large the noise is on their black. */
struct CodeImage
{
  std::vector<CodePixel> pixels;
  std::vector<TrackPiece> pieces;
  double noise = 0.;
  bool isOverExposed = false; //!< Whether by what the sensor cannot tell some are wrong by more than a little.
};

/*! The sectors that a pixel sees. */
struct SeenSectors
{
  std::array<int, mostSectors> numbers;
  std::array<double, mostSectors> weights; //!< Shares of the pixel.
  int count = 0;
};

/*! A marker whose pose and light are measured, in its image. */
struct MeasuredView
{
  const vpImage<unsigned char> &I;
  const CameraModel &camera;
  const FittedPose &fit;               //!< Pose, light and blur.
  ImageFrame frame;                    //!< Coordinates of the image in which the light was measured.
  const UnevenLight *uneven = nullptr; //!< The light, if that of the fit is what is left in even light.

  /*! Grey level of white paper at a pixel, in even light. */
  double whiteAt(const Eigen::Vector2d &pixel) const
  {
    return fit.photometry.whiteAt((pixel - frame.center) / frame.size);
  }

  /*! The grey level that a pixel of this one would have in even light. */
  double inEvenLight(const Eigen::Vector2d &pixel, double grey) const
  {
    return uneven != nullptr ? uneven->evened(pixel, grey) : grey;
  }
};

/*!
  Looks at the track of a marker whose pose is measured.
  \param view : The marker; its spin may be any.
  \param layout : Radii of the track.
  \param sectors : Of the code.
  \param track : The result; its memory is used again.
  \return False if the track leaves the image or there is no light on it.
*/
bool lookAtCode(const MeasuredView &view, const vpCircleMarkerLayout &layout, int sectors, CodeImage &track);

/*! What a pixel of a track sees of the sectors with these borders. */
SeenSectors sectorsSeenBy(const CodePixel &pixel, const CodeImage &track, const vpCircleMarkerLayout &layout,
                          const SectorBorders &borders);

using SectorMatrix = Eigen::Matrix<double, mostSectors, mostSectors>;

/*! Squared residuals as a quadratic form of the sectors' colours: squares - 2 right' c + c' matrix c. */
struct Squares
{
  SectorMatrix matrix = SectorMatrix::Zero();
  SectorVector right = SectorVector::Zero();
  double squares = 0.;
};

/*! The squared residuals of a track whose first sector begins at an angle from the plane's x axis, rad. */
Squares squaresOf(const CodeImage &track, const vpCircleMarkerLayout &layout, int sectors, double start);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
