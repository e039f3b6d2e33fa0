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
 * Means, covariance matrices and lines of a recorded marker's places.
 */

#ifndef VP_EXPERIMENTS_STATION_FIGURES_H
#define VP_EXPERIMENTS_STATION_FIGURES_H

#include "common/statistics.h"
#include "recording.h"

namespace experiments {
/*! A straight line through the centres of a slide: x and y as linear functions of z (least squares). */
struct SlideLine
{
  double nearest = 0., farthest = 0.; //!< Depths that it covers, mm.
  Triple origin = {};                 //!< Point at z = 0, mm.
  Triple direction = {};              //!< Change with z.
  double angle = 0.;                  //!< Between the line and the optical axis, degrees.
  common::Statistics distances = {};  //!< Of the centres from the line, across the optical axis, mm.

  /*! Distance of a centre from the line, across the optical axis, mm. */
  double distanceOf(const Triple &centre) const;
};

/*! What a station's images tell. */
struct StationFigures
{
  std::size_t frames = 0;   //!< Images.
  std::size_t found = 0;    //!< With the marker.
  double markers = 0.;      //!< Found in an image, of any id, mean.
  Triple mean = {};         //!< Of the centres, mm.
  Square covariance = {};   //!< Of the centres, mm^2.
  Square stated = {};       //!< What the detector states, mean, mm^2.
  double consistency = 0.;  //!< Mean square Mahalanobis distance from the mean, over its expectation: 1 is right.
  double tilt = 0.;         //!< Of the mean normal against the optical axis, degrees.
  double normalSpread = 0.; //!< Root mean square angle of the normals to their mean, degrees.
  common::Statistics cpuTime = {}; //!< ms
};

StationFigures figuresOf(const Station &station);

/*! \param station : With two images or more in which the marker was found. */
SlideLine lineOf(const Station &station);

/*! The points of the ellipse that two coordinates' covariance makes of so many standard deviations, about a centre. */
std::vector<std::array<double, 2>> ellipseOf(const Square &covariance, std::size_t first, std::size_t second,
                                             double deviations);
} // namespace experiments

#endif
