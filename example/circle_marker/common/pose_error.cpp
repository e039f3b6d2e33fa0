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
 * Errors of a pose against the truth.
 */

#include <cmath>

#include <visp3/core/vpColVector.h>
#include <visp3/core/vpRotationMatrix.h>

#include "pose_error.h"

namespace common {
namespace {
vpColVector centerOf(const vpHomogeneousMatrix &cMo)
{
  vpColVector center(3);
  for (unsigned int i = 0; i < 3; ++i) {
    center[i] = cMo[i][3];
  }
  return center;
}

vpColVector normalOf(const vpHomogeneousMatrix &cMo)
{
  vpColVector normal(3);
  for (unsigned int i = 0; i < 3; ++i) {
    normal[i] = cMo[i][2];
  }
  return normal;
}

double lengthOf(const vpColVector &v)
{
  return std::sqrt(vpColVector::dotProd(v, v));
}

/*! Angle between two unit vectors, exact to the rounding for small angles as well, which the arc cosine is not. */
double angleBetween(const vpColVector &a, const vpColVector &b)
{
  return 2. * std::atan2(lengthOf(a - b), lengthOf(a + b));
}

/*! Angle of a rotation: |R - I|, over all elements, is 2 sqrt(2) sin(angle / 2). */
double angleOf(const vpRotationMatrix &R)
{
  double squares = 0.;
  for (unsigned int i = 0; i < 3; ++i) {
    for (unsigned int j = 0; j < 3; ++j) {
      const double difference = R[i][j] - (i == j ? 1. : 0.);
      squares += difference * difference;
    }
  }
  return 2. * std::asin(std::fmin(1., std::sqrt(squares / 8.)));
}
} // namespace

PoseError errorOf(const vpHomogeneousMatrix &measured, const vpHomogeneousMatrix &truth)
{
  const vpColVector offset = centerOf(measured) - centerOf(truth);
  const vpColVector normal = normalOf(measured);
  const vpColVector trueNormal = normalOf(truth);
  const vpColVector sight = centerOf(truth) / distanceOf(truth);
  const vpColVector mirrored = 2. * vpColVector::dotProd(sight, trueNormal) * sight - trueNormal;

  PoseError error;
  error.x = offset[0];
  error.y = offset[1];
  error.z = offset[2];
  error.position = lengthOf(offset);
  error.normal = angleBetween(normal, trueNormal);
  error.rotation = angleOf(measured.getRotationMatrix() * truth.getRotationMatrix().t());
  error.wrongSolution = angleBetween(normal, mirrored) < error.normal;
  return error;
}

double distanceOf(const vpHomogeneousMatrix &cMo)
{
  return lengthOf(centerOf(cMo));
}

double tiltOf(const vpHomogeneousMatrix &cMo)
{
  return angleBetween(normalOf(cMo), centerOf(cMo) / distanceOf(cMo));
}
} // namespace common
