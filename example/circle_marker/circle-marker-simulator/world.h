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
 * The simulated camera that the user moves through a room.
 */

#ifndef VP_SIMULATOR_WORLD_H
#define VP_SIMULATOR_WORLD_H

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <visp3/circle_marker/vpDetectorCircleMarker.h>
#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpImage.h>

#include "common/room.h"

namespace simulator {
/*! What the user can change. */
struct Knobs
{
  double noise = 2.;    //!< Standard deviation, grey levels.
  double blur = 0.7;    //!< Standard deviation, pixels.
  double light = 1.;    //!< 1: paper is at 220 of 255 grey levels.
  double gradient = 0.; //!< Change of the light over the image's width, share.
  int cover = 0;        //!< Share of each marker that is covered, tenths, from the left.
};

/*! One marker in the image: where it is, and what was made of it. */
struct Comparison
{
  int id = -1;
  std::string name;            //!< From the room's file.
  double distance = 0.;        //!< True distance of its centre, metres.
  double tilt = 0.;            //!< True angle between normal and line of sight, radians.
  bool isWhole = false;        //!< Whether all of it is in the image.
  std::optional<double> error; //!< Distance of measured and true centre, metres; nothing: not found.
  double normalError = 0.;     //!< Angle of measured and true normal, radians.
  double sigmas = 0.;          //!< Error of the pose in its own standard deviations: root of the mean square.
};

/*! An image and what is known of it. */
struct Shot
{
  vpImage<unsigned char> image;
  std::vector<vpCircleMarkerDetection> detections;
  std::vector<Comparison> markers; //!< All that the camera has before it, the nearest first.
  unsigned int phantoms = 0;       //!< Found, but not there.
};

/*!
  Room, camera and detector.
*/
class World
{
public:
  World(const common::Room &room, const vpCameraParameters &cam, unsigned int width, unsigned int height,
        std::uint64_t seed);

  /*! What the camera sees from wMc, each time with noise of its own. */
  Shot look(const vpHomogeneousMatrix &wMc, const Knobs &knobs);

  const common::Room &room() const { return m_room; }
  const vpCameraParameters &camera() const { return m_cam; }

private:
  common::Room m_room;               //!< With its markers.
  vpCameraParameters m_cam;          //!< The camera.
  vpMarkerSceneSimulator m_scene;    //!< Draws.
  vpDetectorCircleMarker m_detector; //!< Detects.
  std::uint64_t m_seed;              //!< Of the noise.
  std::uint64_t m_images = 0;        //!< So far.
};
} // namespace simulator

#endif
