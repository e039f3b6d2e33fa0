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
 * A short list without memory of its own.
 */

#ifndef VP_CIRCLE_MARKER_FEW_H
#define VP_CIRCLE_MARKER_FEW_H

#include <algorithm>
#include <array>
#include <cstddef>

#include <visp3/circle_marker/vpConfigCircleMarker.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! A list of at most \e most elements, which takes no memory from the heap; what is added beyond is left out. */
template <class Element, std::size_t most = 4> class Few
{
public:
  Few() = default;
  Few(const Few &other) : m_size(other.m_size) { std::copy(other.begin(), other.end(), begin()); }
  Few &operator=(const Few &other)
  {
    m_size = other.m_size;
    std::copy(other.begin(), other.end(), begin());
    return *this;
  }

  void push_back(const Element &element)
  {
    if (m_size < most) {
      m_elements[m_size++] = element;
    }
  }

  void pop_back() { --m_size; }
  void clear() { m_size = 0; }
  bool empty() const { return m_size == 0; }
  std::size_t size() const { return m_size; }
  const Element *data() const { return m_elements.data(); }
  Element &operator[](std::size_t i) { return m_elements[i]; }
  const Element &operator[](std::size_t i) const { return m_elements[i]; }
  const Element &front() const { return m_elements[0]; }
  const Element &back() const { return m_elements[m_size - 1]; }
  Element *begin() { return m_elements.data(); }
  Element *end() { return m_elements.data() + m_size; }
  const Element *begin() const { return m_elements.data(); }
  const Element *end() const { return m_elements.data() + m_size; }

private:
  std::array<Element, most> m_elements{};
  std::size_t m_size = 0;
};
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
