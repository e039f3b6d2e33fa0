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
 * The outer edge of a measured marker: how much of it is seen, and whether it has a halo.
 */

#ifndef VP_CIRCLE_MARKER_OUTER_EDGE_H
#define VP_CIRCLE_MARKER_OUTER_EDGE_H

#include <optional>

#include "decode/measured_ring.h"
#include "decode/recognise.h"
#include "refine/measure.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  A halo below this share of the contrast is what noise, light and gamma leave of a median: up to 0.009 of 300 images
  that were not sharpened, 0.003 mostly.
*/
constexpr double leastHalo = 0.01;

/*!
  What a ring's measurement tells of its light and blur.
  \param measurement : The measurement.
  \param start : The pose from which it started.
  \param camera : The camera.
  \param isFirst : Whether that of its first pose is asked for, not that of the second.
*/
MeasuredRing ringOf(const Measurement &measurement, const MarkerPlane &start, const CameraModel &camera,
                    bool isFirst = true);

/*!
  Share of the directions in which the image shows the outer edge of a marker of which a part is covered: just inside
  and just outside of it, at the measured pose, the grey levels are those of ink and paper through the blur.
*/
double visibleEdgeOf(const vpImage<unsigned char> &I, const CameraModel &camera, const Recognition &marker,
                     const Measurement &measurement);

/*!
  By how much the edge is overdone: beside it the paper is whiter, and the ink blacker, than the blur explains. Cameras
  that sharpen their images, as most webcams do, leave such a halo.
  \return The greatest median over all directions, share of the contrast, at most 1; 0 if it is no more than chance;
  nothing if ring and quiet zone are too narrow to tell: of markers below some 25 pixels.
*/
std::optional<double> haloOf(const vpImage<unsigned char> &I, const CameraModel &camera, const Recognition &marker,
                             const Measurement &measurement);

/*!
  Takes a halo, which the model of the image does not have, into account: the covariance grows by what it may move the
  edges of a marker outward or inward, which is seen as depth and tilt, and the likelihoods of the two poses say less.
*/
void addHaloDoubt(double halo, const CameraModel &camera, Measurement &measurement);

/*!
  Takes into account that uneven light is known to a part of the contrast only, which the pixels of an edge share: the
  covariance grows, and the odds of the two poses come down, as if so many were one. Nothing changes in even light.
*/
void addLightDoubt(const CameraModel &camera, Measurement &measurement);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
