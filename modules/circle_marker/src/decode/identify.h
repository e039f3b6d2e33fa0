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
 * Identity and spin of a marker from its code track.
 */

#ifndef VP_CIRCLE_MARKER_IDENTIFY_H
#define VP_CIRCLE_MARKER_IDENTIFY_H

#include <optional>

#include "decode/sector_reading.h"
#include "decode/seen_parts.h"
#include "decode/track_pixels.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! How strictly a code is read. */
struct DecodeSettings
{
  unsigned int maximumHamming = 2; //!< Most sectors that are corrected.
  double minimumMargin = 0.6;      //!< Least mean agreement of the soft values with a codeword read without errors.
};

/*! A marker's code, read. */
struct CodeReading
{
  int id = -1;              //!< Identity in the family.
  unsigned int hamming = 0; //!< Number of sectors that were corrected.
  double margin = 0.;       //!< Mean agreement of the soft values with the codeword, in [-1, 1].
  double spin = 0.;         //!< Angle from the plane's x axis to the marker's own, rad, positive toward y.
};

/*!
  The marker whose code is nearest to a reading, or NO_SECTORS, NO_CODEWORD, MIRRORED, or LOW_MARGIN with what was
  refused.
*/
Judged<CodeReading> identify(const SectorReading &reading, const vpCircleMarkerFamily &family,
                             const DecodeSettings &settings);
/*!
  The codeword that agrees best with a reading, however little it does; nothing if the track is not made of sectors. All
  codewords are tried.
  \param reading : The track's sectors.
  \param family : What codes there are.
  \param mayZoneBeDim : Whether the quiet zone, which tells what is white, may be lost in the blur of dark ground.
*/
std::optional<CodeReading> closestCode(const SectorReading &reading, const vpCircleMarkerFamily &family,
                                       bool mayZoneBeDim);
/*!
  The marker of which a part is not seen: of all codewords the one for which its pixels speak most (WordEvidence), if
  they do so by odds of a thousand against all others, and if they tell at least as many sectors as the message has
  bits, after what errors leave unsaid.
  \param reading : The track's sectors.
  \param pixels : The track's pixels.
  \param family : What codes there are.
  \param settings : How strictly a code is read.
  \param seen : What is seen of the marker; where the codeword does not explain the pixels is left out of it.
*/
Judged<CodeReading> identifyCovered(const SectorReading &reading, const TrackPixels &pixels,
                                    const vpCircleMarkerFamily &family, const DecodeSettings &settings,
                                    SeenParts &seen);

/*!
  Whether a codeword that was read as if nothing covered it, whose first sector begins at angle 0, is the likeliest for
  the pixels of a track.
*/
bool isLikeliest(const TrackPixels &pixels, CyclicCode::Word word, const vpCircleMarkerFamily &family);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
