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
 * Tests of the threads that share out tasks.
 */

#include "support/workers.h"

#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#ifdef __linux__
#include <sys/resource.h>
#endif

#include <gtest/gtest.h>

#include <visp3/core/vpException.h>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif
using namespace circle_marker;

namespace {
constexpr unsigned int threads = 4;

// Longer than a thread stays awake for.
void fallAsleep()
{
  std::this_thread::sleep_for(std::chrono::milliseconds(3));
}

// How often each of some tasks is called in a round.
std::vector<int> callsOfARound(Workers &workers, std::size_t tasks)
{
  std::vector<std::atomic<int>> calls(tasks);
  workers.run(tasks, [&calls](std::size_t i, unsigned int) { ++calls[i]; });
  return std::vector<int>(calls.begin(), calls.end());
}
} // namespace

TEST(Workers, EveryTaskIsCalledOnce)
{
  for (const unsigned int count : {0U, 1U, 2U, threads}) {
    Workers workers(count);
    for (const std::size_t tasks : {0U, 1U, 2U, 3U, 1000U}) {
      for (int round = 0; round < 20; ++round) {
        EXPECT_EQ(callsOfARound(workers, tasks), std::vector<int>(tasks, 1)) << count << " threads";
      }
    }
  }
}

TEST(Workers, WakeWhenTheyHaveSlept)
{
  Workers workers(threads);
  for (int round = 0; round < 20; ++round) {
    fallAsleep();
    EXPECT_EQ(callsOfARound(workers, 100), std::vector<int>(100, 1));
  }
}

// The caller has nothing to do while another thread's task takes longer than it stays awake for.
TEST(Workers, CallerWaitsForTheLastTask)
{
  Workers workers(2);
  for (int round = 0; round < 20; ++round) {
    std::atomic<int> done{0};
    workers.run(2, [&done](std::size_t i, unsigned int) {
      if (i == 1) {
        fallAsleep();
      }
      ++done;
    });
    EXPECT_EQ(done, 2);
  }
}

TEST(Workers, NoNumberIsGivenToTwoAtATime)
{
  Workers workers(threads);
  std::array<std::atomic<int>, threads> busy{};
  std::atomic<int> clashes{0};
  std::atomic<int> strangers{0};
  for (int round = 0; round < 200; ++round) {
    workers.run(50, [&](std::size_t, unsigned int worker) {
      if (worker >= threads) {
        ++strangers;
        return;
      }
      clashes += busy[worker]++ == 0 ? 0 : 1;
      std::this_thread::yield();
      --busy[worker];
    });
  }
  EXPECT_EQ(clashes, 0);
  EXPECT_EQ(strangers, 0);
}

TEST(Workers, WhatATaskThrowsComesToTheCaller)
{
  Workers workers(threads);
  std::atomic<int> begun{0};
  const auto failing = [&begun](std::size_t i, unsigned int) {
    ++begun;
    if (i == 5) {
      throw std::runtime_error("the fifth");
    }
    std::this_thread::sleep_for(std::chrono::microseconds(100));
  };
  EXPECT_THROW(workers.run(10000, failing), std::runtime_error);
  EXPECT_LT(begun, 10000) << "tasks that were not begun are left out";
  EXPECT_EQ(callsOfARound(workers, 100), std::vector<int>(100, 1)) << "and the next round is as any other";
}

#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(Workers, ThreadsThatCannotBeHadAreAnException)
{
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto tooMany = [] {
    rlimit limit = {std::size_t(1) << 30, std::size_t(1) << 30}; // bytes; a thread's stack takes 8 MB
    setrlimit(RLIMIT_AS, &limit);
    Workers workers(4000);
    try {
      workers.run(10, [](std::size_t, unsigned int) {});
    }
    catch (const vpException &e) {
      const bool isSaid = std::string(e.what()).find("ask for fewer") != std::string::npos;
      workers.setCount(1);
      workers.run(10, [](std::size_t, unsigned int) {});
      std::_Exit(isSaid ? 0 : 2);
    }
    std::_Exit(1);
  };
  EXPECT_EXIT(tooMany(), ::testing::ExitedWithCode(0), "");
}
#endif

TEST(Workers, CopyHasThreadsOfItsOwn)
{
  Workers workers(2);
  Workers copy(workers);
  Workers assigned;
  assigned = workers;
  EXPECT_EQ(copy.getCount(), 2U);
  EXPECT_EQ(assigned.getCount(), 2U);
  std::atomic<int> calls{0};
  // A team within a task of another: with the same threads it would wait for itself.
  workers.run(2, [&](std::size_t i, unsigned int) {
    Workers &other = i == 0 ? copy : assigned;
    other.run(10, [&calls](std::size_t, unsigned int) { ++calls; });
  });
  EXPECT_EQ(calls, 20);
}

TEST(Workers, CountCanBeChanged)
{
  Workers workers(2);
  EXPECT_EQ(callsOfARound(workers, 10), std::vector<int>(10, 1));
  workers.setCount(threads);
  EXPECT_EQ(workers.getCount(), threads);
  EXPECT_EQ(callsOfARound(workers, 10), std::vector<int>(10, 1));
  workers.setCount(0);
  EXPECT_EQ(workers.getCount(), 1U);
}
