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
 * What a blurring camera makes of a marker: the darkness of a pixel.
 */

/*!
  \file image_model.h
  \brief The image of a marker, as a function of its pose.

  A pixel sees the print through the lens' blur, a Gaussian of standard deviation s, and its own area, a square of
  variance 1/12; both together are taken for a Gaussian of variance \f$ \sigma^2 = s^2 + 1/12 \f$ pixels^2. The share of
  black that it sees near a straight edge at the signed distance d is \f$ \Phi(d/\sigma) \f$. Near a circle of image
  curvature \f$ \kappa \f$ the mean of the curve over the blur shifts by \f$ \kappa \sigma^2 / 2 \f$ toward its centre:
  \f[ D = \Phi\left(\frac{d - \kappa \sigma^2 / 2}{\sigma}\right). \f]
  Where the camera or the marker moved, the blur is longer in one direction: all this then holds in coordinates of the
  image in which it is round (BlurParameters::shape()).
  Where a circular and a radial edge of the code track meet, the two events are correlated by the angle between the
  edges in the image, \f$ \rho \f$, and their joint probability is the tetrachoric series
  \f[ \Phi_2(a, b; \rho) = \Phi(a) \Phi(b) + \varphi(a) \varphi(b) \left(\rho + \frac{\rho^2}{2} a b
      + \frac{\rho^3}{6} (a^2 - 1)(b^2 - 1) + \dots\right). \f]

  A pose changes by a twist \f$ (\upsilon, \omega) \f$ in the marker's own frame, with the outer radius as unit of
  length: \f$ T \exp(\upsilon, \omega) \f$. The ray through a fixed pixel then meets the plane elsewhere: with the
  camera's centre c (in that frame, \f$ c_z < 0 \f$) and the ray's slope \f$ s = (q - c_{xy}) / |c_z| \f$,
  \f[ \dot q = (\upsilon_z + \omega_x q_y - \omega_y q_x) \, s - \upsilon_{xy} + \omega_z (q_y, -q_x)^T. \f]
  An edge's distance from a pixel changes as the edge moves across the pixel's ray where the edge is, at the foot f of
  the perpendicular in the image: \f$ \dot d = n^T \dot q(f) / |\nabla d| \f$, n its normal on the plane.
*/

#ifndef VP_CIRCLE_MARKER_IMAGE_MODEL_H
#define VP_CIRCLE_MARKER_IMAGE_MODEL_H

#include "refine/pixel_blocks.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
/*!
  Derivatives of an edge's distance in standard deviations of the blur. That by the pose is taken where the edge is, not
  where the pixel is: as the print turns, both move differently.
*/
struct SlopeLanes
{
  Lanes footX, footY;         //!< Point of the edge that is nearest in the image, on the plane.
  Lanes byX, byY;             //!< By the motion of the pixels' ray on the plane there.
  Lanes bySigma;              //!< 1 / pixel.
  Lanes byElongation[2];      //!< By a step of BlurParameters::elongate().
  Lanes bySpread;             //!< 1 / radius.
  Lanes gradientU, gradientV; //!< Of a circle: unit vector in the image from its centre outward there.
  Lanes perGradient;          //!< And 1 / length of the radius' gradient, pixels.
};

/*! A circular edge between black and white, as the pixels of a block see it. */
struct EdgeLanes
{
  Lanes standardised; //!< Distance in standard deviations of the blur, positive on the black side.
  NormalLanes normal; //!< Share of the black side, and its derivative by that distance.
  Lanes bend;         //!< What the edge bends away within the blur, in units of it; positive around black.
  bool isSeen;        //!< Whether any of the pixels sees it: else there are no slopes.
  SlopeLanes slope;   //!< Derivatives of the distance, where they are asked for.
};

/*! The code track's rims, and how much the share of black changes with their distances by the corners at them. */
struct TrackLanes
{
  EdgeLanes outer, inner;
  Lanes outerCorners, innerCorners;
};

/*! Share of black that each pixel of a block sees, and its derivatives. */
struct DarknessLanes
{
  void setZero()
  {
    for (Lanes *lanes : {&value, &bySigma, &byElongation[0], &byElongation[1], &bySpread}) {
      lanes->setZero();
    }
    for (Lanes &lanes : byTwist) {
      lanes.setZero();
    }
    for (Lanes &lanes : byBend) {
      lanes.setZero();
    }
  }

  Lanes value;
  Lanes byTwist[6];      //!< By the twist in the marker's frame: three translations in radii, three turns in rad.
  Lanes bySigma;         //!< 1 / pixel.
  Lanes byElongation[2]; //!< By a step of BlurParameters::elongate(), without what the bend at corners does.
  Lanes bySpread;        //!< 1 / radius.
  Lanes byBend[3];       //!< By the bow and the saddle of the sheet (SheetBend), if they are wanted.
};

struct CurvatureLanes;

/*! The model at a pose. */
class ImageModel
{
public:
  /*!
    \param plane : The pose.
    \param pattern : The print.
    \param blur : Of the image.
    \param blocks : The pixels.
    \param seesBend : Whether derivatives by the sheet's bend are wanted.
  */
  ImageModel(const MarkerPlane &plane, const MarkerPattern &pattern, const BlurParameters &blur,
             const PixelBlocks &blocks, bool seesBend = false);

  /*! Evaluates the model on a block whose pixels see a part of the print. */
  void evaluate(const PixelBlock &block, PixelSight sight, DarknessLanes &darkness) const;

  /*! The same, but only the share of black, for what needs no derivatives. */
  void evaluate(const PixelBlock &block, PixelSight sight, Lanes &value) const;

private:
  //! Result: DarknessLanes, or Lanes for the value alone.
  template <class Result> void evaluateParabolas(const PixelBlock &block, PixelSight sight, Result &result) const;
  template <PixelSight sight, int borders, class Result> void evaluateAs(const PixelBlock &block, Result &result) const;
  template <class Result>
  void seeBorder(const PlaneLanes &p, const CurvatureLanes &curvature, const Lanes &band, const Lanes &acrossX,
                 const Lanes &acrossY, const Lanes &change, TrackLanes &track, Lanes &code, Lanes &corners,
                 Result &result) const;

  const PixelBlocks &m_blocks;
  PlaneHomography m_homography;
  SecondOrder m_second;
  float m_cx, m_cy, m_perDepth;   // camera's centre in the marker's frame, in radii; 1 / |c_z|
  float m_ring[2];                // radii of the ring's edges; a disc's inner one is far below 0
  float m_track[2];               // radii of the track's rims
  float m_cosSector, m_sinSector; // of a sector's angle
  float m_sigma;                  // blur, pixels
  float m_spread;                 // radii
  int m_borders;                  // seen by a pixel; 0 without a code
  int m_cornerTerms;              // of the tetrachoric series
  bool m_seesBend;
};
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
