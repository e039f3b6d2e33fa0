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

#ifndef VP_CIRCLE_MARKER_OUTLINE_IN_IMAGE_H
#define VP_CIRCLE_MARKER_OUTLINE_IN_IMAGE_H

#include <array>
#include <optional>

#include "decode/radial_profile.h"
#include "decode/sector_reading.h"
#include "ellipse/ellipse_candidate.h"
#include "pose/hypotheses.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  What is asked whether it is a marker. To read its track, and its profile from the centre outward, takes most of that,
  and families ask for the same ones, those with a code twice, for certain and in doubt: so they are kept.
*/
class OutlineInImage
{
public:
  /*! All that is given has to live as long. */
  OutlineInImage(const vpImage<unsigned char> &image, const CameraModel &itsCamera, const PosePair &bothPoses,
                 const EllipseCandidate &candidate)
      : I(image), camera(itsCamera), poses(bothPoses), outline(candidate)
  {
  }

  /*! readSectors() at a pose, by its number; as it was read if one of the last tracks that were asked for is alike. */
  const Judged<SectorReading> &sectorsAt(std::size_t pose, const vpCircleMarkerFamily &family);

  /*! radialProfile() at a pose; as it was read if it was. */
  const std::optional<RadialProfile> &profileAt(std::size_t pose);

  const vpImage<unsigned char> &I;
  const CameraModel &camera;
  const PosePair &poses;
  const EllipseCandidate &outline;

private:
  /*! A track by what it is read by. */
  struct Track
  {
    unsigned int sectors = 0;
    vpCircleMarkerLayout layout;
    std::array<std::optional<Judged<SectorReading>>, 2> readings; //!< At each pose.
  };

  std::array<Track, 2> m_tracks; //!< Families with the default layout have two: of 23 and of 31 sectors.
  std::size_t m_next = 0;        //!< Where the next one goes.
  std::array<std::optional<std::optional<RadialProfile>>, 2> m_profiles; //!< At each pose, once it was asked for.
};
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
