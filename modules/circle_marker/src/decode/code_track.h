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

#ifndef VP_CIRCLE_MARKER_CODE_TRACK_H
#define VP_CIRCLE_MARKER_CODE_TRACK_H

#include <array>
#include <cmath>
#include <optional>

#include <visp3/circle_marker/vpConfigCircleMarker.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! Most sectors of a code track. */
constexpr unsigned int mostSectors = 31;
/*!
  Samples of the track for each sector: at 40 pixels outer diameter one a pixel, and smaller markers have no more to
  tell. Where something covers a part of a sector, twice as many.
*/
constexpr unsigned int samplesPerSector = 4;
constexpr unsigned int coveredSamplesPerSector = 8;
constexpr unsigned int mostSamples = coveredSamplesPerSector * mostSectors;
/*! Phases of the grid of sectors that are told apart: an eighth of a sector is 2 degrees of spin. */
constexpr unsigned int phasesPerSector = 8;
/*! Blur assumed between the print and an interpolated sample, pixels: lens 0.7, pixel area 0.29, interpolation 0.4. */
constexpr double trackBlur = 0.85;
/*! A sector counts as seen if this share of its samples is. */
constexpr double leastSeen = 0.25;

/*! Samples along a code track. */
struct CodeTrack
{
  unsigned int samples = 0;
  std::array<double, mostSamples> grey;   //!< Reflectance: 1 for the white around, 0 for the black of the ring.
  std::array<double, mostSamples> blur;   //!< Along the track, as an angle, rad.
  std::array<double, mostSamples> weight; //!< 1, or 0 where the track is not seen.
};

/*! The sectors of a code track as the image shows them, before decoding. */
struct SectorReading
{
  unsigned int sectors = 0;             //!< Their number.
  double phase = 0.;                    //!< Angle at which the first of them starts, in the plane's frame, rad.
  std::array<double, mostSectors> soft; //!< From -1 (white) to 1 (black).
  std::array<double, mostSectors> seen; //!< Share of each that is seen, in [0, 1].
  double middle = 0.;                   //!< Reflectance between those of black and white sectors.
  double contrast = 0.;                 //!< White minus black of the sectors, as a share of the ring's own contrast.
  double residual = 0.; //!< Root mean square of what the sectors leave unexplained of the track, share of the contrast.
};

/*!
  The grey levels of the sectors are the least-squares solution of their mixture under the image blur, once for each of
  several phases of the sectors' grid, and the phase that leaves the least residual is kept.
  \return Nothing if the sectors that are seen are all of one kind.
*/
std::optional<SectorReading> solveTrack(const CodeTrack &track, unsigned int sectors);

/*!
  The same for a track that something covers in part: samples that do not agree with those beside them, and sectors that
  are neither black nor white, are not seen.
*/
std::optional<SectorReading> solveCoveredTrack(CodeTrack track, unsigned int sectors);

/*!
  Looks for the phase of a grid of sectors at which something costs least, by steps to either side that become half as
  long each time, down to a two-hundredth of a sector: a twentieth of a pixel on a track of 60 pixels.
  \param phase : Where it begins, rad.
  \param sectors : Their number.
  \param firstStep : The first step, of a sector.
  \param costAt : What a phase costs; it is asked for the first one, too.
*/
template <typename Cost> double leastPhase(double phase, unsigned int sectors, double firstStep, const Cost &costAt)
{
  constexpr double leastStep = 1. / 200.;
  double least = costAt(phase);
  for (double step = firstStep; step > leastStep; step *= 0.5) {
    const double from = phase;
    for (const double side : {-1., 1.}) {
      const double beside = from + side * step * 2. * M_PI / sectors;
      const double cost = costAt(beside);
      if (cost < least) {
        least = cost;
        phase = beside;
      }
    }
  }
  return phase;
}
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
