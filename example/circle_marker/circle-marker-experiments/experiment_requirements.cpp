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
 * The requirements of the thesis's section 2.2.1, as series of frames.
 */

#include <cmath>

#include <visp3/core/vpExponentialMap.h>
#include <visp3/core/vpMath.h>
#include <visp3/core/vpRotationMatrix.h>
#include <visp3/core/vpThetaUVector.h>
#include <visp3/core/vpTranslationVector.h>

#include "common/reference_camera.h"
#include "experiment.h"
#include "poses.h"

namespace experiments {
namespace {
constexpr unsigned int framesOfSeries = 300;

Series seriesOf(const Settings &settings, const std::string &name, const std::string &title,
                const std::function<void(Scene &, unsigned int, std::uint64_t)> &complete)
{
  Series series;
  series.name = name;
  series.title = title;
  series.frames = settings.frames.value_or(framesOfSeries);
  series.methods = {Method::Circle};
  series.stream = 1;
  series.scene = [settings, complete](unsigned int frame, std::uint64_t seed) {
    Scene scene;
    scene.cam = referenceCamera();
    scene.photometry = photometryOf(settings);
    complete(scene, frame, seed);
    return scene;
  };
  return series;
}

Series atOnePlace(const Settings &settings, double depth, double degrees)
{
  const std::string place = std::to_string(std::lround(depth)) + "m-" + std::to_string(std::lround(degrees));
  const std::string title =
      std::to_string(std::lround(depth)) + " m, " + std::to_string(std::lround(degrees)) + "° to the line of sight";
  Series series =
      seriesOf(settings, place, title, [settings, depth, degrees](Scene &scene, unsigned int, std::uint64_t seed) {
        scene.cMo = poseAt(settings, scene.cam, depth, vpMath::rad(degrees), seed);
      });
  series.methods = {Method::Circle, Method::Ring}; // The ring for what can be detected without being read.
  return series;
}

/*! A marker that neither it nor the camera moves: only the noise differs. */
Series stillSequence(const Settings &settings)
{
  return seriesOf(settings, "still", "still, 5 m, 30°", [](Scene &scene, unsigned int, std::uint64_t) {
    scene.cMo = vpHomogeneousMatrix(vpTranslationVector(0.4, -0.3, 5.),
                                    vpRotationMatrix(vpThetaUVector(vpMath::rad(30.), 0., 0.)));
  });
}

/*! A robot drives up to the marker and past it, its camera swaying: 15 frames a second, exposed for 1 ms. */
Series movingSequence(const Settings &settings)
{
  return seriesOf(settings, "moving", "moving at 0.5 m/s, 10 m to 2 m and back",
                  [](Scene &scene, unsigned int frame, std::uint64_t) {
                    constexpr double framesPerSecond = 15.; // The thesis's camera, table 5.2.
                    constexpr double exposure = 1e-3;       // Seconds: the thesis's requirement.
                    constexpr double speed = 0.5;           // Metres a second.
                    const double time = frame / framesPerSecond;
                    const double leg = std::fmod(speed * time, 16.); // 8 m there, 8 m back.
                    const bool isComing = leg < 8.;
                    const double depth = isComing ? 10. - leg : leg - 6.;
                    const double sway = vpMath::rad(5.) * std::sin(2. * M_PI * 0.5 * time); // 5 degrees at 0.5 Hz.
                    const double swayRate = vpMath::rad(5.) * 2. * M_PI * 0.5 * std::cos(2. * M_PI * 0.5 * time);
                    const vpRotationMatrix cameraTurn(vpThetaUVector(0., sway, 0.));
                    const vpHomogeneousMatrix turned(vpTranslationVector(0., 0., 0.), cameraTurn);
                    scene.cMo =
                        turned * vpHomogeneousMatrix(vpTranslationVector(0.05 * depth, -0.03 * depth, depth),
                                                     vpRotationMatrix(vpThetaUVector(0., vpMath::rad(25.), 0.)));
                    scene.motion.twist[2] = (isComing ? speed : -speed) * exposure;
                    scene.motion.twist[4] = -swayRate * exposure;
                  });
}

/*! A fast vehicle: 5 m/s across the line of sight, 1 rad/s about it, seen for 1 ms at 3 to 10 m. */
Series fastSequence(const Settings &settings)
{
  return seriesOf(settings, "shutter", "5 m/s and 1 rad/s, exposed for 1 ms, 3 m to 10 m, to 60°",
                  [settings](Scene &scene, unsigned int, std::uint64_t seed) {
                    constexpr double exposure = 1e-3;
                    scene.cMo = randomPose(settings, scene.cam, 3., 10., vpMath::rad(60.), seed);
                    scene.motion.twist[0] = 5. * exposure * std::cos(2. * M_PI * uniformFrom(Draw::Direction, seed));
                    scene.motion.twist[1] = 5. * exposure * std::sin(2. * M_PI * uniformFrom(Draw::Direction, seed));
                    scene.motion.twist[4] = 1. * exposure;
                  });
}

/*! The range that the thesis asks for, disturbed in one way. */
Series inRange(const Settings &settings, const std::string &name, const std::string &title,
               const std::function<void(Scene &, std::uint64_t)> &disturb)
{
  return seriesOf(settings, name, title + ", 1 m to 10 m, to 60°",
                  [settings, disturb](Scene &scene, unsigned int, std::uint64_t seed) {
                    scene.cMo = randomPose(settings, scene.cam, 1., 10., vpMath::rad(60.), seed);
                    disturb(scene, seed);
                  });
}

/*! Something of a random grey covers a part of the ring's disc. */
void coverTenth(Scene &scene, std::uint64_t seed)
{
  constexpr double share = 0.1;
  constexpr double darkest = 20.; // grey levels
  constexpr double brightest = 230.;
  scene.cover = {share, 2. * M_PI * uniformFrom(Draw::Direction, seed),
                 darkest + (brightest - darkest) * uniformFrom(Draw::Cover, seed)};
}

/*! A shadow: of the whole image, or with its edge through the marker's centre. */
void shade(Scene &scene, double factor, const vpImagePoint &edge, double direction)
{
  vpSceneShadow shadow;
  shadow.edge = edge;
  shadow.direction = direction;
  shadow.factor = factor;
  scene.photometry.shadow = shadow;
}

void dim(Scene &scene, std::uint64_t)
{
  constexpr double quarter = 0.25;
  shade(scene, quarter, vpImagePoint(0., -1000.), 0.); // All of the image is on the dark side.
}

void castShadow(Scene &scene, std::uint64_t seed)
{
  constexpr double half = 0.5;
  const vpHomogeneousMatrix &cMo = *scene.cMo;
  const vpImagePoint centre(scene.cam.get_v0() + scene.cam.get_py() * cMo[1][3] / cMo[2][3],
                            scene.cam.get_u0() + scene.cam.get_px() * cMo[0][3] / cMo[2][3]);
  shade(scene, half, centre, 2. * M_PI * uniformFrom(Draw::Direction, seed));
}

/*! Pictures without a marker, full of discs, rings, bars, polygons and strokes. */
Series clutter(const Settings &settings)
{
  return seriesOf(settings, "clutter", "clutter without a marker", [](Scene &scene, unsigned int, std::uint64_t seed) {
    scene.clutterSeed = seedOf(Draw::Clutter, seed);
  });
}
} // namespace

Experiment experimentOfRequirements(const Settings &settings)
{
  Experiment experiment = {"requirements", "Requirements of the thesis (2.2.1)", {}};
  for (const double depth : {20., 10.}) {
    for (const double degrees : {0., 30., 45., 60.}) {
      experiment.series.push_back(atOnePlace(settings, depth, degrees));
    }
  }
  experiment.series.push_back(inRange(settings, "range", "undisturbed", [](Scene &, std::uint64_t) {}));
  experiment.series.push_back(inRange(settings, "covered", "a tenth of the ring's disc covered", coverTenth));
  experiment.series.push_back(inRange(settings, "dim", "a quarter of the light", dim));
  experiment.series.push_back(inRange(settings, "shadow", "the edge of a shadow across the marker", castShadow));
  experiment.series.push_back(stillSequence(settings));
  experiment.series.push_back(movingSequence(settings));
  experiment.series.push_back(fastSequence(settings));
  experiment.series.push_back(clutter(settings));
  return experiment;
}
} // namespace experiments
