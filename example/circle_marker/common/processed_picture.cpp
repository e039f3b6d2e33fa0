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
 * What becomes of a picture between the sensor and the detector.
 */

#include "common/processed_picture.h"

#include <algorithm>
#include <cmath>

#include <visp3/core/vpException.h>
#include <visp3/core/vpImageConvert.h>
#include <visp3/core/vpImageFilter.h>
#include <visp3/core/vpImageTools.h>

namespace common {
namespace {
constexpr unsigned int enlargement = 2;
constexpr double smoothing = 1.;            // standard deviation, pixels
constexpr unsigned int smoothingKernel = 7; // pixels

void demosaic(vpImage<unsigned char> &I)
{
  vpImage<vpRGBa> colours(I.getHeight(), I.getWidth());
  vpImageConvert::demosaicBGGRToRGBaBilinear(I.bitmap, reinterpret_cast<unsigned char *>(colours.bitmap), I.getWidth(),
                                             I.getHeight());
  vpImageConvert::convert(colours, I);
}

void smooth(vpImage<unsigned char> &I)
{
  vpImage<double> smoothed;
  vpImageFilter::gaussianBlur(I, smoothed, smoothingKernel, smoothing);
  std::transform(smoothed.bitmap, smoothed.bitmap + smoothed.getSize(), I.bitmap,
                 [](double grey) { return static_cast<unsigned char>(std::clamp(std::round(grey), 0., 255.)); });
}

void enlarge(vpImage<unsigned char> &I)
{
  vpImage<unsigned char> enlarged;
  vpImageTools::resize(I, enlarged, enlargement * I.getWidth(), enlargement * I.getHeight(),
                       vpImageTools::INTERPOLATION_LINEAR);
  I = enlarged;
}
} // namespace

double enlargementBy(Processing processing)
{
  return processing == Processing::ENLARGED ? enlargement : 1.;
}

void process(Processing processing, vpImage<unsigned char> &I)
{
  switch (processing) {
  case Processing::NONE:
    break;
  case Processing::DEMOSAICED:
    demosaic(I);
    break;
  case Processing::SMOOTHED:
    smooth(I);
    break;
  case Processing::ENLARGED:
    enlarge(I);
    break;
  }
}

vpImagePoint placeIn(Processing processing, const vpImagePoint &place)
{
  const double scale = enlargementBy(processing);
  const double shift = 0.5 * (scale - 1.); // a pixel's centre is at whole numbers
  return vpImagePoint(scale * place.get_v() + shift, scale * place.get_u() + shift);
}

vpCameraParameters cameraOf(Processing processing, const vpCameraParameters &sensor)
{
  const double scale = enlargementBy(processing);
  if (scale == 1.) {
    return sensor;
  }
  if (sensor.get_projModel() != vpCameraParameters::perspectiveProjWithoutDistortion) {
    throw vpException(vpException::badValue, "the camera of an enlarged picture is known without distortion only");
  }
  const vpImagePoint centre = placeIn(processing, vpImagePoint(sensor.get_v0(), sensor.get_u0()));
  vpCameraParameters camera;
  camera.initPersProjWithoutDistortion(scale * sensor.get_px(), scale * sensor.get_py(), centre.get_u(),
                                       centre.get_v());
  return camera;
}
} // namespace common
