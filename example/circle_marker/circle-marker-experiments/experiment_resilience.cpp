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
 * What the thesis left open: one disturbance after another, from none to more than is borne.
 */

#include <cmath>
#include <sstream>

#include <visp3/core/vpMath.h>

#include "common/reference_camera.h"
#include "experiment.h"
#include "poses.h"

namespace experiments {
namespace {
// Poses at which all methods find an undisturbed marker: images of the ring from 36 to 290 pixels in diameter.
constexpr double leastDepth = 1.; // metres
constexpr double mostDepth = 8.;  // metres
constexpr double mostAngle = 60.; // degrees: the thesis's requirement
constexpr unsigned int framesOfLevel = 100;

/*! Disturbs a scene by a level; the seed is the frame's. */
using Disturb = void (*)(Scene &scene, double level, const Settings &settings, std::uint64_t seed);

struct Disturbance
{
  const char *name;
  const char *title; // With its unit.
  std::vector<double> levels;
  Disturb disturb;
};

double directionFrom(std::uint64_t seed)
{
  return 2. * M_PI * uniformFrom(Draw::Direction, seed);
}

void cover(Scene &scene, double level, const Settings &, std::uint64_t seed)
{
  if (level > 0.) {
    constexpr double darkest = 20.; // grey levels
    constexpr double brightest = 230.;
    scene.cover = {level, directionFrom(seed), darkest + (brightest - darkest) * uniformFrom(Draw::Cover, seed)};
  }
}

void addNoise(Scene &scene, double level, const Settings &, std::uint64_t)
{
  scene.photometry.noiseSigma = level;
}

void blur(Scene &scene, double level, const Settings &, std::uint64_t)
{
  scene.photometry.blurSigma = level;
}

/*! The camera moves across its line of sight so that the marker's centre moves by so many pixels. */
void move(Scene &scene, double level, const Settings &, std::uint64_t seed)
{
  const double way = level * (*scene.cMo)[2][3] / focalLength;
  scene.motion.twist[0] = way * std::cos(directionFrom(seed));
  scene.motion.twist[1] = way * std::sin(directionFrom(seed));
}

/*! The light changes by so much, in parts of that at the centre, over the ring's diameter. */
void shade(Scene &scene, double level, const Settings &settings, std::uint64_t seed)
{
  const vpHomogeneousMatrix &cMo = *scene.cMo;
  const double slope = level / (settings.size * focalLength / cMo[2][3]); // for each pixel
  scene.photometry.gradientU = slope * imageWidth * std::cos(directionFrom(seed));
  scene.photometry.gradientV = slope * imageHeight * std::sin(directionFrom(seed));
  scene.photometry.lightCenter = vpImagePoint(scene.cam.get_v0() + focalLength * cMo[1][3] / cMo[2][3],
                                              scene.cam.get_u0() + focalLength * cMo[0][3] / cMo[2][3]);
}

const std::vector<Disturbance> &disturbances()
{
  static const std::vector<Disturbance> list = {
      {"occlusion", "covered share of the ring's disc", {0., 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.4, 0.5}, cover},
      {"noise", "noise, standard deviation [grey levels]", {0., 2., 5., 10., 15., 20., 30., 40.}, addNoise},
      {"blur", "blur, standard deviation [px]", {0.3, 0.7, 1., 1.5, 2., 3., 4., 5.}, blur},
      {"motion", "motion during the exposure [px]", {0., 1., 2., 4., 6., 8., 12., 16.}, move},
      {"light", "change of the light over the ring's diameter", {0., 0.2, 0.4, 0.6, 0.8, 1., 1.4, 1.8}, shade},
      {"distortion", "radial distortion, coefficient kdu", {-0.4, -0.2, -0.1, 0., 0.1, 0.2, 0.4}, nullptr}};
  return list;
}

/*! The level of "distortion" is a property of the camera, which comes before the pose. */
vpCameraParameters cameraOf(const Disturbance &disturbance, double level)
{
  vpCameraParameters cam = referenceCamera();
  if (disturbance.disturb == nullptr && level != 0.) {
    cam.initPersProjWithDistortion(focalLength, focalLength, cam.get_u0(), cam.get_v0(), -level, level);
  }
  return cam;
}

Series seriesOf(const Settings &settings, const Disturbance &disturbance, double level)
{
  std::ostringstream name;
  name << disturbance.name << '-' << level;
  std::ostringstream title;
  title << disturbance.title << ": " << level;
  Series series;
  series.name = name.str();
  series.title = title.str();
  series.group = disturbance.name;
  series.level = level;
  series.frames = settings.frames.value_or(framesOfLevel);
  series.methods = {Method::Ring, Method::Circle, Method::AprilTag};
  series.stream = 1; // The same poses at all levels of all disturbances, but for the distorted cameras.
  const vpCameraParameters cam = cameraOf(disturbance, level);
  const Disturb disturb = disturbance.disturb;
  series.scene = [settings, cam, disturb, level](unsigned int, std::uint64_t seed) {
    Scene scene;
    scene.cam = cam;
    scene.photometry = photometryOf(settings);
    scene.cMo = randomPose(settings, cam, leastDepth, settings.maximumDistance.value_or(mostDepth),
                           vpMath::rad(settings.maximumAngle.value_or(mostAngle)), seed);
    if (disturb != nullptr) {
      disturb(scene, level, settings, seed);
    }
    return scene;
  };
  return series;
}
} // namespace

Experiment experimentOfResilience(const Settings &settings)
{
  Experiment experiment = {"resilience", "Resilience: occlusion, noise, blur, motion, light, distortion", {}};
  for (const Disturbance &disturbance : disturbances()) {
    for (const double level : disturbance.levels) {
      experiment.series.push_back(seriesOf(settings, disturbance, level));
    }
  }
  return experiment;
}
} // namespace experiments
