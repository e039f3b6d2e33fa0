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
 * Response of a pixel to the scene: blur of the lens and integration over the pixel's square.
 */

#ifndef VP_SIMULATOR_PIXEL_RESPONSE_H
#define VP_SIMULATOR_PIXEL_RESPONSE_H

#include <vector>

#include "coverage.h"

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

/*!
  Response of a pixel to a point of light, and with it the coverage of pixels by blurred regions.

  The response is K = Gaussian * defocus disc * square of the pixel. By the divergence theorem the coverage of the pixel
  at p by a region is a line integral along the region's boundary,
    coverage(p) = - integral of F(p - q) dq_y,  F(x, y) = integral of K(s, y) ds from -infinity to x,
  taken with Gauss's rule on pieces no longer than the blur is wide, where the integrand is smooth. Only the differences
  F(p - q) - F(p - q - (1, 0)) are added to the window; they vanish beyond the blur's reach. Without any blur the
  coverage is computed exactly instead.
*/
class PixelResponse
{
public:
  /*!
    \param sigma : standard deviation of the Gaussian, in pixels; 0 for none.
    \param defocusRadius : radius of the disc, in pixels; 0 for none.
    \exception vpException::badValue : negative, or too small to be told from 0.
  */
  PixelResponse(double sigma, double defocusRadius);

  //! Distance at which a boundary still matters to a pixel's centre, in pixels.
  double reach() const { return m_reach; }

  //! Adds `weight` times the coverage by a blurred region to a window.
  void add(const Outline &region, double weight, CoverageWindow &window) const;

private:
  void buildGaussianTables(double sigma);
  void buildDiscTable(double sigma, double defocusRadius);
  void addPoint(const PlanePoint &point, double weight, CoverageWindow &window) const;
  void addPointOfDisc(const PlanePoint &point, double weight, CoverageWindow &window) const;

  double m_reach = 0.5;             //!< Half-width of the response, in pixels.
  double m_longestPiece = 0.;       //!< Longest piece for one application of Gauss's rule, in pixels; 0: no blur.
  std::vector<double> m_density;    //!< Gaussian only: the response along one axis, from -reach.
  std::vector<double> m_cumulative; //!< Gaussian only: its integral.
  std::vector<double> m_disc;       //!< With a defocus disc: difference of F, in two dimensions.
  int m_discSide = 0;               //!< Samples along a side of m_disc.
};

} // namespace marker_simulator
END_VISP_NAMESPACE

#endif
