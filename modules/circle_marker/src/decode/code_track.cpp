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
 * Code track of a marker: from samples along it to the grey levels of its sectors.
 */

#include "decode/code_track.h"

#include <algorithm>
#include <cmath>

#include "decode/sector_equations.h"
#include "support/median.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// From this length of a sector, pixels, the steps between sectors stand apart and tell the phase (its mean over the
// track: oblique markers have shorter ones). Below it all phases are tried.
constexpr double stepsApart = 2.5;
// A sample agrees with its sector to this share of the contrast; else the edge of what covers a part of it lies there.
constexpr double mostOdd = 0.25;
// A sector's grey level is that of the others of its kind to this share of the contrast, and to more by this times the
// blur in units of a sector; and that of ink or paper to twice as much.
constexpr double mostOff = 0.06;
constexpr double offByBlur = 0.25;
// How far a sector beside a covered one is believed.
constexpr double besideCovered = 0.7;

// The phase told by the steps between sectors: that of the harmonic of the squared steps that has one period a sector.
// Nothing if the sectors are too short for the steps to stand apart.
std::optional<unsigned int> likelyPhase(const CodeTrack &track, unsigned int sectors)
{
  double pixelAngle = 0.; // mean angle of a pixel along the track
  double c = 0.;
  double s = 0.;
  for (unsigned int i = 0; i < track.samples; ++i) {
    const unsigned int next = (i + 1) % track.samples;
    // Where something covers the track, a step may be its own edge.
    const double step = std::min(track.weight[i], track.weight[next]) * (track.grey[next] - track.grey[i]);
    // The step lies between samples i and i + 1, which are half a sample after their numbers: at i + 1.
    const double angle = 2. * M_PI * (i + 1) * sectors / track.samples;
    c += step * step * std::cos(angle);
    s += step * step * std::sin(angle);
    pixelAngle += track.blur[i] / (trackBlur * track.samples);
  }
  if (2. * M_PI / sectors < stepsApart * pixelAngle) {
    return std::nullopt;
  }
  const double phase = std::atan2(s, c) / (2. * M_PI); // of a sector
  return static_cast<unsigned int>(std::lround(phasesPerSector * (phase + 1.))) % phasesPerSector;
}

// Splits the grey levels of the sectors that are seen in two groups with the least spread inside them; returns the
// middle and half the distance. Nothing if fewer than two are seen.
std::optional<std::pair<double, double>> splitInTwo(const SectorGreys &greys,
                                                    const std::array<double, mostSectors> &seen)
{
  std::array<double, mostSectors> sorted;
  std::size_t n = 0;
  double total = 0.;
  for (Eigen::Index k = 0; k < greys.size(); ++k) {
    if (seen[static_cast<std::size_t>(k)] >= leastSeen) {
      sorted[n++] = greys[k];
      total += greys[k];
    }
  }
  std::sort(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(n));
  double best = -1.;
  std::optional<std::pair<double, double>> split;
  double below = 0.;
  for (std::size_t i = 1; i < n; ++i) {
    below += sorted[i - 1];
    const double dark = below / static_cast<double>(i);
    const double bright = (total - below) / static_cast<double>(n - i);
    const double between = static_cast<double>(i) * static_cast<double>(n - i) * (bright - dark) * (bright - dark);
    if (between > best) {
      best = between;
      split = {0.5 * (bright + dark), 0.5 * (bright - dark)};
    }
  }
  return split;
}

// Sector of a sample.
std::size_t sectorAt(const CodeTrack &track, unsigned int sample, double phase, unsigned int sectors)
{
  const double angle = 2. * M_PI * (sample + 0.5) / track.samples - phase + 2. * M_PI;
  return static_cast<std::size_t>(angle / (2. * M_PI) * sectors) % sectors;
}

// Share of each sector's samples that are seen.
void findSeen(const CodeTrack &track, double phase, SectorReading &reading)
{
  std::array<double, mostSectors> all{};
  reading.seen.fill(0.);
  for (unsigned int i = 0; i < track.samples; ++i) {
    const std::size_t sector = sectorAt(track, i, phase, reading.sectors);
    reading.seen[sector] += track.weight[i];
    all[sector] += 1.;
  }
  for (unsigned int k = 0; k < reading.sectors; ++k) {
    reading.seen[k] /= std::max(all[k], 1.);
  }
}

/*! The best solution of a track. */
struct Solution
{
  SectorGreys greys;
  double squares = HUGE_VAL;
};

Solution solveAllPhases(const CodeTrack &track, SectorReading &reading)
{
  Solution best;
  const std::optional<unsigned int> likely = likelyPhase(track, reading.sectors);
  const unsigned int first = likely ? *likely + phasesPerSector - 1 : 0;
  const unsigned int count = likely ? 3 : phasesPerSector; // the likely one between its neighbours
  for (unsigned int i = first; i < first + count; ++i) {
    const double phase = 2. * M_PI * (i % phasesPerSector) / (phasesPerSector * reading.sectors);
    Solution solution;
    solution.squares = solveSectors(track, reading.sectors, phase, solution.greys);
    if (solution.squares < best.squares) {
      best = solution;
      reading.phase = phase;
    }
  }
  findSeen(track, reading.phase, reading);
  return best;
}

// What the sectors are by the two groups of their greys; false if they are all of one kind.
bool tellSectors(const CodeTrack &track, const Solution &solution, SectorReading &reading)
{
  const auto split = splitInTwo(solution.greys, reading.seen);
  if (!split || split->second <= 0.) {
    return false;
  }
  const auto [middle, half] = *split;
  double weights = 0.;
  for (unsigned int i = 0; i < track.samples; ++i) {
    weights += track.weight[i];
  }
  reading.middle = middle;
  reading.contrast = 2. * half;
  reading.residual = std::sqrt(solution.squares / std::max(weights, leastTrackWeight));
  for (unsigned int i = 0; i < reading.sectors; ++i) {
    reading.soft[i] = std::clamp((middle - solution.greys[i]) / half, -1., 1.);
  }
  return true;
}

// Samples that do not agree with their sector, where the edge of what covers it lies, are left out.
void dropOddSamples(CodeTrack &track, SectorReading &reading, Solution &solution)
{
  constexpr int rounds = 2; // an odd sample moves the grey level that it is judged by
  std::array<double, mostSamples> residuals;
  for (int round = 0; round < rounds; ++round) {
    findResiduals(track, reading.phase, solution.greys, residuals);
    for (unsigned int i = 0; i < track.samples; ++i) {
      if (std::abs(residuals[i]) > mostOdd) {
        track.weight[i] = 0.;
      }
    }
    solution.squares = solveSectors(track, reading.sectors, reading.phase, solution.greys);
  }
  findSeen(track, reading.phase, reading);
}

// Median grey level of the black or white sectors that are wholly seen, or of all that are if these are few.
double usualGrey(const Solution &solution, const SectorReading &reading, bool black)
{
  constexpr std::size_t few = 3;
  constexpr double whole = 0.9;
  std::array<double, mostSectors> greys;
  std::size_t count = 0;
  for (const double least : {whole, leastSeen}) {
    count = 0;
    for (unsigned int k = 0; k < reading.sectors; ++k) {
      if (reading.seen[k] >= least && (solution.greys[k] < 0.5) == black) {
        greys[count++] = solution.greys[k];
      }
    }
    if (count >= few) {
      break;
    }
  }
  return count > 0 ? medianOf(greys, count) : black ? 0. : 1.;
}

// Sectors that are neither as black as the ink nor as white as the paper, nor as black or white as the others are.
void dropGreySectors(const CodeTrack &track, const Solution &solution, SectorReading &reading)
{
  double blur = 0.; // of a sector
  for (unsigned int i = 0; i < track.samples; ++i) {
    blur += track.blur[i] * reading.sectors / (2. * M_PI * track.samples);
  }
  const double off = mostOff + offByBlur * blur;
  const auto dropAwayFrom = [&](double black, double white, double most) {
    for (unsigned int k = 0; k < reading.sectors; ++k) {
      const double grey = solution.greys[k];
      if (std::abs(grey - (grey < 0.5 ? black : white)) > most) {
        reading.seen[k] = 0.;
      }
    }
  };
  dropAwayFrom(0., 1., 2. * off);
  dropAwayFrom(usualGrey(solution, reading, true), usualGrey(solution, reading, false), off);
}
} // namespace

std::optional<SectorReading> solveTrack(const CodeTrack &track, unsigned int sectors)
{
  SectorReading reading;
  reading.sectors = sectors;
  const Solution solution = solveAllPhases(track, reading);
  return tellSectors(track, solution, reading) ? std::optional<SectorReading>(reading) : std::nullopt;
}

std::optional<SectorReading> solveCoveredTrack(CodeTrack track, unsigned int sectors)
{
  SectorReading reading;
  reading.sectors = sectors;
  Solution solution = solveAllPhases(track, reading);
  dropOddSamples(track, reading, solution);
  dropGreySectors(track, solution, reading);
  if (!tellSectors(track, solution, reading)) {
    return std::nullopt;
  }
  const auto seen = reading.seen;
  for (unsigned int k = 0; k < sectors; ++k) {
    const bool isBeside = seen[(k + 1) % sectors] < leastSeen || seen[(k + sectors - 1) % sectors] < leastSeen;
    reading.seen[k] *= isBeside ? besideCovered : 1.;
  }
  return reading;
}
} // namespace circle_marker
END_VISP_NAMESPACE
