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
 * How well the image of a marker tells it from the others of its code.
 */

#ifndef VP_EXPERIMENTS_READING_H
#define VP_EXPERIMENTS_READING_H

#include <visp3/circle_marker_simulator/vpSimulatedMarker.h>

#include "experiment.h"

namespace experiments {
/*!
  The distance between the image of a marker and that of the one most like it, in standard deviations of the noise:
  sqrt(sum over the pixels of (I - I')^2) / noise, whatever the reader. Two markers differ in \e distance sectors or
  cells at least; those that change the image least are taken, each by itself, so that the square of the distance is the
  sum of theirs. A reader that knows pose, light and blur takes one of two such markers for the other with the
  probability Phi(-d / 2).

  \param marker : With a code, at its pose.
  \param distance : Of the code, sectors or cells.
  \param scene : Pose of the marker, camera, light, blur and noise.
*/
double readingDistance(const vpSimulatedMarker &marker, unsigned int distance, const Scene &scene);
} // namespace experiments

#endif
