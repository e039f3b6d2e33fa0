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
 * What an image of a marker depends on beside its pose.
 */

#ifndef VP_CIRCLE_MARKER_PHOTOMETRY_H
#define VP_CIRCLE_MARKER_PHOTOMETRY_H

#include <array>
#include <cmath>
#include <optional>

#include <Eigen/Core>

#include "decode/paper_end.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! Coordinates of the image about a marker: pixels from its centre, in units of about its radius. */
struct ImageFrame
{
  Eigen::Vector2d center; //!< Pixels.
  double size;            //!< Pixels.
};

/*!
  How lens, pixels, motion and ink soften and shift edges. The blur is taken for a Gaussian of covariance
  sigma^2 S^2 pixels^2, with S = exp((a, b; b, -a)) for the elongation (a, b): motion makes it longer in one direction.
*/
struct BlurParameters
{
  /*! The matrix S, of determinant 1: S^-1 of an image whose blur is elongated has round blur. */
  Eigen::Matrix2d shape() const;

  /*! Makes it longer by a small elongation that is given in the coordinates in which the blur is round. */
  void elongate(const Eigen::Vector2d &step);

  /*! Standard deviation in the direction where it is largest, pixels. */
  double widest() const { return sigma * std::exp(elongation.norm()); }

  /*! Standard deviation along a unit vector of the image, pixels. */
  double along(const Eigen::Vector2d &direction) const { return sigma * (shape() * direction).norm(); }

  double sigma =
      0.8; //!< Standard deviation of lens blur and pixel area together, geometric mean over directions, pixels.
  Eigen::Vector2d elongation = Eigen::Vector2d::Zero(); //!< (a, b) above.
  double spread = 0.; //!< Distance by which every black region is printed larger, outer radii: the ink's spread.
};

/*! Ink, and the light's gradient, leave no less than this share of the light: no sensor tells less from none. */
constexpr double leastLight = 1e-3;

/*! And a shadow, through whose edge a fit has to see where it is darker. */
constexpr double leastLightInShadow = 0.02;

/*! A shadow with a straight, soft edge that falls on a marker: as vpSceneShadow's, in the coordinates of ImageFrame. */
struct Shadow
{
  double factor = 0.5;    //!< Light that is left in it.
  double direction = 0.;  //!< Direction of the image from the lit to the dark side, rad from u toward v.
  double edge = 0.;       //!< Where the edge lies along that direction.
  double softness = 0.05; //!< Standard deviation of the edge's softness, as the lens blurs it.
  double frameSize = 0.;  //!< Unit of the coordinates, pixels; 0 if it is not known.

  /*! Share of the light that it leaves at a place. */
  double leavesAt(const Eigen::Vector2d &offset) const;
};

/*! Light, ink and blur of a marker's image, and the camera's gamma, the power of the light that grey levels are. */
struct Photometry
{
  double white = 200.; //!< Grey level of white paper at the marker's centre, if no shadow fell on it.
  Eigen::Vector2d lightGradient = Eigen::Vector2d::Zero(); //!< Change of the light over the marker's size, share of it.
  //! And how it bends: a lens's corners are darker. Coefficients of u^2, u v, v^2 in the light; nothing: it does not.
  std::optional<Eigen::Vector3d> lightCurvature;
  double absorption = 0.8; //!< Share of the light that ink takes.
  double gamma = 1.;       //!< The camera's.
  //! How far the camera's tone curve is an S besides: see maximum_likelihood.h; nothing: it is not.
  std::optional<double> toneCurve;
  //! How much of what may lie beyond the quiet zone does, for each shape that the paper may have (PaperShape): 1 if it
  //! ends there, 0 if it goes on.
  std::array<double, paperShapes> surround = {{0.25, 0.5}};
  //! Standard deviation by which that differs from direction to direction.
  double unevenShare = 0.3;
  PaperPlacement paper; //!< How the paper is cut.
  //! How well it is known where the paper ends besides, pixels: a cut is not straight to a tenth of a pixel of a marker
  //! of 20 pixels, 0.9 mm of one of 180 mm.
  double endError = 0.1;
  std::optional<Shadow> shadow; //!< A shadow that multiplies the light; nothing: none falls on the marker.
  BlurParameters blur;

  /*! 1 - black / white, of the grey levels. */
  double contrast() const;

  /*!
    Grey levels from ink to paper that a sensor can tell, none brighter than 255 nor darker than 0. A fit of what is no
    marker may find its contrast beyond: a letter was one of 515 grey levels, with a third of the noise for what the
    model may lack.
  */
  double tellableContrast() const;

  /*! Light at a place in the coordinates of ImageFrame without a shadow, in units of that at the marker's centre. */
  double relativeLightAt(const Eigen::Vector2d &offset) const;

  /*! Grey level of white paper at a place in the coordinates of ImageFrame. */
  double whiteAt(const Eigen::Vector2d &offset) const;

  /*! Share of black that a pixel sees, by its grey level over that of white. */
  double blackOf(double grey) const;

  /*! The same grey level as it would be without the tone curve. */
  double beforeTone(double grey) const;
};
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
