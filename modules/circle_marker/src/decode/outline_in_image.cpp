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
 * An outline with its two poses in an image, and what was read at them.
 */

#include "decode/outline_in_image.h"

#include <algorithm>

#include "support/same_family.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
const Judged<SectorReading> &OutlineInImage::sectorsAt(std::size_t pose, const vpCircleMarkerFamily &family)
{
  auto track = std::find_if(m_tracks.begin(), m_tracks.end(), [&](const Track &known) {
    return known.sectors == family.getNbSectors() && isSameLayout(known.layout, family.getLayout());
  });
  if (track == m_tracks.end()) {
    track = m_tracks.begin() + static_cast<std::ptrdiff_t>(m_next);
    m_next = (m_next + 1) % m_tracks.size();
    *track = Track();
    track->sectors = family.getNbSectors();
    track->layout = family.getLayout();
  }
  std::optional<Judged<SectorReading>> &reading = track->readings[pose];
  if (!reading) {
    reading = readSectors(I, camera, poses[pose], family);
  }
  return *reading;
}

const std::optional<RadialProfile> &OutlineInImage::profileAt(std::size_t pose)
{
  std::optional<std::optional<RadialProfile>> &profile = m_profiles[pose];
  if (!profile) {
    profile.emplace(radialProfile(I, camera, poses[pose]));
  }
  return *profile;
}
} // namespace circle_marker
END_VISP_NAMESPACE
