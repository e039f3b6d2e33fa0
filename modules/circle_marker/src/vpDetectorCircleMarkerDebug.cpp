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
 * What the rooms of the circular marker detector saw.
 */

#include "vpDetectorCircleMarkerImpl.h"

#include <algorithm>
#include <iomanip>
#include <iterator>
#include <sstream>

#include "debug_record.h"

BEGIN_VISP_NAMESPACE

using namespace circle_marker;

/*!
  \return What became of the candidate in words, for instance "golay23 id: 5 margin 0.83" or "golay23: low margin 0.62
  of id 17, 2 corrected".
*/
std::string vpCircleMarkerCandidate::getText() const
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(2);
  if (isOutline) {
    text << family.getName();
  }
  if (reason == vpCircleMarkerReject::NONE) {
    if (id >= 0) {
      text << " id: " << id << " margin " << margin;
    }
    return text.str();
  }
  text << (isOutline ? ": " : "") << vpCircleMarkerRejectName(reason);
  if (id >= 0) {
    text << " " << margin << " of id " << id;
    if (hamming > 0) {
      text << ", " << hamming << " corrected";
    }
  }
  return text.str();
}

/*!
  Adds the outlines in their order to what is shown. Of one inside of a marker, only that it lies there: whether it was
  read before that was known depends on the number of threads.
*/
void vpDetectorCircleMarker::Impl::keepCandidates(const Visit &visit, const Outlines &outlines)
{
  // Where the time was over there are chosen ones that are no markers.
  m_chosenPlaces.reset(static_cast<int>(visit.I.getWidth()), static_cast<int>(visit.I.getHeight()));
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    if (m_examinations[i].isFound) {
      m_chosenPlaces.add(outlines[i], *m_examinations[i].marker);
    }
  }
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    std::vector<vpCircleMarkerCandidate> &candidates = m_examinations[i].candidates;
    if (!m_examinations[i].isFound && m_chosenPlaces.hold(outlines[i], visit.camera)) {
      candidates = {candidateOf(outlines[i], settings.families.front(), vpCircleMarkerReject::INSIDE_OF_A_MARKER)};
    }
    else if (candidates.empty()) {
      candidates = {candidateOf(outlines[i], settings.families.front(), vpCircleMarkerReject::TIMEOUT)};
    }
    std::move(candidates.begin(), candidates.end(), std::back_inserter(debug.candidates));
    candidates.clear();
  }
}

/*!
  \param debug : Whether detect() keeps what its rooms see, for getDebug() and getRejectedCandidates(). Off by default;
  it then takes no time.
*/
void vpDetectorCircleMarker::setDebug(bool debug)
{
  m_impl->keepsDebug = debug;
  m_impl->debug = vpCircleMarkerDebug();
}

/*!
  \return What the rooms saw in the last image: edges, chains, and all candidates with what became of them. Empty
  without setDebug().
*/
const vpCircleMarkerDebug &vpDetectorCircleMarker::getDebug() const
{
  return m_impl->debug;
}

/*!
  \return The candidates of the last image that were not taken for markers, each with its reason. Empty without
  setDebug(). An outline is tried as a marker of each family, and is rejected by each on its own.
*/
std::vector<vpCircleMarkerCandidate> vpDetectorCircleMarker::getRejectedCandidates() const
{
  std::vector<vpCircleMarkerCandidate> rejected;
  const std::vector<vpCircleMarkerCandidate> &all = m_impl->debug.candidates;
  std::copy_if(all.begin(), all.end(), std::back_inserter(rejected),
               [](const vpCircleMarkerCandidate &candidate) { return candidate.reason != vpCircleMarkerReject::NONE; });
  return rejected;
}

END_VISP_NAMESPACE
