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
 * Makes pictures of scenes, measures the markers in them, and asks how well that could have been done.
 */

#ifndef VP_ACCURACY_LABORATORY_H
#define VP_ACCURACY_LABORATORY_H

#include <map>
#include <optional>

#include "common/detectors.h"
#include "record.h"
#include "scene.h"

namespace accuracy {
/*! The least errors of a scene, and the odds of its two poses. */
struct Limit
{
  vpPoseBound bound;
  std::optional<vpPoseSeparation> separation; //!< Nothing: not computed.
  bool isCertain = false; //!< Not computed, because the marker is so large that the two poses cannot be confused.
};

/*! The detectors and pictures of one thread. */
class Laboratory
{
public:
  explicit Laboratory(const Settings &settings) : m_settings(settings) {}

  /*! \e withSeparation: Also for the mirrored pose, if the marker is small enough for it to matter. */
  Limit limitOf(const Scene &scene, bool withSeparation) const;
  Limit limitOfTag(const Scene &scene) const;

  /*! The circular marker. */
  Record measure(const Scene &scene, const Limit &limit);
  /*! ViSP's AprilTag at decimation 1 or 2, its half pixel corrected. */
  Record measureTag(const Scene &scene, const Limit &limit, int decimation);

private:
  void photograph(const Scene &scene, const vpSimulatedMarker &marker);

  Settings m_settings;                                       //!< As given.
  std::map<std::string, CircleDetector> m_circles;           //!< By family and size.
  std::map<std::pair<int, double>, AprilTagDetector> m_tags; //!< By decimation and size.
  vpImage<unsigned char> m_image;                            //!< The last picture.
};
} // namespace accuracy

#endif
