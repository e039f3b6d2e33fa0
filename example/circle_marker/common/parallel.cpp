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

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "parallel.h"

namespace common {
void forEachItem(std::size_t count, unsigned int threads, const std::function<Worker()> &makeWorker,
                 const Progress &progress)
{
  std::atomic<std::size_t> next(0);
  std::size_t done = 0;
  std::exception_ptr failure;
  std::mutex mutex;

  const auto work = [&]() {
    try {
      const Worker worker = makeWorker();
      for (std::size_t i = next++; i < count; i = next++) {
        worker(i);
        const std::lock_guard<std::mutex> lock(mutex);
        ++done;
        if (progress) {
          progress(done, count);
        }
      }
    }
    catch (...) {
      const std::lock_guard<std::mutex> lock(mutex);
      failure = failure ? failure : std::current_exception();
      next = count;
    }
  };

  std::vector<std::thread> helpers;
  for (unsigned int i = 1; i < threads; ++i) {
    helpers.emplace_back(work);
  }
  work();
  for (std::thread &helper : helpers) {
    helper.join();
  }
  if (failure) {
    std::rethrow_exception(failure);
  }
}
} // namespace common
