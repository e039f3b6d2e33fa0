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
 * A value, or the reason why there is none.
 */

#ifndef VP_CIRCLE_MARKER_JUDGED_H
#define VP_CIRCLE_MARKER_JUDGED_H

#include <optional>
#include <utility>

#include <visp3/circle_marker/vpCircleMarkerReject.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  A value, or the reason why there is none; used as std::optional is. What was refused may be kept, to be shown.
*/
template <class T> class Judged
{
public:
  Judged(T value) : m_value(std::move(value)) {}
  Judged(vpCircleMarkerReject reason) : m_reason(reason) {}
  Judged(vpCircleMarkerReject reason, T refused) : m_value(std::move(refused)), m_reason(reason) {}

  explicit operator bool() const { return m_reason == vpCircleMarkerReject::NONE; }
  const T &operator*() const { return *m_value; }
  T &operator*() { return *m_value; }
  const T *operator->() const { return &*m_value; }
  T *operator->() { return &*m_value; }

  /*! vpCircleMarkerReject::NONE with a value. */
  vpCircleMarkerReject reason() const { return m_reason; }

  /*! The value, or what was refused; nothing if that was not kept. */
  const std::optional<T> &seen() const { return m_value; }

private:
  std::optional<T> m_value;                                   //!< The value, or what was refused.
  vpCircleMarkerReject m_reason = vpCircleMarkerReject::NONE; //!< Why it was.
};
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
