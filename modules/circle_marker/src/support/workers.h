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
 * Threads that wait for work.
 */

#ifndef VP_CIRCLE_MARKER_WORKERS_H
#define VP_CIRCLE_MARKER_WORKERS_H

#include <cstddef>
#include <memory>

#include <visp3/circle_marker/vpConfigCircleMarker.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  A number of threads, the caller's among them, that share out numbered tasks. The threads are started once and wait
  in between; nothing is allocated when they are given work. A copy has threads of its own.
*/
class Workers
{
public:
  explicit Workers(unsigned int count = 1);
  Workers(const Workers &other);
  Workers &operator=(const Workers &other);
  ~Workers();

  /*! Number of threads with the caller's; 0 counts as 1. */
  void setCount(unsigned int count);
  unsigned int getCount() const { return m_count; }

  /*!
    Calls task(i, worker) once for each i from 0 to before \e tasks, in no set order, and comes back when all are done;
    \e worker, from 0 to before getCount(), is never the same for two calls at the same time. What a task throws is
    thrown on here, and tasks that were not begun are left out.
  */
  template <class Task> void run(std::size_t tasks, const Task &task)
  {
    if (m_count == 1 || tasks <= 1) {
      for (std::size_t i = 0; i < tasks; ++i) {
        task(i, 0U);
      }
      return;
    }
    share(tasks, &call<Task>, &task);
  }

private:
  using Call = void (*)(const void *task, std::size_t index, unsigned int worker);
  class Team;

  template <class Task> static void call(const void *task, std::size_t index, unsigned int worker)
  {
    (*static_cast<const Task *>(task))(index, worker);
  }

  void share(std::size_t tasks, Call call, const void *task);

  unsigned int m_count = 1;     //!< Number of threads with the caller's.
  std::unique_ptr<Team> m_team; //!< The others; nothing if there is none.
};
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
