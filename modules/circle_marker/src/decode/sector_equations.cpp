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
 * Grey levels of the sectors of a code track, whose samples are mixtures of them.
 */

#include "decode/sector_equations.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "support/normal_distribution.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
using SectorProducts = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, mostSectors, mostSectors>;

// Weight that holds a sector to the mean of all: squared ratio of the noise (3 grey levels) to half the contrast (60).
constexpr double regularisation = 0.0025;

// A sample sees so many sectors to either side of its own: three sectors away, 1.5 sectors of blur are three sigma; and
// where the blur is below shortBlur of a sector the second neighbour is as far.
constexpr int neighbours = 2;
constexpr int neighboursOfShortBlur = 1;
constexpr double shortBlur = 0.3;

// What a sample sees: its own sector and those beside it, with the weights of their mixture under the blur.
template <int beside> struct Mixture
{
  static constexpr int touched = 2 * beside + 1;
  int sector = 0; // of the sample: -1 or from 0 to n - 1
  std::array<double, touched> weight;
};

// Number of a sector whose angle lies within a turn of the first: one turn more or less is enough.
int wrapped(int sector, int sectors)
{
  return sector < 0 ? sector + sectors : sector >= sectors ? sector - sectors : sector;
}

template <int beside>
Mixture<beside> mixtureAt(const CodeTrack &track, unsigned int sample, double sectorAngle, double phase)
{
  const NormalDistribution &normal = NormalDistribution::instance();
  const double angle = 2. * M_PI * (sample + 0.5) / track.samples - phase;
  Mixture<beside> mixture;
  mixture.sector = static_cast<int>(std::floor(angle / sectorAngle));
  double previous = 0.; // the outermost sectors take all that lies beyond them
  for (int j = 0; j < mixture.touched; ++j) {
    const double end = (mixture.sector - beside + j + 1) * sectorAngle;
    const double upTo = j + 1 == mixture.touched ? 1. : normal.at((end - angle) / track.blur[sample]).cumulative;
    mixture.weight[static_cast<std::size_t>(j)] = upTo - previous;
    previous = upTo;
  }
  return mixture;
}

// Normal equations of the sectors' grey levels. Samples of one sector, which follow each other, see the same sectors:
// their products are summed up by themselves first, where the compiler keeps them in registers.
template <int beside> class SectorEquations
{
public:
  explicit SectorEquations(unsigned int sectors)
      : m_matrix(SectorProducts::Zero(sectors, sectors)), m_right(SectorGreys::Zero(sectors))
  {
  }

  void add(const Mixture<beside> &mixture, double weight, double grey)
  {
    if (mixture.sector != m_sector) {
      close();
      m_sector = mixture.sector;
    }
    std::size_t at = 0;
    for (std::size_t j = 0; j < touched; ++j) {
      const double weighted = weight * mixture.weight[j];
      m_rightHere[j] += weighted * grey;
      for (std::size_t k = 0; k <= j; ++k) {
        m_products[at++] += weighted * mixture.weight[k];
      }
    }
  }

  SectorGreys solve(double ridge)
  {
    close();
    m_matrix.diagonal().array() += ridge;
    return m_matrix.ldlt().solve(m_right);
  }

private:
  static constexpr std::size_t touched = Mixture<beside>::touched;

  // The sums of the sector that was added to last go to their places.
  void close()
  {
    const int n = static_cast<int>(m_right.size());
    std::size_t at = 0;
    for (std::size_t j = 0; j < touched; ++j) {
      const int row = wrapped(m_sector - beside + static_cast<int>(j), n);
      m_right[row] += m_rightHere[j];
      for (std::size_t k = 0; k <= j; ++k) {
        const int column = wrapped(m_sector - beside + static_cast<int>(k), n);
        m_matrix(std::max(row, column), std::min(row, column)) += m_products[at++]; // the lower half
      }
    }
    m_rightHere.fill(0.);
    m_products.fill(0.);
  }

  SectorProducts m_matrix;
  SectorGreys m_right;
  int m_sector = 0;
  std::array<double, touched> m_rightHere{};
  std::array<double, touched *(touched + 1) / 2> m_products{};
};

// Mean of what is seen of a track.
double meanGrey(const CodeTrack &track)
{
  double sum = 0.;
  double weights = 0.;
  for (unsigned int i = 0; i < track.samples; ++i) {
    sum += track.weight[i] * track.grey[i];
    weights += track.weight[i];
  }
  return sum / std::max(weights, leastTrackWeight);
}

// Least-squares grey levels of the sectors when the first starts at \e phase; returns the sum of squared residuals. Of
// what is not seen the residuals are nought.
template <int beside>
double solveSectorsAs(const CodeTrack &track, unsigned int sectors, double phase, SectorGreys &greys,
                      std::array<double, mostSamples> &residuals)
{
  const double mean = meanGrey(track);
  const double sectorAngle = 2. * M_PI / sectors;
  std::array<Mixture<beside>, mostSamples> mixtures;
  SectorEquations<beside> equations(sectors);
  for (unsigned int i = 0; i < track.samples; ++i) {
    if (track.weight[i] > 0.) {
      mixtures[i] = mixtureAt<beside>(track, i, sectorAngle, phase);
      equations.add(mixtures[i], track.weight[i], track.grey[i] - mean);
    }
  }
  greys = equations.solve(regularisation * track.samples / sectors);
  double squares = 0.;
  for (unsigned int i = 0; i < track.samples; ++i) {
    residuals[i] = 0.;
    if (track.weight[i] > 0.) {
      double predicted = mean;
      for (int j = 0; j < mixtures[i].touched; ++j) {
        const int sector = wrapped(mixtures[i].sector - beside + j, static_cast<int>(sectors));
        predicted += mixtures[i].weight[static_cast<std::size_t>(j)] * greys[sector];
      }
      residuals[i] = track.grey[i] - predicted;
      squares += track.weight[i] * residuals[i] * residuals[i];
    }
  }
  greys.array() += mean;
  return squares;
}
} // namespace

double solveSectors(const CodeTrack &track, unsigned int sectors, double phase, SectorGreys &greys,
                    std::array<double, mostSamples> &residuals)
{
  const double most = *std::max_element(track.blur.begin(), track.blur.begin() + track.samples);
  return most * sectors < shortBlur * 2. * M_PI
             ? solveSectorsAs<neighboursOfShortBlur>(track, sectors, phase, greys, residuals)
             : solveSectorsAs<neighbours>(track, sectors, phase, greys, residuals);
}
} // namespace circle_marker
END_VISP_NAMESPACE
