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

BEGIN_VISP_NAMESPACE

using namespace circle_marker;

namespace {
// Outlines whose code is in doubt and that are none, at most, before all others in doubt are passed over; and so many
// more for each that is one: where there are small markers there are more. They are measured so many at a time.
constexpr std::size_t mostDoubtsInVain = 16;
constexpr std::size_t doubtsForEachProven = 2;
constexpr std::size_t doubtsAtOnce = 8;
} // namespace

/*! The outlines through the rooms after them, from the largest to the smallest: read, chosen, measured. An outline that
  is a piece of a chosen one, such as a sector of its code, waits; it gets its turn if that one turns out to be none.
*/
void vpDetectorCircleMarker::Impl::examineAll(const Visit &visit, const Outlines &outlines)
{
  const Deadline &deadline = visit.deadline;
  m_examinations.assign(outlines.size(), Examination());
  m_measured.clear();
  m_doubtsInVain = 0;
  m_doubtsProven = 0;
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
    if (examination.marker) {
      m_chosenPlaces.add(outlines[i], *examination.marker);
    }
    if (isWaiting && examination.marker) {
      m_chosen.push_back(i);
    }
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
    if (!examination.candidates.empty()) {
      examination.candidates.back().reason = examination.refusal;
    }
    examination.marker.reset();
    examination.isRead = false;
    someAreNone = true;
  }
  return someAreNone;
}

/*!
  The chosen outlines through the room refine. To tell whether one in doubt is a marker takes some milliseconds, and a
  page of text has hundreds that look like one: those that look most like their code are measured first, a few at a
  time, until there were too many that are none.
*/
void vpDetectorCircleMarker::Impl::measureChosen(const Visit &visit, const Outlines &outlines)
{
  for (const std::size_t i : m_chosen) {
    m_examinations[i].place = m_measured.size();
    m_measured.append();
  }
  // Those that are certain come first, as they are, then the others by their margin.
  const auto margin = [this](std::size_t i) {
    const Recognition &marker = *m_examinations[i].marker;
    return marker.isCertain ? HUGE_VAL : marker.code.margin;
  };
  std::sort(m_chosen.begin(), m_chosen.end(),
            [&](std::size_t i, std::size_t j) { return margin(i) != margin(j) ? margin(i) > margin(j) : i < j; });
  const auto isCertain = [this](std::size_t i) { return m_examinations[i].marker->isCertain; };
  const auto inDoubt = std::find_if_not(m_chosen.begin(), m_chosen.end(), isCertain);
  auto begin = static_cast<std::size_t>(inDoubt - m_chosen.begin());
  measureTogether(visit, outlines, 0, begin);
  // Whatever the number of threads, so many: what is measured does not depend on it.
  while (begin < m_chosen.size() && m_doubtsInVain < mostDoubtsInVain + doubtsForEachProven * m_doubtsProven) {
    const std::size_t end = std::min(begin + doubtsAtOnce, m_chosen.size());
    measureTogether(visit, outlines, begin, end);
    for (; begin < end; ++begin) {
      ++(m_examinations[m_chosen[begin]].isFound ? m_doubtsProven : m_doubtsInVain);
    }
  }
  for (; begin < m_chosen.size(); ++begin) {
    m_examinations[m_chosen[begin]].refusal = vpCircleMarkerReject::TOO_MANY;
  }
}

/*! Chosen outlines through the room refine, on all threads. */
void vpDetectorCircleMarker::Impl::measureTogether(const Visit &visit, const Outlines &outlines, std::size_t begin,
                                                   std::size_t end)
{
  m_workers.run(end - begin, [&](std::size_t task, unsigned int worker) {
    const std::size_t k = begin + task;
    Examination &examination = m_examinations[m_chosen[k]];
    examination.isFound =
        !visit.deadline.hasPassed() && measureMarker(visit, outlines[m_chosen[k]], *examination.marker,
                                                     m_workspaces[worker], m_measured[examination.place]);
    // One that was cut short is not known to be none.
    examination.refusal =
        visit.deadline.hasPassed() ? vpCircleMarkerReject::TIMEOUT : vpCircleMarkerReject::UNLIKE_THE_MODEL;
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
        m_chosenPlaces.add(outlines[i], *examination.marker);
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
