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
  const double perBlur = 1. / track.blur[sample];
  Mixture<beside> mixture;
  mixture.sector = static_cast<int>(std::floor(angle / sectorAngle));
  double previous = 0.; // the outermost sectors take all that lies beyond them
  for (int j = 0; j < mixture.touched; ++j) {
    const double end = (mixture.sector - beside + j + 1) * sectorAngle;
    const double upTo = j + 1 == mixture.touched ? 1. : normal.at((end - angle) * perBlur).cumulative;
    mixture.weight[static_cast<std::size_t>(j)] = upTo - previous;
    previous = upTo;
  }
  return mixture;
}

// Solves equations whose matrix, of which the lower half is given, has entries up to \e width places to either side of
// its diagonal, around the end: L D L^T without pivots, for it is positive definite. L has entries in the same places
// and in its last \e width rows.
template <int width> void solveCyclicBand(SectorProducts &matrix, SectorGreys &unknowns)
{
  const int n = static_cast<int>(unknowns.size());
  std::array<int, 2 * width> rows; // that have an entry in a column
  std::array<double, 2 * width> entries;
  for (int column = 0; column < n; ++column) {
    std::size_t count = 0;
    for (int row = column + 1; row <= std::min(column + width, n - 1); ++row) {
      rows[count++] = row;
    }
    for (int row = std::max(column + width + 1, n - width); row < n; ++row) {
      rows[count++] = row;
    }
    const double perPivot = 1. / matrix(column, column);
    for (std::size_t i = 0; i < count; ++i) {
      entries[i] = matrix(rows[i], column) * perPivot;
    }
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t k = i; k < count; ++k) {
        matrix(rows[k], rows[i]) -= entries[k] * matrix(rows[i], column);
      }
    }
    for (std::size_t i = 0; i < count; ++i) {
      matrix(rows[i], column) = entries[i];
      unknowns[rows[i]] -= entries[i] * unknowns[column];
    }
  }
  for (int column = n - 1; column >= 0; --column) {
    double sum = unknowns[column] / matrix(column, column);
    for (int row = column + 1; row <= std::min(column + width, n - 1); ++row) {
      sum -= matrix(row, column) * unknowns[row];
    }
    for (int row = std::max(column + width + 1, n - width); row < n; ++row) {
      sum -= matrix(row, column) * unknowns[row];
    }
    unknowns[column] = sum;
  }
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

  // The greys, and in \e squares what they leave of the samples', whose own squares are given.
  SectorGreys solve(double ridge, double &squares)
  {
    close();
    m_matrix.diagonal().array() += ridge;
    SectorGreys greys = m_right;
    solveCyclicBand<2 * beside>(m_matrix, greys);
    // |y - A x|^2 where A^T A x + r x = A^T y; of samples that are explained nothing but rounding is left.
    squares = std::max(squares - greys.dot(m_right) - ridge * greys.squaredNorm(), 0.);
    return greys;
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

template <int beside>
double solveSectorsAs(const CodeTrack &track, unsigned int sectors, double phase, SectorGreys &greys)
{
  const double mean = meanGrey(track);
  const double sectorAngle = 2. * M_PI / sectors;
  SectorEquations<beside> equations(sectors);
  double squares = 0.;
  for (unsigned int i = 0; i < track.samples; ++i) {
    if (track.weight[i] > 0.) {
      const double grey = track.grey[i] - mean;
      equations.add(mixtureAt<beside>(track, i, sectorAngle, phase), track.weight[i], grey);
      squares += track.weight[i] * grey * grey;
    }
  }
  greys = equations.solve(regularisation * track.samples / sectors, squares);
  greys.array() += mean;
  return squares;
}

template <int beside>
void findResidualsAs(const CodeTrack &track, double phase, const SectorGreys &greys,
                     std::array<double, mostSamples> &residuals)
{
  const int sectors = static_cast<int>(greys.size());
  for (unsigned int i = 0; i < track.samples; ++i) {
    residuals[i] = 0.;
    if (track.weight[i] > 0.) {
      const Mixture<beside> mixture = mixtureAt<beside>(track, i, 2. * M_PI / sectors, phase);
      residuals[i] = track.grey[i];
      for (int j = 0; j < mixture.touched; ++j) {
        const int sector = wrapped(mixture.sector - beside + j, sectors);
        residuals[i] -= mixture.weight[static_cast<std::size_t>(j)] * greys[sector];
      }
    }
  }
}

bool isBlurShort(const CodeTrack &track, unsigned int sectors)
{
  const double most = *std::max_element(track.blur.begin(), track.blur.begin() + track.samples);
  return most * sectors < shortBlur * 2. * M_PI;
}
} // namespace

double solveSectors(const CodeTrack &track, unsigned int sectors, double phase, SectorGreys &greys)
{
  return isBlurShort(track, sectors) ? solveSectorsAs<neighboursOfShortBlur>(track, sectors, phase, greys)
                                     : solveSectorsAs<neighbours>(track, sectors, phase, greys);
}

void findResiduals(const CodeTrack &track, double phase, const SectorGreys &greys,
                   std::array<double, mostSamples> &residuals)
{
  if (isBlurShort(track, static_cast<unsigned int>(greys.size()))) {
    findResidualsAs<neighboursOfShortBlur>(track, phase, greys, residuals);
  }
  else {
    findResidualsAs<neighbours>(track, phase, greys, residuals);
  }
}
} // namespace circle_marker
END_VISP_NAMESPACE
