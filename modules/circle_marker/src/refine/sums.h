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
 * Sums of a pass over the pixels of a marker.
 */

/*!
  \file sums.h
  \brief Normal equations of a pass over the pixels, summed up in lanes and then in double precision, direction by
  direction from the marker's centre.
*/

#ifndef VP_CIRCLE_MARKER_SUMS_H
#define VP_CIRCLE_MARKER_SUMS_H

#include <array>
#include <tuple>
#include <vector>

#include "refine/grey_model.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace CIRCLE_MARKER_LANES {
// Blocks whose products are summed up at once, so that each sum is loaded and stored once for all of them.
constexpr std::size_t blocksOfGroup = 4;
// Groups whose sums are taken in single precision before they go to double: the depth is a difference of things that
// are known a thousand times better, and of 100 blocks' sums in single precision nothing would be left of it.
constexpr std::size_t groupsToFlush = 8;

// Sums of one pass, direction by direction, in lanes and then in double precision.
class Sums
{
public:
  // used: parameters that are summed up; formsProducts: whether the products for the matrix are wanted.
  Sums(PassSums &sums, const UsedParameters &used, bool formsProducts)
      : m_parameters(used), m_used(used.count()), m_products(formsProducts ? m_used * (m_used + 1) / 2 : 0),
        m_sums(sums)
  {
    m_sums.pulls.clear();
    if (formsProducts) {
      m_sums.products.clear();
    }
    for (RowLanes &row : m_rows) { // parameters that no pixel depends on stay so
      row.fill(Lanes::Zero());
    }
    clear();
  }

  // The row of the next block, to be filled in before add().
  RowLanes &row() { return m_rows[m_pending]; }

  // squaredSlope: of the image at each pixel, by which it tells of the pose.
  void add(const Lanes &residual, const LossLanes &loss, const Lanes &squaredSlope, std::size_t direction)
  {
    if (m_pending == 0 && direction != m_direction) {
      flush();
      m_direction = direction;
    }
    RowLanes &row = m_rows[m_pending];
    if (!m_parameters.areFirst()) {
      for (std::size_t i = 0; i < m_used; ++i) {
        row[i] = row[m_parameters[i]];
      }
    }
    RowLanes &weighted = m_weighted[m_pending];
    for (std::size_t i = 0; i < m_used; ++i) {
      weighted[i] = loss.weight * row[i];
      m_pullLanes[i] += weighted[i] * residual;
    }
    m_pullLanes[costAt] += loss.cost;
    m_pullLanes[squaresAt] += loss.tells * loss.weight * residual.square();
    m_pullLanes[keptAt] += loss.tells * loss.kept;
    const Lanes steepness = loss.tells * loss.weight * squaredSlope;
    m_pullLanes[steepnessAt] += steepness;
    m_pullLanes[squaredSteepnessAt] += steepness.square();
    m_pullLanes[steepSquaresAt] += steepness * loss.weight * residual.square();
    if (++m_pending == blocksOfGroup) {
      closeGroup();
    }
  }

  // The sums of all directions: the matrix too, if its products are formed.
  void close(Equations &equations)
  {
    if (m_pending > 0) {
      for (; m_pending < blocksOfGroup; ++m_pending) {
        for (std::size_t i = 0; i < m_used; ++i) {
          m_rows[m_pending][i].setZero();
          m_weighted[m_pending][i].setZero();
        }
      }
      closeGroup();
    }
    flush();
    if (m_products > 0) {
      const ProductSums total = totalOf(m_sums.products);
      std::size_t k = 0;
      for (std::size_t i = 0; i < m_used; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
          equations.matrix(at(i), at(j)) = total[k++];
          equations.matrix(at(j), at(i)) = equations.matrix(at(i), at(j));
        }
      }
    }
    const PullSums total = totalOf(m_sums.pulls);
    for (std::size_t i = 0; i < m_used; ++i) {
      equations.right[at(i)] = total[i];
    }
    equations.cost = total[costAt];
    equations.squares = total[squaresAt];
    equations.kept = total[keptAt];
    equations.steepness = total[steepnessAt];
    equations.squaredSteepness = total[squaredSteepnessAt];
    equations.steepSquares = total[steepSquaresAt];
  }

private:
  static constexpr std::size_t costAt = parameters;
  static constexpr std::size_t squaresAt = costAt + 1;
  static constexpr std::size_t keptAt = costAt + 2;
  static constexpr std::size_t steepnessAt = costAt + 3;
  static constexpr std::size_t squaredSteepnessAt = costAt + 4;
  static constexpr std::size_t steepSquaresAt = costAt + 5;

  Eigen::Index at(std::size_t k) const { return m_parameters.at(static_cast<Eigen::Index>(k)); }

  template <class Numbers> static Numbers totalOf(const std::vector<Numbers> &all)
  {
    Numbers total = {};
    for (const Numbers &numbers : all) {
      for (std::size_t k = 0; k < numbers.size(); ++k) {
        total[k] += numbers[k];
      }
    }
    return total;
  }

  void clear()
  {
    for (std::size_t k = 0; k < wholeBlocks(m_products); ++k) {
      m_productLanes[k].setZero();
    }
    for (Lanes &lanes : m_pullLanes) {
      lanes.setZero();
    }
    m_groups = 0;
  }

  void closeGroup()
  {
    if (m_products > 0) {
      // Two rows of the matrix at once: what is loaded for the one serves the other, and loads are what takes time.
      for (std::size_t i = 0; i + 1 < m_used; i += 2) {
        addProducts<2>(i);
        m_productLanes[firstOfRow(i + 1) + i + 1] += productOf(i + 1, i + 1);
      }
      if (m_used % 2 == 1) {
        addProducts<1>(m_used - 1);
      }
    }
    m_pending = 0;
    if (++m_groups == groupsToFlush) {
      flush();
    }
  }

  static constexpr std::size_t firstOfRow(std::size_t i) { return i * (i + 1) / 2; }

  Lanes productOf(std::size_t i, std::size_t j) const
  {
    Lanes sum = Lanes::Zero();
    for (std::size_t block = 0; block < blocksOfGroup; ++block) {
      sum += m_weighted[block][i] * m_rows[block][j];
    }
    return sum;
  }

  // The products of a group for some rows of the matrix, up to the diagonal in the first of them.
  template <std::size_t rows> void addProducts(std::size_t first)
  {
    std::array<std::array<Lanes, blocksOfGroup>, rows> weighted;
    for (std::size_t row = 0; row < rows; ++row) {
      for (std::size_t block = 0; block < blocksOfGroup; ++block) {
        weighted[row][block] = m_weighted[block][first + row];
      }
    }
    for (std::size_t j = 0; j <= first; ++j) {
      std::array<Lanes, rows> sums;
      for (std::size_t row = 0; row < rows; ++row) {
        sums[row] = m_productLanes[firstOfRow(first + row) + j];
      }
      for (std::size_t block = 0; block < blocksOfGroup; ++block) {
        const Lanes other = m_rows[block][j];
        for (std::size_t row = 0; row < rows; ++row) {
          sums[row] += weighted[row][block] * other;
        }
      }
      for (std::size_t row = 0; row < rows; ++row) {
        m_productLanes[firstOfRow(first + row) + j] = sums[row];
      }
    }
  }

  // Adds the first numbers of the lanes to those of a direction.
  template <class Numbers>
  static void addTo(std::vector<Numbers> &all, std::size_t direction, const Lanes *lanes, std::size_t count)
  {
    while (direction >= all.size()) {
      all.push_back(Numbers());
    }
    Numbers &numbers = all[direction];
    for (std::size_t k = 0; k < count; k += laneCount) {
      addEach(numbers.data() + k, sumOfEach(lanes + k));
    }
  }

  void flush()
  {
    if (m_groups == 0) {
      return;
    }
    if (m_products > 0) {
      addTo(m_sums.products, m_direction, m_productLanes.data(), m_products);
    }
    addTo(m_sums.pulls, m_direction, m_pullLanes.data(), m_pullLanes.size());
    clear();
  }

  std::array<Lanes, std::tuple_size<ProductSums>::value> m_productLanes;
  std::array<Lanes, std::tuple_size<PullSums>::value> m_pullLanes;
  std::array<RowLanes, blocksOfGroup> m_rows;
  std::array<RowLanes, blocksOfGroup> m_weighted;
  const UsedParameters m_parameters;
  const std::size_t m_used;     // of these
  const std::size_t m_products; // of them; none if they are not wanted
  std::size_t m_pending = 0;    // blocks of the present group
  std::size_t m_groups = 0;     // since the last flush
  std::size_t m_direction = 0;  // of the first of them
  PassSums &m_sums;
};
} // namespace CIRCLE_MARKER_LANES
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
