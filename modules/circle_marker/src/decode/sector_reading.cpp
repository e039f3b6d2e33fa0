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
 * Grey levels of the sectors of a marker's code track.
 */

#include "decode/sector_reading.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Cholesky>

#include "support/bilinear.h"
#include "support/normal_distribution.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Samples of the track for each sector: at 40 pixels outer diameter one a pixel, and smaller markers have no more to
// tell.
constexpr unsigned int samplesPerSector = 4;
// Phases of the grid of sectors that are told apart: an eighth of a sector is 2 degrees of spin.
constexpr unsigned int phases = 8;
// From this length of a sector, pixels, the steps between sectors stand apart and tell the phase (its mean over the
// track: oblique markers have shorter ones). Below it all phases are tried.
constexpr double stepsApart = 2.5;
constexpr unsigned int mostSamples = samplesPerSector * mostSectors;
// Blur assumed between the print and an interpolated sample, pixels: lens 0.7, pixel area 0.29, interpolation 0.4.
constexpr double assumedBlur = 0.85;
// Weight that holds a sector to the mean of all: squared ratio of the noise (3 grey levels) to half the contrast (60).
constexpr double regularisation = 0.0025;
// The white centre is brighter than the ring by this share of the contrast at least: a ring of 17 pixels at 60 degrees
// keeps nine tenths after the blur, while a dark blob taken for a marker is darkest there.
constexpr double leastCenter = 0.2;
// Where in the quiet zone white is read: past the blur of the ring, short of the surround.
constexpr double whiteOfQuietZone = 0.6;
// Least contrast of the ring, grey levels.
constexpr double leastContrast = 6.;

using Profile = std::array<double, mostSamples>;
using SectorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, mostSectors, mostSectors>;
using SectorVector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, mostSectors, 1>;

struct Track
{
  unsigned int samples = 0;
  Profile grey; // reflectance: 1 for the white around, 0 for the black of the ring
  Profile blur; // of a sample along the track, as an angle, rad
};

std::optional<double> sampleAt(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane &plane,
                               double radius, double c, double s)
{
  return bilinear(I, camera.toPixel(plane.project(Eigen::Vector2d(radius * c, radius * s))));
}

// A few samples that have to agree with a black ring between white and white: what most outlines in clutter fail.
vpCircleMarkerReject judgeRing(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane &plane,
                               const vpCircleMarkerLayout &layout)
{
  constexpr int directions = 16;
  double white = 0.;
  double black = 0.;
  for (int i = 0; i < directions; ++i) {
    const double angle = 2. * M_PI * i / directions;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const auto outside = sampleAt(I, camera, plane, 1. + whiteOfQuietZone * layout.quietZone, c, s);
    const auto ring = sampleAt(I, camera, plane, 0.5 * (1. + layout.ringInner), c, s);
    if (!outside || !ring) {
      return vpCircleMarkerReject::OUT_OF_IMAGE;
    }
    white += *outside / directions;
    black += *ring / directions;
  }
  const auto center = bilinear(I, camera.toPixel(plane.project(Eigen::Vector2d::Zero())));
  const bool isRing = white - black >= leastContrast && center && *center - black >= leastCenter * (white - black);
  return isRing ? vpCircleMarkerReject::NONE : vpCircleMarkerReject::NO_RING;
}

Judged<Track> sampleTrack(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane &plane,
                          const vpCircleMarkerFamily &family)
{
  const vpCircleMarkerLayout &layout = family.getLayout();
  const double width = layout.codeOuter - layout.codeInner;
  // The middle half of the track: its rims are blurred into the white beside.
  const double radii[3] = {layout.codeInner + 0.3 * width, layout.codeInner + 0.5 * width,
                           layout.codeInner + 0.7 * width};
  const double whiteRadius = 1. + whiteOfQuietZone * layout.quietZone;
  const double blackRadius = 0.5 * (1. + layout.ringInner);
  Track track;
  track.samples = samplesPerSector * family.getNbSectors();
  // White is fitted as a plane over the marker: mean and first harmonic of the quiet zone around it.
  double white = 0.;
  double whiteCos = 0.;
  double whiteSin = 0.;
  double black = 0.;
  for (unsigned int i = 0; i < track.samples; ++i) {
    const double angle = 2. * M_PI * (i + 0.5) / track.samples;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    double sum = 0.;
    for (const double radius : radii) {
      const auto grey = sampleAt(I, camera, plane, radius, c, s);
      if (!grey) {
        return vpCircleMarkerReject::OUT_OF_IMAGE;
      }
      sum += *grey / 3.;
    }
    track.grey[i] = sum;
    const auto outside = sampleAt(I, camera, plane, whiteRadius, c, s);
    const auto ring = sampleAt(I, camera, plane, blackRadius, c, s);
    if (!outside || !ring) {
      return vpCircleMarkerReject::OUT_OF_IMAGE;
    }
    white += *outside;
    whiteCos += 2. * *outside * c;
    whiteSin += 2. * *outside * s;
    black += *ring;
    // Angle for a pixel along the track at its middle radius.
    const double step = 0.02; // rad: a secant short enough to be a tangent
    const Eigen::Vector2d before =
        camera.toPixel(plane.project(radii[1] * Eigen::Vector2d(std::cos(angle - step), std::sin(angle - step))));
    const Eigen::Vector2d after =
        camera.toPixel(plane.project(radii[1] * Eigen::Vector2d(std::cos(angle + step), std::sin(angle + step))));
    track.blur[i] = assumedBlur * 2. * step / (after - before).norm();
  }
  const double n = track.samples;
  white /= n;
  whiteCos /= n * whiteRadius;
  whiteSin /= n * whiteRadius;
  black /= n;
  if (white - black < leastContrast) {
    return vpCircleMarkerReject::NO_RING;
  }
  for (unsigned int i = 0; i < track.samples; ++i) {
    const double angle = 2. * M_PI * (i + 0.5) / track.samples;
    const double here = white + radii[1] * (whiteCos * std::cos(angle) + whiteSin * std::sin(angle));
    // The light multiplies white and black alike.
    track.grey[i] = (track.grey[i] * white / std::max(here, 1.) - black) / (white - black);
  }
  return track;
}

// Least-squares grey levels of the sectors when the first starts at \e phase; returns the sum of squared residuals.
double solveSectors(const Track &track, unsigned int sectors, double phase, SectorVector &greys)
{
  const NormalDistribution &normal = NormalDistribution::instance();
  SectorMatrix normalMatrix = SectorMatrix::Zero(sectors, sectors);
  SectorVector right = SectorVector::Zero(sectors);
  const double sectorAngle = 2. * M_PI / sectors;
  constexpr int neighbours = 2; // to either side: three sectors away, 1.5 sectors of blur are three sigma
  constexpr int touched = 2 * neighbours + 1;
  struct Row
  {
    std::array<int, touched> sector; // from 0 to n - 1
    std::array<double, touched> weight;
  };
  static thread_local std::array<Row, mostSamples> rows;
  double mean = 0.;
  const int n = static_cast<int>(sectors);
  for (unsigned int i = 0; i < track.samples; ++i) {
    const double angle = 2. * M_PI * (i + 0.5) / track.samples - phase;
    const int sector = static_cast<int>(std::floor(angle / sectorAngle));
    Row &row = rows[i];
    const int first = sector - neighbours;
    double previous = 0.; // the outermost sectors take all that lies beyond them
    for (int j = 0; j < touched; ++j) {
      // Angles lie within a turn of the first sector: one turn more or less is enough.
      const int wrapped = first + j < 0 ? first + j + n : first + j >= n ? first + j - n : first + j;
      row.sector[static_cast<std::size_t>(j)] = wrapped;
      const double end = (first + j + 1) * sectorAngle;
      const double upTo = j + 1 == touched ? 1. : normal.at((end - angle) / track.blur[i]).cumulative;
      row.weight[static_cast<std::size_t>(j)] = upTo - previous;
      previous = upTo;
    }
    mean += track.grey[i] / track.samples;
  }
  for (unsigned int i = 0; i < track.samples; ++i) {
    const Row &row = rows[i];
    for (std::size_t j = 0; j < touched; ++j) {
      right[row.sector[j]] += row.weight[j] * (track.grey[i] - mean);
      for (std::size_t k = 0; k <= j; ++k) {
        const auto [least, most] = std::minmax(row.sector[j], row.sector[k]);
        normalMatrix(most, least) += row.weight[j] * row.weight[k]; // the lower half
      }
    }
  }
  normalMatrix.diagonal().array() += regularisation * samplesPerSector;
  greys = normalMatrix.ldlt().solve(right);
  double squares = 0.;
  for (unsigned int i = 0; i < track.samples; ++i) {
    double predicted = mean;
    for (std::size_t j = 0; j < touched; ++j) {
      predicted += rows[i].weight[j] * greys[rows[i].sector[j]];
    }
    squares += (track.grey[i] - predicted) * (track.grey[i] - predicted);
  }
  greys.array() += mean;
  return squares;
}

// The phase told by the steps between sectors: that of the harmonic of the squared steps that has one period a sector.
// Nothing if the sectors are too short for the steps to stand apart.
std::optional<unsigned int> likelyPhase(const Track &track, unsigned int sectors)
{
  double pixelAngle = 0.; // mean angle of a pixel along the track
  double c = 0.;
  double s = 0.;
  for (unsigned int i = 0; i < track.samples; ++i) {
    const double step = track.grey[(i + 1) % track.samples] - track.grey[i];
    // The step lies between samples i and i + 1, which are half a sample after their numbers: at i + 1.
    const double angle = 2. * M_PI * (i + 1) / samplesPerSector;
    c += step * step * std::cos(angle);
    s += step * step * std::sin(angle);
    pixelAngle += track.blur[i] / (assumedBlur * track.samples);
  }
  if (2. * M_PI / sectors < stepsApart * pixelAngle) {
    return std::nullopt;
  }
  const double phase = std::atan2(s, c) / (2. * M_PI); // of a sector
  return static_cast<unsigned int>(std::lround(phases * (phase + 1.))) % phases;
}

// Splits the grey levels in two groups with the least spread inside them; returns the middle and half the distance.
std::pair<double, double> splitInTwo(const SectorVector &greys)
{
  std::array<double, mostSectors> sorted;
  const auto n = static_cast<std::size_t>(greys.size());
  std::copy(greys.data(), greys.data() + n, sorted.begin());
  std::sort(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(n));
  double total = 0.;
  for (std::size_t i = 0; i < n; ++i) {
    total += sorted[i];
  }
  double best = -1.;
  std::pair<double, double> split(0., 0.);
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
} // namespace

Judged<SectorReading> readSectors(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane &plane,
                                  const vpCircleMarkerFamily &family)
{
  const vpCircleMarkerReject ring = judgeRing(I, camera, plane, family.getLayout());
  if (ring != vpCircleMarkerReject::NONE) {
    return ring;
  }
  const Judged<Track> track = sampleTrack(I, camera, plane, family);
  if (!track) {
    return track.reason();
  }
  const unsigned int sectors = family.getNbSectors();
  SectorVector best;
  double leastSquares = HUGE_VAL;
  SectorReading reading;
  reading.sectors = sectors;
  const std::optional<unsigned int> likely = likelyPhase(*track, sectors);
  const unsigned int first = likely ? *likely + phases - 1 : 0;
  const unsigned int count = likely ? 3 : phases; // the likely one between its neighbours
  for (unsigned int i = first; i < first + count; ++i) {
    const double phase = 2. * M_PI * (i % phases) / (phases * sectors);
    SectorVector greys;
    const double squares = solveSectors(*track, sectors, phase, greys);
    if (squares < leastSquares) {
      leastSquares = squares;
      best = greys;
      reading.phase = phase;
    }
  }
  const auto [middle, half] = splitInTwo(best);
  if (half <= 0.) {
    return vpCircleMarkerReject::NO_SECTORS;
  }
  reading.contrast = 2. * half;
  reading.residual = std::sqrt(leastSquares / track->samples);
  for (unsigned int i = 0; i < sectors; ++i) {
    reading.soft[i] = std::clamp((middle - best[i]) / half, -1., 1.);
  }
  return reading;
}
} // namespace circle_marker
END_VISP_NAMESPACE
