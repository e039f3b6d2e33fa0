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
 * What the estimator does not know of: prints, lenses, light and calibrations that are not as they should be.
 */

#include <cmath>

#include <visp3/core/vpPixelMeterConversion.h>

#include "circle_marker/common/moved_camera.h"
#include "parts.h"

namespace accuracy {
namespace {
vpImagePoint centreOf(const Scene &scene)
{
  const vpMarkerSceneSimulator simulator(scene.camera, 1, 1);
  return simulator.project(scene.cMo[0][3], scene.cMo[1][3], scene.cMo[2][3]);
}

/*! Pixels of the ring's diameter, seen from the front. */
double diameterOf(const Scene &scene)
{
  return scene.camera.get_px() * scene.size / scene.cMo[2][3];
}

void gamma045(Scene &scene, Draws &)
{
  scene.photometry.gamma = 0.45;
}
void gamma22(Scene &scene, Draws &)
{
  scene.photometry.gamma = 2.2;
}
void moreInk(Scene &scene, Draws &)
{
  scene.inkSpread = 0.3e-3;
}
void lessInk(Scene &scene, Draws &)
{
  scene.inkSpread = -0.3e-3;
}

template <int HALVES> void defocus(Scene &scene, Draws &)
{
  scene.photometry.defocusRadius = 0.5 * HALVES;
  scene.modelled.defocusRadius = scene.photometry.defocusRadius;
}

/*! The image moves by `pixels` during the exposure, in any direction. */
template <int PIXELS> void motion(Scene &scene, Draws &draws)
{
  const double way = PIXELS * scene.cMo[2][3] / scene.camera.get_px();
  const double direction = draws.uniform(0., 2. * M_PI);
  scene.motion.twist[0] = way * std::cos(direction);
  scene.motion.twist[1] = way * std::sin(direction);
}

/*! Light that differs by 80 % of its mean from one side of the ring to the other. */
void gradient(Scene &scene, Draws &draws)
{
  const double slope = 0.8 / diameterOf(scene);
  const double direction = draws.uniform(0., 2. * M_PI);
  scene.photometry.gradientU = slope * scene.width * std::cos(direction);
  scene.photometry.gradientV = slope * scene.height * std::sin(direction);
  scene.photometry.lightCenter = centreOf(scene);
}

/*! Half the light on one side of a line across the ring, within half its radius of the centre. */
void shadow(Scene &scene, Draws &draws)
{
  const double direction = draws.uniform(0., 2. * M_PI);
  const double offset = draws.uniform(-0.25, 0.25) * diameterOf(scene);
  const vpImagePoint centre = centreOf(scene);
  scene.photometry.shadow = vpSceneShadow{
      vpImagePoint(centre.get_v() + offset * std::sin(direction), centre.get_u() + offset * std::cos(direction)),
      direction, 0.5, 2.};
}

void jpeg(Scene &scene, Draws &)
{
  scene.photometry.jpegQuality = 80;
}

void bow(Scene &scene, Draws &draws)
{
  scene.bow = draws.bits() % 2 == 0 ? 2e-3 : -2e-3;
  scene.bowAxis = draws.uniform(0., M_PI);
}

// Errors of the calibration: of the image's width, and of the focal length.
constexpr double principalPointError = 0.005;
constexpr double focalLengthError = 0.005;

void principalPoint(Scene &scene, Draws &draws)
{
  const double error = principalPointError * imageWidth;
  const double direction = draws.uniform(0., 2. * M_PI);
  scene.assumed =
      tutorial::movedPrincipalPoint(scene.camera, -error * std::cos(direction), -error * std::sin(direction));
}

void focalLengthOff(Scene &scene, Draws &draws)
{
  const double scale = 1. + (draws.bits() % 2 == 0 ? focalLengthError : -focalLengthError);
  scene.assumed.initPersProjWithoutDistortion(scale * scene.camera.get_px(), scale * scene.camera.get_py(),
                                              scene.camera.get_u0(), scene.camera.get_v0());
}

/*! The same, and the detector is told how well the camera is known. */
void statedPrincipalPoint(Scene &scene, Draws &draws)
{
  principalPoint(scene, draws);
  scene.assumedCovariance.resize(4, 4);
  const double variance = 0.5 * std::pow(principalPointError * imageWidth, 2.); // half of it each way
  scene.assumedCovariance[2][2] = scene.assumedCovariance[3][3] = variance;
}

void statedFocalLength(Scene &scene, Draws &draws)
{
  focalLengthOff(scene, draws);
  scene.assumedCovariance.resize(4, 4);
  for (unsigned int i = 0; i < 2; ++i) { // px and py are off together
    for (unsigned int j = 0; j < 2; ++j) {
      scene.assumedCovariance[i][j] = std::pow(focalLengthError * scene.camera.get_px(), 2.);
    }
  }
}

/*! What comes between the sensor and the detector. */
template <Processing PROCESSING> void processed(Scene &scene, Draws &)
{
  scene.processing = PROCESSING;
  scene.assumed = cameraOf(PROCESSING, scene.assumed);
}

/*! All of the light, the print and the lens; the calibration is no matter of the estimator's. */
void everything(Scene &scene, Draws &draws)
{
  gamma22(scene, draws);
  moreInk(scene, draws);
  defocus<2>(scene, draws);
  motion<2>(scene, draws);
  gradient(scene, draws);
  shadow(scene, draws);
  jpeg(scene, draws);
  bow(scene, draws);
}

Camera radial(double kud)
{
  Camera camera;
  camera.parameters.initPersProjWithDistortion(focalLength, focalLength, 0.5 * (imageWidth - 1.),
                                               0.5 * (imageHeight - 1.), kud, -kud);
  return camera;
}

/*! A lens that sees 60 degrees off its axis in the corners of the image. */
Camera fisheye()
{
  Camera camera;
  camera.parameters.initProjWithKannalaBrandtDistortion(740., 740., 0.5 * (imageWidth - 1.), 0.5 * (imageHeight - 1.),
                                                        {0.03, -0.01, 0.004, -0.001});
  return camera;
}
} // namespace

const std::vector<Factor> &factors()
{
  static const std::vector<Factor> all = {
      {"none", nullptr, {}, false},
      {"gamma 0.45", gamma045, {}, false},
      {"gamma 2.2", gamma22, {}, false},
      {"ink spread +0.3 mm", moreInk, {}, false},
      {"ink spread -0.3 mm", lessInk, {}, false},
      {"defocus radius 0.5 px", defocus<1>, {}, true},
      {"defocus radius 1 px", defocus<2>, {}, true},
      {"defocus radius 2 px", defocus<4>, {}, true},
      {"motion 2 px", motion<2>, {}, false},
      {"motion 4 px", motion<4>, {}, false},
      {"light gradient 80 %", gradient, {}, false},
      {"shadow edge", shadow, {}, false},
      {"JPEG quality 80", jpeg, {}, false},
      {"bow 2 mm", bow, {}, false},
      {"principal point 0.5 % off", principalPoint, {}, false},
      {"focal length 0.5 % off", focalLengthOff, {}, false},
      {"kud -0.2", nullptr, radial(-0.2), false},
      {"kud +0.2", nullptr, radial(0.2), false},
      {"fisheye", nullptr, fisheye(), false},
      {"all at once", everything, {}, true},
      {"principal point 0.5 % stated", statedPrincipalPoint, {}, false},
      {"focal length 0.5 % stated", statedFocalLength, {}, false},
      {"colour sensor", processed<Processing::DEMOSAICED>, {}, false},
      {"smoothed 1 px", processed<Processing::SMOOTHED>, {}, false},
      {"enlarged 2 times", processed<Processing::ENLARGED>, {}, false},
  };
  return all;
}
} // namespace accuracy
