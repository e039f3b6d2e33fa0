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
 * What the detector allocates once it has seen an image like it.
 */

#include <atomic>
#include <cstdlib>

#include <gtest/gtest.h>

#include "detector_scenes.h"

using namespace detector_test;

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

// All of the heap comes through these: operator new, ViSP's arrays, Eigen and OpenCV. glibc lets a program replace them
// and gives its own under other names.
namespace {
std::atomic<bool> isCounting(false);
std::atomic<unsigned long> allocations(0);
std::atomic<unsigned long> failing(0); // which of them there is no memory for, from 1; 0: there is for all

// Counts an allocation; whether there is memory for it.
bool count()
{
  return !isCounting.load(std::memory_order_relaxed) || ++allocations != failing;
}
} // namespace

extern "C" {
void *__libc_malloc(std::size_t size);
void *__libc_calloc(std::size_t number, std::size_t size);
void *__libc_realloc(void *memory, std::size_t size);
void *__libc_memalign(std::size_t alignment, std::size_t size);

void *malloc(std::size_t size)
{
  return count() ? __libc_malloc(size) : nullptr;
}

void *calloc(std::size_t number, std::size_t size)
{
  return count() ? __libc_calloc(number, size) : nullptr;
}

void *realloc(void *memory, std::size_t size)
{
  return count() ? __libc_realloc(memory, size) : nullptr;
}

void *aligned_alloc(std::size_t alignment, std::size_t size)
{
  return count() ? __libc_memalign(alignment, size) : nullptr;
}

int posix_memalign(void **memory, std::size_t alignment, std::size_t size)
{
  *memory = count() ? __libc_memalign(alignment, size) : nullptr;
  return *memory == nullptr ? 12 : 0; // ENOMEM
}
}

namespace {
//! Allocations of one call of detect() after a few on the same images.
unsigned long allocationsOf(vpDetectorCircleMarker &detector, const std::vector<vpImage<unsigned char>> &images)
{
  std::vector<vpHomogeneousMatrix> poses;
  constexpr int warming = 3;
  for (int i = 0; i < warming; ++i) {
    for (const vpImage<unsigned char> &I : images) {
      detector.detect(I, size, straightCamera(), poses);
    }
  }
  allocations = 0;
  isCounting = true;
  for (const vpImage<unsigned char> &I : images) {
    detector.detect(I, size, straightCamera(), poses);
  }
  isCounting = false;
  return allocations;
}

vpImage<unsigned char> clutter(Random &random, const std::vector<vpSimulatedMarker> &markers)
{
  vpMarkerSceneSimulator simulator(straightCamera(), width, height);
  simulator.setBackground(vpSceneBackground::clutter(random(), 40));
  for (const vpSimulatedMarker &marker : markers) {
    simulator.addMarker(marker);
  }
  vpImage<unsigned char> I;
  simulator.render(I, random());
  return I;
}
} // namespace

TEST(DetectorAllocations, TheCounterCounts)
{
  allocations = 0;
  isCounting = true;
  std::vector<int> *list = new std::vector<int>(100);
  vpMatrix matrix(6, 6);
  isCounting = false;
  delete list;
  EXPECT_GE(allocations, 3u);
}

// An image that there is no memory for leaves no markers, and nothing that the next image would be mistaken by.
TEST(DetectorAllocations, WantOfMemoryLeavesNoMarkers)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
  vpSimulatedMarker marker = vpSimulatedMarker::circle("golay23", randomId(random, family), size);
  const vpImage<unsigned char> I = clutter(random, {marker.setPose(randomPose(random, 90., 0.5))});
  for (const auto polarity : {vpCircleMarkerPolarity::BLACK_ON_WHITE, vpCircleMarkerPolarity::BOTH}) {
    std::vector<vpHomogeneousMatrix> poses;
    vpDetectorCircleMarker expected(family);
    expected.setPolarity(polarity);
    expected.setDebug(true);
    ASSERT_TRUE(expected.detect(I, size, straightCamera(), poses));
    const std::size_t rejected = expected.getRejectedCandidates().size();
    int failures = 0;
    bool isOver = false;
    // The first one by one, where working memory is made; then ever fewer.
    for (unsigned long n = 1; !isOver; n += 1 + n / 25) {
      vpDetectorCircleMarker detector(expected); // with results, and working memory
      detector.setTracking(true);
      allocations = 0;
      failing = n;
      isCounting = true;
      try {
        detector.detect(I, size, straightCamera(), poses);
        isOver = true;
      }
      catch (const std::exception &) { // std::bad_alloc, or ViSP's vpException
      }
      isCounting = false;
      failing = 0;
      if (!isOver) {
        ++failures;
        ASSERT_EQ(detector.getNbObjects(), 0u) << n;
        ASSERT_EQ(detector.getDetections().size(), 0u) << n;
        ASSERT_EQ(detector.getPolygon().size(), 0u) << n;
        ASSERT_EQ(detector.getMessage().size(), 0u) << n;
        vpHomogeneousMatrix cMo;
        ASSERT_THROW(detector.getPose(0, size, straightCamera(), cMo), vpException) << n;
        ASSERT_TRUE(detector.detect(I, size, straightCamera(), poses)) << n;
        ASSERT_EQ(detector.getNbObjects(), expected.getNbObjects()) << n;
        ASSERT_EQ(detector.getRejectedCandidates().size(), rejected) << n;
        ASSERT_EQ(differenceOf(poses[0], expected.getDetections()[0].cMo), 0.) << n;
      }
    }
    EXPECT_GT(failures, 50);
  }
}

// Where markers are followed and are whole nothing else is read. An image of which they are followed that there is no
// memory for does not leave it so: in the next one a covered marker is found.
TEST(DetectorAllocations, WantOfMemoryWhileFollowingLeavesCoveredMarkers)
{
  Random random = randomOfTest();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::BCH31R);
  vpSimulatedMarker marker = vpSimulatedMarker::circle("bch31r", randomId(random, family), size);
  marker.setPose(vpHomogeneousMatrix(0., 0., 1., 0.3, 0.2, 0.));
  vpMarkerSceneSimulator simulator(straightCamera(), width, height);
  simulator.addMarker(marker);
  vpImage<unsigned char> whole;
  simulator.render(whole, random());
  std::vector<vpImagePoint> cover;
  for (const auto &[x, y] : {std::pair<double, double>{0.02, -0.2}, {0.2, -0.2}, {0.2, 0.2}, {0.02, 0.2}}) {
    cover.push_back(simulator.project(x, y, 1.));
  }
  simulator.addOccluder(vpSceneOccluder::polygon(cover, 30.));
  vpImage<unsigned char> covered;
  simulator.render(covered, random());
  std::vector<vpHomogeneousMatrix> poses;
  vpDetectorCircleMarker following(family);
  ASSERT_TRUE(following.detect(covered, size, straightCamera(), poses));
  following.setTracking(true);
  ASSERT_TRUE(following.detect(whole, size, straightCamera(), poses));
  int failures = 0;
  bool isOver = false;
  for (unsigned long n = 1; !isOver; ++n) {
    vpDetectorCircleMarker detector(following); // with its tracks, and without working memory
    allocations = 0;
    failing = n;
    isCounting = true;
    try {
      detector.detect(whole, size, straightCamera(), poses);
      isOver = true;
    }
    catch (const std::exception &) { // std::bad_alloc, or ViSP's vpException
    }
    isCounting = false;
    failing = 0;
    if (!isOver) {
      ++failures;
      ASSERT_TRUE(detector.detect(covered, size, straightCamera(), poses)) << n;
    }
  }
  EXPECT_GT(failures, 50);
}

TEST(DetectorAllocations, NoneWithoutAMarker)
{
  Random random = randomOfTest();
  std::vector<vpImage<unsigned char>> images;
  for (int i = 0; i < 4; ++i) {
    images.push_back(clutter(random, {}));
  }
  vpDetectorCircleMarker detector;
  EXPECT_EQ(allocationsOf(detector, images), 0u);
  // Which of two threads gets which outlines changes from call to call: it takes more of them until each has seen all.
  detector.setNbThreads(2);
  unsigned long least = 1;
  for (int i = 0; i < 20 && least > 0; ++i) {
    least = std::min(least, allocationsOf(detector, images));
  }
  EXPECT_EQ(least, 0u);
}

// On plain ground: an outline of the clutter that looks blurred is read as blurred markers are, which allocates.
TEST(DetectorAllocations, NoneWithAMarker)
{
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31R, vpCircleMarkerFamily::RING}) {
    const vpCircleMarkerFamily family(type);
    vpDetectorCircleMarker detector(family);
    for (const double diameter : {20., 45., 60., 120., 250.}) {
      vpMarkerSceneSimulator simulator(straightCamera(), width, height);
      vpSimulatedMarker marker = vpSimulatedMarker::circle(family.getName(), randomId(random, family), size);
      simulator.addMarker(marker.setPose(randomPose(random, diameter, 0.6)));
      vpImage<unsigned char> I;
      simulator.render(I, random());
      EXPECT_EQ(allocationsOf(detector, {I}), 0u) << family.getName() << ", diameter " << diameter;
      EXPECT_EQ(detector.getNbObjects(), 1u) << family.getName() << ", diameter " << diameter;
    }
  }
}

#else

TEST(DetectorAllocations, AreCountedWithGlibcAndNoSanitizer)
{
  GTEST_SKIP() << "the heap's functions cannot be replaced here";
}

#endif
