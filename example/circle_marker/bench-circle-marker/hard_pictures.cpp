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
 * What becomes of hard pictures between the sensor and the detector.
 */

#include "hard_pictures.h"

#include "common/darkened_picture.h"
#include "common/processed_picture.h"
#include "common/sharpened_picture.h"
#include "common/toned_picture.h"
#include "common/undistorted_picture.h"

namespace bench {
namespace {
common::Processing processingOf(const Hardship &hardship)
{
  return hardship.name == "colour sensor, noise" ? common::Processing::DEMOSAICED
         : hardship.name == "smoothed, noise"    ? common::Processing::SMOOTHED
         : hardship.name == "enlarged, noise"    ? common::Processing::ENLARGED
                                                 : common::Processing::NONE;
}

bool isUndistorted(const Hardship &hardship)
{
  return hardship.name == "undistorted, noise";
}

// Width of the camera's unsharp mask, pixels; 0 if it does not sharpen.
double maskOf(const Hardship &hardship)
{
  return hardship.name == "sharpened by 1 pixel" ? 1. : hardship.name == "sharpened by 2 pixels" ? 2. : 0.;
}

// The picture without the lens's distortion, with what is true of it.
void undistort(Scene &scene)
{
  common::undistort(scene.camera, scene.image);
  for (vpMarkerTruth &truth : scene.truth) {
    truth.center = common::undistortedPlace(scene.camera, truth.center);
    truth.ellipse->center = common::undistortedPlace(scene.camera, truth.ellipse->center);
  }
  scene.camera = common::straightened(scene.camera);
}
} // namespace

bool isOfPictures(const Hardship &hardship)
{
  return isUndistorted(hardship) || processingOf(hardship) != common::Processing::NONE;
}

vpCameraParameters hardCamera(const Hardship &hardship, unsigned int width, unsigned int height)
{
  constexpr double kdu = 0.2; // a wide angle: at the image's corners it moves points by 0.05 of their radius
  vpCameraParameters camera = cameraOf(width, height);
  if (isUndistorted(hardship)) {
    camera.initPersProjWithDistortion(camera.get_px(), camera.get_py(), camera.get_u0(), camera.get_v0(), -kdu, kdu);
  }
  return camera;
}

void processPicture(const Hardship &hardship, double noise, std::uint64_t seed, Scene &scene)
{
  if (isUndistorted(hardship)) {
    return undistort(scene);
  }
  if (const double sigma = maskOf(hardship); sigma > 0.) {
    return common::sharpen(hardship.level, sigma, scene.image);
  }
  if (hardship.name == "contrast raised" || hardship.name == "gamma 0.45, contrast raised") {
    return common::raiseContrast(hardship.level, scene.image);
  }
  if (hardship.name == "darker corners") {
    return common::darkenCorners(hardship.level, scene.camera, noise, seed, scene.image);
  }
  const common::Processing processing = processingOf(hardship);
  common::process(processing, scene.image);
  scene.camera = common::cameraOf(processing, scene.camera);
  const double scale = common::enlargementBy(processing);
  for (vpMarkerTruth &truth : scene.truth) {
    truth.center = common::placeIn(processing, truth.center);
    truth.ellipse->center = common::placeIn(processing, truth.ellipse->center);
    truth.ellipse->semiAxisA *= scale;
    truth.ellipse->semiAxisB *= scale;
  }
}
} // namespace bench
