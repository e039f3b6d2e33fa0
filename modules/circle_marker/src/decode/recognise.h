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
 * What marker an outline belongs to, before its pose is refined.
 */

#ifndef VP_CIRCLE_MARKER_RECOGNISE_H
#define VP_CIRCLE_MARKER_RECOGNISE_H

#include <array>
#include <optional>

#include "decode/blurred_reading.h"
#include "decode/identify.h"
#include "decode/outline_in_image.h"
#include "decode/seen_parts.h"
#include "decode/track_pixels.h"
#include "ellipse/ellipse_candidates.h"
#include "pose/hypotheses.h"
#include "support/deadline.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! A recognised marker: its code, if it has one, and its poses with the spin set by the code. */
struct Recognition
{
  vpCircleMarkerFamily family;
  CodeReading code; //!< id -1 without a code.
  PosePair poses;
  std::optional<SeenParts> seen;            //!< Where something covers a part of it.
  bool isRingOfCode = false;                //!< Whether only its ring is to be measured, before its code is read.
  std::optional<MeasuredRing> measuredRing; //!< Then its ring, which was measured before its code was read.
  bool isCertain = true;                    //!< Whether the code was read well enough; else it has to be proven.
  //! Of each sector of the code, as it was read: 0 is white, 1 is black. Where that is better than the code itself.
  std::optional<std::array<float, mostSectors>> darkness;
  //! If it is measured in what an image was before the camera sharpened it, the image as it is, whose grey levels may
  //! have been cut off; else nullptr.
  const vpImage<unsigned char> *asSeen = nullptr;
  std::optional<BlurredPoses> blurred; //!< How well \e poses are known where they were read through a blur.

  /*! Whether it has a code, which may not be read yet. */
  bool hasCode() const { return family.isCoded() || isRingOfCode; }
};

/*! What was read on the way to a code, to be shown: of the pose under which it came farther. */
struct ReadingTrace
{
  MarkerPlane plane;                    //!< The pose.
  std::optional<SectorReading> sectors; //!< Nothing if the track was not read.
  std::optional<CodeReading> code;      //!< The nearest codeword, accepted or not; nothing without one.
};

/*!
  Tells whether an outline with two possible poses is a marker of a family, and which.
  \param seen : The outline in its image.
  \param family : The family.
  \param settings : How strictly a code is read.
  \param trace : If not null, what was read on the way.
  \param mayBeBlurred : Whether it is read through a blur if it looks so, which takes long.
  \param deadline : When to stop reading through a blur.
  \return The marker, or the reason of the pose under which it came farther.
*/
Judged<Recognition> recognise(OutlineInImage &seen, const vpCircleMarkerFamily &family, const DecodeSettings &settings,
                              ReadingTrace *trace = nullptr, bool mayBeBlurred = true,
                              const Deadline &deadline = Deadline());

/*!
  Whether what was read as a marker of a family is rather one of another that is sought, too, with another number of
  sectors: its sectors are read as a code as well, and leave clearly less of the track. Where few sectors change colour
  a marker of 31 sectors may look like a codeword of 23.
*/
bool isRatherOf(OutlineInImage &seen, const vpCircleMarkerFamily &family, const vpCircleMarkerFamily &other,
                const DecodeSettings &settings);

/*!
  A marker whose code could not be read for certain: with the codeword that agrees best, which has to be proven once it
  is measured. Nothing if the inside has no asymmetry as a code's, the track is not made of sectors, or no dark ring
  shows all around an outline that was not found as that of a thin ring.
  \param seen : The outline in its image.
  \param family : The family.
  \param noise : Standard deviation of the image's noise, grey levels.
*/
std::optional<Recognition> recogniseUncertain(OutlineInImage &seen, const vpCircleMarkerFamily &family, double noise);

/*!
  The ring of a marker of a family with a code, of which something covers a part: a plain ring with what is seen of it,
  to be measured before its code is read. With an outline of which a part is missing the poses are not good enough to
  tell what covers the code from the code itself. Its margin is the share of neighbouring sectors that differ, of those
  that are seen: the more the likelier it has a code.
  \return Nothing if less than a third of the ring is seen.
*/
std::optional<Recognition> recogniseCoveredRing(const vpImage<unsigned char> &I, const CameraModel &camera,
                                                const PosePair &poses, const EllipseCandidate &outline,
                                                const vpCircleMarkerFamily &family);

/*!
  A plain ring of which something covers a part, or that reaches out of the image, with what is seen of it. It has to be
  measured to tell whether it is one. Its margin is 1, as that of all without a code.
  \return Nothing if it is no family of rings, the outline is small, or too little is seen.
*/
std::optional<Recognition> recogniseCoveredShape(const OutlineInImage &seen, const vpCircleMarkerFamily &family);

/*!
  Reads the code of such a marker.
  \param I : The image.
  \param camera : Its camera.
  \param ring : Its ring, measured.
  \param twin : The ring's other pose; nothing if that is none.
  \param family : The family.
  \param settings : How strictly a code is read.
  \param memory : Working memory.
  \param deadline : When to stop: it is none then.
*/
Judged<Recognition> recogniseCovered(const vpImage<unsigned char> &I, const CameraModel &camera,
                                     const MeasuredRing &ring, const std::optional<MeasuredRing> &twin,
                                     const vpCircleMarkerFamily &family, const DecodeSettings &settings,
                                     TrackMemory &memory, const Deadline &deadline = Deadline());
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
