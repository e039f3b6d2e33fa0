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
 * The thesis's experiment 2: markers that face the camera, along five lines and along one.
 */

#include <array>

#include <visp3/core/vpRotationMatrix.h>
#include <visp3/core/vpThetaUVector.h>
#include <visp3/core/vpTranslationVector.h>

#include "common/reference_camera.h"
#include "experiment.h"
#include "poses.h"

namespace experiments {
namespace {
// Ends of the lines in the image, as shares of the way from its centre to its border: the optical axis and four lines
// that leave it at the near end, where the marker all but fills the image, toward the corners.
constexpr double reach = 0.8;
constexpr std::array<std::array<double, 2>, 5> directions = {
    {{0., 0.}, {-reach, -reach}, {reach, -reach}, {reach, reach}, {-reach, reach}}};

/*! The digits of a number in base 2, mirrored at the point: numbers that fill [0, 1[ ever more densely and evenly. */
double evenShare(unsigned int number)
{
  double share = 0.;
  double step = 0.5;
  for (; number > 0; number /= 2, step *= 0.5) {
    share += (number % 2) * step;
  }
  return share;
}

/*! The frames go through the lines in turn; where a frame is does not depend on how many there are. */
vpHomogeneousMatrix poseOnLine(unsigned int frame, unsigned int lines, double farthest, std::uint64_t seed)
{
  const double share = evenShare(frame / lines);
  const auto &direction = directions[frame % lines];
  const double z = nearestDepth + share * (farthest - nearestDepth);
  const double x = direction[0] * 0.5 * imageWidth / focalLength * (z - nearestDepth);
  const double y = direction[1] * 0.5 * imageHeight / focalLength * (z - nearestDepth);
  // The normal is parallel to the optical axis; only the spin about it is drawn.
  return vpHomogeneousMatrix(vpTranslationVector(x, y, z), vpRotationMatrix(vpThetaUVector(0., 0., spinFrom(seed))));
}

Series seriesOf(const Settings &settings, const std::string &name, const std::string &title, unsigned int lines,
                unsigned int frames, std::uint64_t stream)
{
  const double farthest = settings.maximumDistance.value_or(22.); // Metres, the thesis's.
  Series series;
  series.name = name;
  series.title = title;
  series.frames = settings.frames.value_or(frames);
  series.methods = {Method::Ring, Method::Circle, Method::Bound};
  series.stream = stream;
  series.kinds = lines;
  series.scene = [settings, lines, farthest](unsigned int frame, std::uint64_t seed) {
    Scene scene;
    scene.cam = referenceCamera();
    scene.photometry = photometryOf(settings);
    scene.cMo = poseOnLine(frame, lines, farthest, seed);
    return scene;
  };
  return series;
}
} // namespace

Experiment experimentOfLines(const Settings &settings)
{
  Experiment experiment = {"experiment-2",
                           "Experiment 2: lines of poses that face the camera",
                           {seriesOf(settings, "five-lines-2000", "five lines (2000 in the thesis)", 5, 2000, 1),
                            seriesOf(settings, "five-lines-1500", "five lines (1500 in the thesis)", 5, 1500, 2),
                            seriesOf(settings, "five-lines-200", "five lines (200 in the thesis)", 5, 200, 3),
                            seriesOf(settings, "single-line-200", "single line (200 in the thesis)", 1, 200, 4)}};
  experiment.series.front().thesis = &thesisLines; // Table 5.5 is of its 2000 frames.
  return experiment;
}
} // namespace experiments
