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
 * Tests of the arithmetic of circle-marker-accuracy: on errors drawn from known covariances.
 */

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include <gtest/gtest.h>

#include <visp3/core/vpExponentialMap.h>

#include "pose_check.h"
#include "record.h"
#include "summary.h"

using namespace accuracy;

namespace {
std::mt19937_64 seededFromTestName()
{
  std::uint64_t hash = 14695981039346656037u; // FNV-1a
  for (const char *c = ::testing::UnitTest::GetInstance()->current_test_info()->name(); *c != '\0'; ++c) {
    hash = (hash ^ static_cast<unsigned char>(*c)) * 1099511628211u;
  }
  return std::mt19937_64(hash);
}

double normal(std::mt19937_64 &random)
{
  return std::normal_distribution<double>()(random);
}

/*! A lower triangular root of a covariance of delta, with strong correlations, millimetres and milliradians. */
vpMatrix rootOfCovariance(std::mt19937_64 &random)
{
  vpMatrix root(6, 6, 0.);
  for (unsigned int i = 0; i < 6; ++i) {
    for (unsigned int j = 0; j <= i; ++j) {
      root[i][j] = (i < 3 ? 1e-3 : 3e-4) * (i == j ? 1. : normal(random));
    }
  }
  return root;
}

vpColVector drawn(const vpMatrix &root, std::mt19937_64 &random)
{
  vpColVector white(6);
  for (unsigned int i = 0; i < 6; ++i) {
    white[i] = normal(random);
  }
  return root * white;
}

const vpHomogeneousMatrix pose(0.3, -0.2, 4., 0.5, -0.3, 1.);
} // namespace

TEST(PoseCheck, MahalanobisOfHonestErrorsIsChiSquared)
{
  std::mt19937_64 random = seededFromTestName();
  const vpMatrix root = rootOfCovariance(random);
  const vpMatrix covariance = root * root.t();
  constexpr int count = 4000;
  double mean = 0.;
  double x = 0., z = 0., tilt = 0.;
  PoseCheck checked = {};
  for (int i = 0; i < count; ++i) {
    const vpHomogeneousMatrix truth = vpExponentialMap::direct(drawn(root, random)) * pose;
    checked = check(pose, truth, covariance, 6);
    mean += checked.mahalanobis / count;
    x += std::pow(truth[0][3] - pose[0][3], 2) / count;
    z += std::pow(truth[2][3] - pose[2][3], 2) / count;
    const vpColVector n = truth.getRotationMatrix().getCol(2), m = pose.getRotationMatrix().getCol(2);
    tilt += (n - m).sumSquare() / count; // The angle, squared, of a small one.
  }
  // The mean of 4000 chi-squared with 6 degrees of freedom has the deviation sqrt(12 / 4000) = 0.055.
  EXPECT_NEAR(mean, 6., 4. * 0.055);
  EXPECT_NEAR(std::sqrt(x) / checked.x, 1., 0.05);
  EXPECT_NEAR(std::sqrt(z) / checked.z, 1., 0.05);
  EXPECT_NEAR(std::sqrt(tilt) / checked.normal, 1., 0.05);
}

TEST(PoseCheck, SpinOfAPlainRingDoesNotCount)
{
  std::mt19937_64 random = seededFromTestName();
  const vpMatrix root = rootOfCovariance(random);
  constexpr int count = 4000;
  double mean = 0.;
  for (int i = 0; i < count; ++i) {
    const double spin = std::uniform_real_distribution<double>(-3., 3.)(random);
    const vpHomogeneousMatrix truth = vpExponentialMap::direct(drawn(root, random)) * pose;
    const vpHomogeneousMatrix measured = pose * vpHomogeneousMatrix(0., 0., 0., 0., 0., spin);
    mean += check(measured, truth, root * root.t(), 5).mahalanobis / count;
  }
  EXPECT_NEAR(mean, 5., 4. * std::sqrt(10. / count));
}

TEST(Summary, LeastMeansByTheBound)
{
  Record record;
  record.found = 1.;
  record.boundX = 1.;
  record.boundY = 2.;
  record.boundZ = 2.;
  record.boundNormal = 1.;
  record.predicted = 0.25;
  record.tilt = 10.;
  Record facing = record;
  facing.tilt = 0.5; // less than the bound of its normal
  Record lost = record;
  lost.found = 0.;
  EXPECT_NEAR(summaryOf({record, lost}).positionBound, 3. * 0.7978845608, 1e-8);
  EXPECT_NEAR(summaryOf({record, lost}).normalBound, 0.75 * 0.7978845608 + 0.25 * 20., 1e-8);
  EXPECT_NEAR(summaryOf({facing}).normalBound, 0.75 * 0.5 + 0.25 * 1., 1e-12);
}

TEST(Summary, RatiosBiasesAndCounts)
{
  std::mt19937_64 random = seededFromTestName();
  Records records;
  for (int i = 0; i < 2000; ++i) {
    Record record;
    record.found = i % 10 == 0 ? 0. : 1.;
    record.wrong = i % 10 == 1 ? 1. : 0.;
    record.distance = 5.;
    record.boundX = record.boundY = record.boundZ = 2.;
    record.boundNormal = 0.5;
    record.reportedX = record.reportedY = record.reportedZ = 4.;
    record.reportedNormal = 0.25;
    record.x = record.isWrong() ? 1e9 : 3. * normal(random);
    record.y = 2. * normal(random);
    record.z = 2. * normal(random) + 1.;
    record.normal = 0.5 * std::hypot(normal(random), normal(random)) / std::sqrt(2.);
    record.lean = 0.1;
    record.dof = 6.;
    record.mahalanobis = 9.;
    record.predicted = 0.05;
    records.push_back(record);
  }
  const Summary summary = summaryOf(records);
  EXPECT_EQ(summary.frames, 2000u);
  EXPECT_EQ(summary.found, 1800u);
  EXPECT_EQ(summary.wrong, 200u);
  EXPECT_EQ(summary.right, 1600u);
  EXPECT_NEAR(summary.predicted, 90., 1e-9);
  EXPECT_NEAR(summary.ratio[X], 1.5, 4. * 1.5 * summary.ratioError());
  EXPECT_NEAR(summary.ratio[Y], 1., 4. * summary.ratioError());
  EXPECT_NEAR(summary.ratio[Z], std::sqrt(1.25), 0.12);
  EXPECT_NEAR(summary.ratio[NORMAL], 1., 4. * summary.ratioError());
  EXPECT_NEAR(summary.bias[Z], 0.5, 0.1);
  EXPECT_NEAR(summary.bias[NORMAL], 0.2, 1e-9);
  EXPECT_NEAR(summary.depthBias, 100. * 1. / 5000., 0.004);
  EXPECT_NEAR(summary.optimism[Y], 0.5, 0.05);
  EXPECT_NEAR(summary.optimism[NORMAL], 2., 0.2);
  EXPECT_NEAR(summary.mahalanobis, 1.5, 1e-9);
  EXPECT_NEAR(summary.mahalanobis95, 9. / 12.5916, 1e-9);
  EXPECT_GT(summary.position, 1e8) << "wrong solutions count for the thesis's mean";
}

TEST(Summary, CalibrationOfTheLogOdds)
{
  Records records;
  for (int i = 0; i < 100; ++i) {
    Record record;
    record.found = 1.;
    record.predicted = 0.03;
    record.logOdds = std::log(0.97 / 0.03);
    record.wrong = i < 10 ? 1. : 0.;
    records.push_back(record);
    record.logOdds = HUGE_VAL; // No second pose.
    record.wrong = 0.;
    records.push_back(record);
    record.predicted = none; // Facing the camera: not asked.
    record.wrong = 1.;
    records.push_back(record);
  }
  const std::vector<Calibration> bins = calibrationOf(records);
  ASSERT_EQ(bins.size(), 4u);
  EXPECT_EQ(bins[2].frames, 100u);
  EXPECT_EQ(bins[2].right, 90u);
  EXPECT_NEAR(bins[2].reported, 0.97, 1e-9);
  EXPECT_EQ(bins[3].frames, 100u);
  EXPECT_EQ(bins[3].right, 100u);
  EXPECT_EQ(bins[0].frames + bins[1].frames, 0u);
}

TEST(RecordFile, IsReadAsItWasWritten)
{
  Record record;
  record.part = "limits";
  record.group = "golay23";
  record.method = "circle";
  record.frame = 7.;
  record.found = 1.;
  record.wrong = 0.;
  record.z = -0.0123456789;
  record.logOdds = HUGE_VAL;
  record.boundNormal = 1.25e-4;
  record.predicted = 1.7e-317; // Smaller than std::stod reads.
  const std::string file = (std::filesystem::temp_directory_path() / "testAccuracyStatistics.csv").string();
  std::ofstream(file) << csvOf({"a comment", "another"}, {record, Record()});
  const Records read = readCsv(file);
  ASSERT_EQ(read.size(), 2u);
  EXPECT_EQ(read[0].part, "limits");
  EXPECT_EQ(read[0].group, "golay23");
  EXPECT_NEAR(read[0].z, record.z, 1e-9);
  EXPECT_EQ(read[0].logOdds, HUGE_VAL);
  EXPECT_DOUBLE_EQ(read[0].boundNormal, 1.25e-4);
  EXPECT_LT(read[0].predicted, 1e-300);
  EXPECT_TRUE(std::isnan(read[0].x));
  EXPECT_FALSE(read[1].isFound());
  EXPECT_EQ(readComments(file), (std::vector<std::string>{"a comment", "another"}));

  std::ofstream(file) << "part,z_mm\nlimits,12x\n";
  EXPECT_THROW(readCsv(file), std::runtime_error);
  std::ofstream(file) << "part,z_mm\nlimits\n";
  EXPECT_THROW(readCsv(file), std::runtime_error);
  std::filesystem::remove(file);
  EXPECT_THROW(readCsv(file), std::runtime_error);
}
