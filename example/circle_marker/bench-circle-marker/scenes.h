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
 * Images to measure detectors on: markers on plain and cluttered grounds, and images made to be hard.
 */

#ifndef VP_BENCH_SCENES_H
#define VP_BENCH_SCENES_H

#include <cstdint>
#include <string>
#include <vector>

#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpImage.h>
#include <visp3/circle_marker_simulator/vpMarkerSceneSimulator.h>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace bench {
/*! Outer diameter of the markers' rings, metres. */
constexpr double markerSize = 0.18;

/*! What a frame shows. */
struct SceneOptions
{
  unsigned int width = 1280;      //!< Pixels.
  unsigned int height = 960;      //!< Pixels.
  std::string family = "golay23"; //!< Of the markers.
  unsigned int markers = 1;       //!< How many.
  double leastDiameter = 60.;     //!< Outer diameter of a ring in the image before its tilt, pixels: from this
  double greatestDiameter = 160.; //!< ... to this.
  double mostTilt = 1.0472;       //!< Angle between normal and line of sight: from 0 to this, rad.
  bool clutter = false;           //!< Polygons, discs, rings, lines: 120 on 1.2 million pixels; or plain grey.
  double noise = 2.;              //!< Standard deviation of the pixels' noise, grey levels.
  bool anyLight = false;          //!< Ink, paper, blur, noise, light gradient and gamma are random, too.
  std::uint64_t seed = 1;         //!< The same seed gives the same frame.
};

/*! A frame and what is true of it. */
struct Scene
{
  vpImage<unsigned char> image;
  vpCameraParameters camera;
  std::vector<vpMarkerTruth> truth;
};

/*! A camera whose focal length is that of the reference camera: 1600 pixels for a width of 1280. */
vpCameraParameters cameraOf(unsigned int width, unsigned int height);

/*!
  Ink, paper, blur, noise, light gradient and gamma of any picture that a camera may take.
  \param seed : Of what is random.
*/
vpScenePhotometry anyPhotometry(std::uint64_t seed);

/*!
  A z-aligned pose of any direction of tilt and any spin.
  \param seed : Of what is random.
  \param camera : Without distortion.
  \param diameter : Outer diameter of the ring in the image before its tilt, pixels.
  \param tilt : Angle between normal and line of sight, rad.
  \param u, v : Image of its centre, pixels.
*/
vpHomogeneousMatrix randomPose(std::uint64_t seed, const vpCameraParameters &camera, double diameter, double tilt,
                               double u, double v);

/*! The frame of the options: markers in the cells of a grid, with random positions in them, tilts and spins. */
Scene makeScene(const SceneOptions &options);

/*! The first of a seed's own numbers: those of different seeds do not meet in a million frames; none for seed 1. */
constexpr std::uint64_t firstOfSeed(std::uint64_t seed)
{
  return (seed - 1) * 1000000;
}

/*! Names of the hard images by which phantoms are numbered. */
std::vector<std::string> hardImages();

/*! Names of the hard images whose time is taken: those, and what came later. */
std::vector<std::string> timedImages();

/*!
  An image without markers that is made to be hard.
  \param name : One of timedImages().
  \param width, height : Size, pixels.
  \param seed : Of what is random in it.
  \exception vpException::badValue : If the name is not known.
*/
vpImage<unsigned char> makeHardImage(const std::string &name, unsigned int width, unsigned int height,
                                     std::uint64_t seed = 1);
} // namespace bench

#endif
