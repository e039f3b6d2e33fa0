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
 * What is photographed: a marker, its pose, the camera, the light.
 */

#ifndef VP_ACCURACY_SCENE_H
#define VP_ACCURACY_SCENE_H

#include <cstdint>
#include <optional>
#include <string>

#include <visp3/circle_marker/vpCircleMarkerFamily.h>
#include <visp3/circle_marker_simulator/vpMarkerSceneSimulator.h>
#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpMatrix.h>

#include "common/processed_picture.h"
#include "common/seeds.h"
#include "settings.h"

namespace accuracy {
/*! A stream of random numbers that depends on nothing but its seed. */
class Draws
{
public:
  explicit Draws(std::uint64_t seed) : m_seed(seed) {}

  std::uint64_t bits() { return mixed(m_seed, m_count++); }
  double uniform(double low, double high) { return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53; }
  /*! Even in the logarithm. */
  double scale(double low, double high);
  int index(int size) { return static_cast<int>(bits() % static_cast<std::uint64_t>(size)); }

private:
  std::uint64_t m_seed;      //!< Of the stream.
  std::uint64_t m_count = 0; //!< Numbers drawn.
};

/*! Inner over outer diameter of the plain rings: the thesis's. The detector is told. */
constexpr double ringRatio = 0.7;

vpCircleMarkerFamily familyOf(const std::string &name);

/*! A camera with the image it is calibrated for; only a window of that image is made. */
struct Camera
{
  vpCameraParameters parameters = referenceCamera();
  unsigned int width = imageWidth, height = imageHeight;
};

/*! A marker before a camera. */
struct Scene
{
  std::string family = "golay23";
  int id = 0;
  double size = defaultRing;          //!< Outer diameter of the ring, metres.
  vpHomogeneousMatrix cMo;            //!< z into the marker, metres.
  vpCameraParameters camera;          //!< Of the window.
  vpCameraParameters assumed;         //!< What the detector is told.
  vpMatrix assumedCovariance;         //!< And how well that is known; empty: exactly.
  unsigned int width = 0, height = 0; //!< Of the window, pixels.
  vpScenePhotometry photometry;       //!< Of the picture.
  vpScenePhotometry modelled;         //!< Of the bound: what the model knows.
  double ground = 110.;               //!< Grey level behind the sheet.
  double inkSpread = 0.;              //!< Metres.
  double bow = 0., bowAxis = 0.;      //!< Of the sheet, metres and radians.
  vpSceneMotion motion;
  Processing processing = Processing::NONE; //!< What becomes of the picture.
  std::uint64_t noiseSeed = 0;

  /*! The circular marker at its pose, flat and sharp: what the bound is of. */
  vpSimulatedMarker marker() const;
  /*! The AprilTag that fills the same sheet. */
  vpSimulatedMarker tag() const;
  /*! A marker as printed: ink spread and bow. */
  vpSimulatedMarker printed(vpSimulatedMarker marker) const;
};

/*! Ranges that scenes are drawn from. */
struct Ranges
{
  double leastDiameter = 17., mostDiameter = 400.; //!< Of the image of the ring's outer edge, pixels; logarithm even.
  std::optional<double> distance;                  //!< Metres, instead of the diameter.
  double leastTilt = 8., mostTilt = 75.;           //!< Degrees.
  double leastNoise = 1., mostNoise = 5.;          //!< Grey levels.
  double leastBlur = 0.5, mostBlur = 1.2;          //!< Pixels.
  double leastContrast = 60., mostContrast = 190.; //!< Grey levels.
  double mostPaper = 235.;                         //!< Grey level.
  double size = defaultRing;                       //!< Metres.
  Camera camera;
  double extent = 1.;      //!< Width of what must be in the window, over the ring's diameter.
  bool wholeImage = false; //!< The camera's whole image instead of a window of 640 x 480.
};

/*! The ranges with one value of noise, blur and contrast: the reference. */
Ranges withReferenceLight(Ranges ranges);

/*! A scene; the ring lies in the camera's image, and in the window. */
Scene draw(const Ranges &ranges, const std::string &family, std::uint64_t seed);
} // namespace accuracy

#endif
