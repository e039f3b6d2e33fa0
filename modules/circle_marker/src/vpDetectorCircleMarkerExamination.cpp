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
 * Outlines through the rooms that read and measure them: chosen from the largest to the smallest, on all threads.
 */

#include "vpDetectorCircleMarkerImpl.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "support/same_family.h"

BEGIN_VISP_NAMESPACE

using namespace circle_marker;

namespace {
// Outlines whose code is in doubt and that are none, at most, before all others in doubt are passed over; and so many
// more for each that is one: where there are small markers there are more. They are measured so many at a time.
constexpr std::size_t mostDoubtsInVain = 16;
constexpr std::size_t doubtsForEachProven = 2;
constexpr std::size_t doubtsAtOnce = 8;
// The same for rings of codes that something covers, of which clutter has less than one in an image
// (bench-circle-marker --phantoms) and a page of text hundreds. To measure and read one takes a millisecond.
constexpr std::size_t mostCoveredInVain = 64;
// And for plain rings of which that is so, whose number must not be at the cost of codes.
constexpr std::size_t mostCoveredRingsInVain = 64;
} // namespace

/*! The outlines through the rooms after them, from the largest to the smallest: read, chosen, measured. An outline that
  is a piece of a chosen one, such as a sector of its code, waits; it gets its turn if that one turns out to be none.
*/
void vpDetectorCircleMarker::Impl::examineAll(const Visit &visit, const Outlines &outlines)
{
  const Deadline &deadline = visit.deadline;
  m_examinations.assign(outlines.size(), Examination());
  m_measured.clear();
  m_doubts = Trials();
  m_doubts.mostInVain = mostDoubtsInVain;
  m_covered = Trials();
  m_covered.mostInVain = mostCoveredInVain;
  m_coveredRings = Trials();
  m_coveredRings.mostInVain = mostCoveredRingsInVain;
  listAttempts(settings.families, m_attempts);
  allowBlurred(visit, outlines);
  bool isOver = false;
  while (!isOver) {
    if (m_workers.getCount() > 1) {
      readTogether(visit, outlines);
    }
    choose(visit, outlines);
    measureChosen(visit, outlines);
    const bool someAreNone = settleChosen();
    isOver = deadline.hasPassed() || !someAreNone;
  }
  if (keepsDebug) {
    keepCandidates(visit, outlines);
  }
}

/*! Reads what is not read yet, from the largest to the smallest, and chooses what is to be measured. */
void vpDetectorCircleMarker::Impl::choose(const Visit &visit, const Outlines &outlines)
{
  m_chosen.clear();
  m_chosenPlaces.reset(static_cast<int>(visit.I.getWidth()), static_cast<int>(visit.I.getHeight()));
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    Examination &examination = m_examinations[i];
    const bool isWaiting = !examination.isOver;
    if (isWaiting && m_chosenPlaces.hold(outlines[i], visit.camera)) {
      continue;
    }
    if (isWaiting && !examination.isRead && !visit.deadline.hasPassed()) {
      read(visit, outlines[i], m_workspaces.front(), examination);
    }
    reserve(outlines[i], examination);
    if (isWaiting && examination.marker) {
      m_chosen.push_back(i);
    }
  }
}

/*! The place of an outline, if it was read as a marker; nothing in it is asked until that is known to be none. */
void vpDetectorCircleMarker::Impl::reserve(const EllipseCandidate &outline, const Examination &examination)
{
  if (isCoveredRing(examination)) { // of which nobody knows yet where its code is
    m_chosenPlaces.add(outline);
  }
  else if (examination.marker) {
    m_chosenPlaces.add(outline, *examination.marker);
  }
}

/*!
  After the chosen ones were measured: those that are none may be of the next family, and what lies inside of them has
  its turn.
  \return Whether some are none.
*/
bool vpDetectorCircleMarker::Impl::settleChosen()
{
  bool someAreNone = false;
  for (const std::size_t i : m_chosen) {
    Examination &examination = m_examinations[i];
    examination.isOver = examination.isFound || examination.attempt == m_attempts.size();
    if (examination.isFound) {
      continue;
    }
    refuse(examination);
    examination.marker.reset();
    examination.isRead = false;
    someAreNone = true;
  }
  return someAreNone;
}

/*! What an outline was last tried as gets the reason why it is none, if there is a new one and it is to be shown. */
void vpDetectorCircleMarker::Impl::refuse(Examination &examination) const
{
  const vpCircleMarkerFamily &family = settings.families[m_attempts[examination.attempt - 1].family];
  for (vpCircleMarkerCandidate &candidate : examination.candidates) {
    if (examination.refusal != vpCircleMarkerReject::NONE && isSameFamily(candidate.family, family)) {
      candidate.reason = examination.refusal;
    }
  }
}

/*!
  The chosen outlines through the room refine. To tell whether one in doubt is a marker takes some milliseconds, and a
  page of text has hundreds that look like one: those that look most like their code are measured first, a few at a
  time, until there were too many that are none. The same with the rings of covered ones.
*/
void vpDetectorCircleMarker::Impl::measureChosen(const Visit &visit, const Outlines &outlines)
{
  for (const std::size_t i : m_chosen) {
    m_examinations[i].place = m_measured.size();
    m_measured.append();
  }
  // The certain ones as they are, the others by their margin, of plain rings that something covers what is seen of
  // them.
  const auto rankOf = [this](std::size_t i) {
    const Recognition &marker = *m_examinations[i].marker;
    const bool isCovered = marker.seen && !marker.measuredRing;
    const int group = isCovered ? (marker.hasCode() ? 2 : 3) : marker.isCertain ? 0 : 1;
    const double clear = group == 3 ? marker.seen->shareOfRing() : marker.code.margin;
    return std::make_tuple(group, group > 0 ? -clear : 0., i);
  };
  std::sort(m_chosen.begin(), m_chosen.end(), [&](std::size_t i, std::size_t j) { return rankOf(i) < rankOf(j); });
  const auto firstOf = [&](int group) {
    const auto isThere = [&](std::size_t i) { return std::get<0>(rankOf(i)) >= group; };
    return static_cast<std::size_t>(std::find_if(m_chosen.begin(), m_chosen.end(), isThere) - m_chosen.begin());
  };
  m_doubts.begin = firstOf(1);
  m_doubts.end = m_covered.begin = firstOf(2);
  m_covered.end = m_coveredRings.begin = firstOf(3);
  m_coveredRings.end = m_chosen.size();
  // All kinds at once: kind by kind, threads would wait for the last one of each. One that may be none takes as long as
  // ten others, so it is begun first; unless time may run out, and the others would not be measured at all.
  const bool areLongestFirst = m_workers.getCount() > 1 && !visit.deadline.isSet();
  m_together.clear();
  takeNext(m_doubts);
  takeNext(m_covered);
  takeNext(m_coveredRings);
  m_together.insert(areLongestFirst ? m_together.end() : m_together.begin(), m_chosen.begin(),
                    m_chosen.begin() + static_cast<std::ptrdiff_t>(m_doubts.begin));
  while (!m_together.empty()) {
    measureTogether(visit, outlines);
    countTaken(m_doubts);
    countTaken(m_covered);
    countTaken(m_coveredRings);
    m_together.clear();
    takeNext(m_doubts);
    takeNext(m_covered);
    takeNext(m_coveredRings);
  }
  passOver(m_doubts);
  passOver(m_covered);
  passOver(m_coveredRings);
}

/*!
  The next few of a kind are to be measured; none, if too many were none. Whatever the number of threads, so many: what
  is measured does not depend on it.
*/
void vpDetectorCircleMarker::Impl::takeNext(Trials &trials)
{
  const bool isOver = trials.inVain >= trials.mostInVain + doubtsForEachProven * trials.proven;
  trials.taken = isOver ? 0 : std::min(doubtsAtOnce, trials.end - trials.begin);
  const auto first = m_chosen.begin() + static_cast<std::ptrdiff_t>(trials.begin);
  m_together.insert(m_together.end(), first, first + static_cast<std::ptrdiff_t>(trials.taken));
}

/*! They were measured. */
void vpDetectorCircleMarker::Impl::countTaken(Trials &trials)
{
  for (const std::size_t end = trials.begin + trials.taken; trials.begin < end; ++trials.begin) {
    ++(m_examinations[m_chosen[trials.begin]].isFound ? trials.proven : trials.inVain);
  }
}

/*! Those that are left of a kind are not measured. */
void vpDetectorCircleMarker::Impl::passOver(Trials &trials)
{
  for (; trials.begin < trials.end; ++trials.begin) {
    m_examinations[m_chosen[trials.begin]].refusal = vpCircleMarkerReject::TOO_MANY;
  }
}

/*! Those that were taken through the room refine, on all threads. */
void vpDetectorCircleMarker::Impl::measureTogether(const Visit &visit, const Outlines &outlines)
{
  m_workers.run(m_together.size(), [&](std::size_t k, unsigned int worker) {
    Examination &examination = m_examinations[m_together[k]];
    const EllipseCandidate &outline = outlines[m_together[k]];
    Workspace &workspace = m_workspaces[worker];
    if (visit.deadline.hasPassed() ||
        (isCoveredRing(examination) && !readCovered(visit, outline, workspace, examination))) {
      examination.isFound = false;
      examination.refusal = vpCircleMarkerReject::NONE; // as a covered one it is what it was as a whole one
    }
    else {
      examination.isFound =
          measureMarker(visit, outline, *examination.marker, workspace, m_measured[examination.place]);
      if (!examination.isFound && m_measured[examination.place].isOtherRing) {
        examination.otherRingOf = m_attempts[examination.attempt - 1].family;
      }
      examination.refusal = vpCircleMarkerReject::UNLIKE_THE_MODEL;
    }
    if (visit.deadline.hasPassed()) { // one that was cut short is not known to be none
      examination.refusal = vpCircleMarkerReject::TIMEOUT;
    }
    m_measured[examination.place].mayBeBlurred = examination.mayBeBlurred;
  });
}

/*!
  Reads on all threads what one thread would read, one outline after the other: none that is a piece of a marker. What
  may be a piece of an outline that is not read yet waits for the next round; nests are seldom deeper than the rounds.
*/
void vpDetectorCircleMarker::Impl::readTogether(const Visit &visit, const Outlines &outlines)
{
  constexpr int rounds = 3;
  for (int round = 0; round < rounds; ++round) {
    const bool isLast = round + 1 == rounds;
    m_chosen.clear();
    m_chosenPlaces.reset(static_cast<int>(visit.I.getWidth()), static_cast<int>(visit.I.getHeight()));
    for (std::size_t i = 0; i < outlines.size(); ++i) {
      const Examination &examination = m_examinations[i];
      const bool isUnread = !examination.isOver && !examination.isRead;
      if ((!isUnread && !examination.marker) || (isUnread && m_chosenPlaces.hold(outlines[i], visit.camera))) {
        continue;
      }
      if (isUnread) {
        m_chosen.push_back(i);
      }
      if (examination.marker) {
        reserve(outlines[i], examination);
      }
      else if (!isLast) {
        m_chosenPlaces.add(outlines[i]);
      }
    }
    m_workers.run(m_chosen.size(), [&](std::size_t k, unsigned int worker) {
      if (!visit.deadline.hasPassed()) {
        read(visit, outlines[m_chosen[k]], m_workspaces[worker], m_examinations[m_chosen[k]]);
      }
    });
  }
}

END_VISP_NAMESPACE
