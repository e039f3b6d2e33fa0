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

#include "support/workers.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include <visp3/core/vpException.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// A thread that sleeps comes back 0.05 ms after it is called, in a virtual machine 0.2, and an image has two dozen
// rounds of work, with up to 0.2 ms in between. So a thread stays awake for longer than that.
constexpr std::chrono::microseconds staysAwake(500);
constexpr std::size_t cacheLine = 64; // bytes

// Waits awake until something is so; false if it is not in time.
template <class Condition> bool waitsAwake(const Condition &isSo)
{
  const auto end = std::chrono::steady_clock::now() + staysAwake;
  while (!isSo()) {
    if (std::chrono::steady_clock::now() > end) {
      return false;
    }
    std::this_thread::yield(); // where there are more threads than cores, another one has work
  }
  return true;
}
} // namespace

/*! The threads beside the caller's, and the work they are given. */
class Workers::Team
{
public:
  explicit Team(unsigned int others)
  {
    try {
      for (unsigned int i = 1; i <= others; ++i) {
        m_threads.emplace_back([this, i]() { serve(i); });
      }
    }
    catch (const std::exception &) { // of std::thread, or of memory: those that run would end the program
      const auto threads = static_cast<unsigned long>(m_threads.size() + 1);
      end();
      throw vpException(vpException::fatalError,
                        "of %lu threads only %lu can be had; ask for fewer, or raise the limit of the system",
                        static_cast<unsigned long>(others) + 1, threads);
    }
  }

  ~Team() { end(); }

  void share(std::size_t tasks, Call call, const void *task)
  {
    {
      const std::lock_guard<std::mutex> lock(m_mutex);
      m_call = call;
      m_task = task;
      m_tasks = tasks;
      m_next = 0;
      m_busy = m_threads.size();
      m_failure = nullptr;
      ++m_round;
    }
    m_hasWork.notify_all();
    work(0);
    const auto isDone = [this]() { return m_busy == 0; };
    if (!waitsAwake(isDone)) {
      std::unique_lock<std::mutex> lock(m_mutex);
      m_isDone.wait(lock, isDone);
    }
    if (m_failure) {
      std::rethrow_exception(m_failure);
    }
  }

private:
  void end()
  {
    {
      const std::lock_guard<std::mutex> lock(m_mutex);
      m_isOver = true;
    }
    m_hasWork.notify_all();
    for (std::thread &thread : m_threads) {
      thread.join();
    }
  }

  void serve(unsigned int worker)
  {
    unsigned long served = 0;
    while (true) {
      const auto isCalled = [&]() { return m_isOver || m_round != served; };
      if (!waitsAwake(isCalled)) {
        std::unique_lock<std::mutex> lock(m_mutex);
        m_hasWork.wait(lock, isCalled);
      }
      if (m_isOver) {
        return;
      }
      served = m_round;
      work(worker);
      if (--m_busy == 0) {
        const std::lock_guard<std::mutex> lock(m_mutex); // the caller may be about to sleep
        m_isDone.notify_one();
      }
    }
  }

  void work(unsigned int worker)
  {
    try {
      for (std::size_t i = m_next++; i < m_tasks; i = m_next++) {
        m_call(m_task, i, worker);
      }
    }
    catch (...) {
      const std::lock_guard<std::mutex> lock(m_mutex);
      m_failure = std::current_exception();
      m_next = m_tasks;
    }
  }

  std::mutex m_mutex;                    //!< For those who sleep, and for m_failure.
  std::condition_variable m_hasWork;     //!< There is a new round, or the end.
  std::condition_variable m_isDone;      //!< No thread is busy any more.
  std::atomic<bool> m_isOver{false};     //!< The threads have to end.
  std::atomic<unsigned long> m_round{0}; //!< Counts the calls of share(); what follows belongs to it.
  std::atomic<std::size_t> m_busy{0};    //!< Threads at work in this round.
  Call m_call = nullptr;                 //!< What to call.
  const void *m_task = nullptr;          //!< And with what.
  std::size_t m_tasks = 0;               //!< Number of tasks.
  //! The task to be begun next; all write it, on a line of the cache where nothing else is.
  alignas(cacheLine) std::atomic<std::size_t> m_next{0};
  alignas(cacheLine) std::exception_ptr m_failure; //!< What a task has thrown.
  std::vector<std::thread> m_threads;              //!< The last member: its threads use the others.
};

Workers::Workers(unsigned int count)
{
  setCount(count);
}

Workers::Workers(const Workers &other) : Workers(other.getCount()) {}

Workers &Workers::operator=(const Workers &other)
{
  setCount(other.getCount());
  return *this;
}

Workers::~Workers() = default;

void Workers::setCount(unsigned int count)
{
  count = std::max(count, 1U);
  if (count != m_count) {
    m_team.reset();
    m_count = count;
  }
}

void Workers::share(std::size_t tasks, Call call, const void *task)
{
  if (!m_team) { // threads are started when there is work for them
    m_team = std::make_unique<Team>(m_count - 1);
  }
  m_team->share(tasks, call, task);
}
} // namespace circle_marker
END_VISP_NAMESPACE
