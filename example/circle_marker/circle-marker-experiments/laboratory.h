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
 * The simulated camera and the detectors of one thread.
 */

#ifndef VP_EXPERIMENTS_LABORATORY_H
#define VP_EXPERIMENTS_LABORATORY_H

#include <cstdint>
#include <map>
#include <memory>
#include <optional>

#include <visp3/circle_marker_simulator/vpMarkerSceneSimulator.h>
#include <visp3/circle_marker_simulator/vpSimulatedMarker.h>
#include <visp3/core/vpImage.h>

#include "common/detectors.h"
#include "experiment.h"
#include "sample.h"

namespace experiments {
/*! Not to be used by two threads at once. */
class Laboratory
{
public:
  explicit Laboratory(const Settings &settings);

  /*!
    Makes the images of a frame and looks at them with all methods of its series. The outcome, but for the CPU times,
    depends on the settings' seed, the series and the frame alone.
  */
  FrameSamples take(const Series &series, unsigned int frame);

private:
  Sample look(Method method, const Scene &scene, std::uint64_t seed);
  void photograph(const vpSimulatedMarker &marker, const Scene &scene, std::uint64_t seed);
  Sighting sightOf(Method method, const Scene &scene, int id, Sample &sample);
  CircleDetector &detectorFor(Method method, const Scene &scene);

  Settings m_settings;                             //!< As given.
  CircleDetector m_ring;                           //!< For the plain ring.
  CircleDetector m_circle;                         //!< For the marker of this project.
  std::map<std::string, CircleDetector> m_designs; //!< For other designs of it, by nameOf().
  std::unique_ptr<AprilTagDetector> m_tag;         //!< Made when it is first needed.
  std::optional<vpMarkerSceneSimulator> m_camera;  //!< Of usual scenes, for the next one.
  vpImage<unsigned char> m_image;                  //!< The last picture.
};

/*! The seed of a frame: that of the settings, the experiment's stream and the number of the frame. */
std::uint64_t frameSeed(const Settings &settings, const Series &series, unsigned int frame);
} // namespace experiments

#endif
