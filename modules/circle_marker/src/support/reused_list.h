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
 * A list that keeps its elements' memory when it is emptied.
 */

#ifndef VP_CIRCLE_MARKER_REUSED_LIST_H
#define VP_CIRCLE_MARKER_REUSED_LIST_H

#include <cstddef>
#include <vector>

#include <visp3/circle_marker/vpConfigCircleMarker.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  A list that keeps its elements, and the memory that they hold in turn, when it is emptied: after a few images nothing
  is allocated any more. What append() gives has the value of its last use.
*/
template <class T> class ReusedList
{
public:
  using iterator = typename std::vector<T>::iterator;
  using const_iterator = typename std::vector<T>::const_iterator;

  T &append()
  {
    if (m_size == m_elements.size()) {
      m_elements.emplace_back();
    }
    return m_elements[m_size++];
  }

  void removeLast() { --m_size; }
  void clear() { m_size = 0; }

  std::size_t size() const { return m_size; }
  bool empty() const { return m_size == 0; }
  T &operator[](std::size_t i) { return m_elements[i]; }
  const T &operator[](std::size_t i) const { return m_elements[i]; }
  iterator begin() { return m_elements.begin(); }
  iterator end() { return m_elements.begin() + static_cast<std::ptrdiff_t>(m_size); }
  const_iterator begin() const { return m_elements.begin(); }
  const_iterator end() const { return m_elements.begin() + static_cast<std::ptrdiff_t>(m_size); }

private:
  std::vector<T> m_elements; //!< Those in use, then those to be used again.
  std::size_t m_size = 0;    //!< Number of those in use.
};
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
