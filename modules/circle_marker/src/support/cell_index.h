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
 * Numbers found by their place in the image.
 */

#ifndef VP_CIRCLE_MARKER_CELL_INDEX_H
#define VP_CIRCLE_MARKER_CELL_INDEX_H

#include <algorithm>
#include <cstddef>
#include <vector>

#include <visp3/circle_marker/vpConfigCircleMarker.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Numbers kept by the place in the image they belong to: the image is divided into square cells. What asks for a
  neighbour then looks at a few of them, not at all.
*/
class CellIndex
{
public:
  static constexpr int side = 32; //!< Of a cell, pixels: small markers have a cell of their own, large ones few.

  /*! Forgets all numbers; the memory is kept. */
  void reset(int width, int height)
  {
    m_columns = std::max(width, 1) / side + 1;
    m_rows = std::max(height, 1) / side + 1;
    m_first.assign(static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(m_rows), -1);
    m_entries.clear();
  }

  /*! Keeps a number at a place, pixels; places outside of the image belong to its nearest cell. */
  void add(int number, double u, double v)
  {
    int &first = m_first[cellOf(columnOf(u), rowOf(v))];
    if (first >= 0 && m_entries[static_cast<std::size_t>(first)].number == number) {
      return; // the last that was put here
    }
    m_entries.push_back({number, first});
    first = static_cast<int>(m_entries.size()) - 1;
  }

  /*! Keeps a number in all cells of a box. */
  void addBox(int number, double left, double top, double right, double bottom)
  {
    for (int row = rowOf(top); row <= rowOf(bottom); ++row) {
      for (int column = columnOf(left); column <= columnOf(right); ++column) {
        add(number, column * static_cast<double>(side), row * static_cast<double>(side));
      }
    }
  }

  /*! Calls visit(number) for all numbers of the cells within \e reach of a place, until it returns true; whether so. */
  template <class Visit> bool any(double u, double v, double reach, Visit &&visit) const
  {
    for (int row = rowOf(v - reach); row <= rowOf(v + reach); ++row) {
      for (int column = columnOf(u - reach); column <= columnOf(u + reach); ++column) {
        for (int i = m_first[cellOf(column, row)]; i >= 0; i = m_entries[static_cast<std::size_t>(i)].next) {
          if (visit(m_entries[static_cast<std::size_t>(i)].number)) {
            return true;
          }
        }
      }
    }
    return false;
  }

private:
  struct Entry
  {
    int number;
    int next; // index of the cell's next entry, -1 after the last
  };

  static int indexOf(double coordinate, int count)
  {
    return static_cast<int>(std::clamp(coordinate / side, 0., count - 1.));
  }
  int columnOf(double u) const { return indexOf(u, m_columns); }
  int rowOf(double v) const { return indexOf(v, m_rows); }
  std::size_t cellOf(int column, int row) const
  {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(m_columns) + static_cast<std::size_t>(column);
  }

  int m_columns = 0;            //!< Of cells.
  int m_rows = 0;               //!< Of cells.
  std::vector<int> m_first;     //!< Index of each cell's first entry, -1 if it has none.
  std::vector<Entry> m_entries; //!< Of all cells.
};
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
