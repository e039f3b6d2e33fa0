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
 * The thesis's experiment 3: random poses in cells of depth and angle.
 */

#include <sstream>

#include <visp3/core/vpMath.h>

#include "common/reference_camera.h"
#include "experiment.h"
#include "poses.h"

namespace experiments {
namespace {
Series seriesOf(const Settings &settings, double angle, double distance, unsigned int frames, std::uint64_t stream)
{
  std::ostringstream name;
  name << "angle-" << angle << "-distance-" << distance;
  std::ostringstream title;
  title << "angle to " << angle << "°, depth to " << distance << " m";
  Series series;
  series.name = name.str();
  series.title = title.str();
  series.frames = settings.frames.value_or(frames);
  series.methods = {Method::Ring, Method::Circle, Method::Bound};
  series.stream = stream;
  series.scene = [settings, angle, distance](unsigned int, std::uint64_t seed) {
    Scene scene;
    scene.cam = referenceCamera();
    scene.photometry = photometryOf(settings);
    scene.cMo = randomPose(settings, scene.cam, nearestDepth, distance, vpMath::rad(angle), seed);
    return scene;
  };
  for (const ThesisCell &cell : thesisCells) {
    if (cell.maximumAngle == angle && cell.maximumDistance == distance) {
      series.thesis = &cell.figures;
    }
  }
  return series;
}
} // namespace

Experiment experimentOfCells(const Settings &settings)
{
  Experiment experiment = {"experiment-3", "Experiment 3: random poses", {}};
  if (settings.maximumAngle || settings.maximumDistance) {
    // One cell of the user's own, of the largest extent unless told.
    experiment.series = {
        seriesOf(settings, settings.maximumAngle.value_or(90.), settings.maximumDistance.value_or(18.4), 7500, 0)};
    return experiment;
  }
  std::uint64_t stream = 0;
  for (const ThesisCell &cell : thesisCells) {
    experiment.series.push_back(
        seriesOf(settings, cell.maximumAngle, cell.maximumDistance, cell.figures.frames, ++stream));
  }
  return experiment;
}
} // namespace experiments
