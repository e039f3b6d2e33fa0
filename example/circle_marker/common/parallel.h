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
 * Work on numbered items, spread over threads.
 */

#ifndef VP_COMMON_PARALLEL_H
#define VP_COMMON_PARALLEL_H

#include <cstddef>
#include <functional>

namespace common {
/*! Told how many items are done, of how many; from one thread at a time. */
using Progress = std::function<void(std::size_t done, std::size_t all)>;

/*! Works on the item of a number. */
using Worker = std::function<void(std::size_t item)>;

/*!
  Works on the items 0 to count - 1, in this order as far as one thread is concerned.

  \e makeWorker: Called once in each thread; what it returns works on that thread's items and may own what cannot
  be shared, such as a simulated camera and detectors.
  \e progress: May be empty.
  \exception : The first exception of a worker, once all threads have stopped.
*/
void forEachItem(std::size_t count, unsigned int threads, const std::function<Worker()> &makeWorker,
                 const Progress &progress);
} // namespace common

#endif
