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
 * A pixel that a marker's pose is refined on.
 */

#ifndef VP_CIRCLE_MARKER_FIT_PIXEL_H
#define VP_CIRCLE_MARKER_FIT_PIXEL_H

#include <array>

#include "pose/marker_plane.h"
#include "refine/marker_pattern.h"
#include "decode/photometry.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! A pixel as the model needs it. */
struct ModelPixel
{
  Eigen::Vector2d meter;         //!< Normalised coordinates of its centre.
  Eigen::Matrix2d meterPerPixel; //!< Their derivative with respect to the pixel.
};

/*! What a pixel sees of what lies beyond the paper. */
struct BeyondPaper
{
  float share = 0.f;  //!< Share of what it sees that may lie there, where anything may be.
  float grey = 0.f;   //!< Grey level seen farther out in that direction.
  float spread = 0.f; //!< And its standard deviation there: HUGE_VALF if nothing is seen.
};

/*!
  A pixel of the image with what the model needs of it: in single precision, whose rounding is 1e-5 of a pixel, because
  there are many.
*/
struct FitPixel
{
  /*! Where it is. */
  ModelPixel model() const { return {meter.cast<double>(), meterPerPixel.cast<double>()}; }

  /*! Whether it may see anything that lies beyond the paper. */
  bool seesSurround() const { return beyond[0].share > 0.f || beyond[1].share > 0.f; }

  // The one that is aligned comes first: so a pixel is as long as a line of the cache, not a quarter longer.
  Eigen::Matrix2f meterPerPixel = Eigen::Matrix2f::Zero(); //!< Derivative of \e meter with respect to the pixel.
  Eigen::Vector2f meter = Eigen::Vector2f::Zero();         //!< Normalised coordinates of its centre.
  Eigen::Vector2f offset = Eigen::Vector2f::Zero();        //!< In the coordinates of an ImageFrame: for the light.
  float grey = 0.f;                                        //!< Measured grey level.
  std::array<BeyondPaper, paperShapes> beyond{};           //!< What may lie beyond the paper, by its shape.
};

/*! Which pixels of a marker are chosen. */
struct PixelChoice
{
  BlurParameters blur; //!< Expected at the edges: it makes the width of the band around them.
  /*! How far from where coarse fits have them the edges may be, pixels. (With 0.1, which nearly all clear ones are
      nearer than, a covered code was read as another: testDetectorWrongIds.) */
  double poseError = 0.3;
  /*! Number of pixels from which the marker is thinned: some 500 pixels diameter. Each that is left out is information
      lost. */
  double manyPixels = 20e3;
  /*! Number of pixels that flat areas give at most, one of each tile: there are as many as the square of the diameter
      has them, 3000 at 400 pixels, and a thousand know white and black to a thirtieth of the noise. */
  double manyFlat = 1e3;
};
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
