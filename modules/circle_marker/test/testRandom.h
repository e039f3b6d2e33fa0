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
 * Random numbers of tests.
 */

#ifndef VP_TEST_RANDOM_H
#define VP_TEST_RANDOM_H

#include <random>
#include <string>

#include <gtest/gtest.h>

namespace random_test {
using Random = std::mt19937_64;

//! Random numbers that depend on the running test's name and nothing else.
inline Random randomOfTest()
{
  const auto *info = ::testing::UnitTest::GetInstance()->current_test_info();
  const std::string name = std::string(info->test_suite_name()) + "." + info->name();
  std::seed_seq seed(name.begin(), name.end());
  return Random(seed);
}

inline double uniform(Random &random, double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}
} // namespace random_test

#endif
