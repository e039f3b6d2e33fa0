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
 * Tests of the families of circular markers: numbering, layouts, errors.
 */

#include <bitset>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include <visp3/circle_marker/vpCircleMarkerFamily.h>
#include <visp3/core/vpException.h>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace {
/*! A word of n bits with the content of sector k moved to sector k + rotation, written sector by sector. */
std::uint32_t turned(std::uint32_t word, unsigned int n, unsigned int rotation)
{
  std::uint32_t result = 0;
  for (unsigned int sector = 0; sector < n; ++sector) {
    if ((word >> (n - 1 - sector)) & 1) {
      result |= std::uint32_t(1) << (n - 1 - (sector + rotation) % n);
    }
  }
  return result;
}

std::string messageOf(const std::string &unknownName)
{
  try {
    vpCircleMarkerFamily::fromName(unknownName);
  }
  catch (vpException &e) {
    EXPECT_EQ(vpException::badValue, e.getCode());
    return e.what();
  }
  return "";
}
} // namespace

// Printed markers stay valid for ever only if these figures never change.
TEST(CircleMarkerFamily, NumberingIsFixed)
{
  struct Expected
  {
    const char *name;
    unsigned int nbSectors, nbIds, minimumDistance;
    std::uint32_t first[3];
  };
  const Expected families[] = {{"golay23", 23, 178, 7, {2787, 7973, 8559}},
                               {"bch31", 31, 2114, 7, {36783, 102641, 176403}},
                               {"bch31r", 31, 66, 11, {1451733, 3828607, 5160321}}};
  for (const Expected &expected : families) {
    SCOPED_TRACE(expected.name);
    const vpCircleMarkerFamily family = vpCircleMarkerFamily::fromName(expected.name);
    EXPECT_EQ(expected.name, family.getName());
    EXPECT_TRUE(family.isCoded());
    EXPECT_EQ(expected.nbSectors, family.getNbSectors());
    EXPECT_EQ(expected.nbIds, family.getNbIds());
    EXPECT_EQ(expected.minimumDistance, family.getMinimumDistance());
    for (int id = 0; id < 3; ++id) {
      EXPECT_EQ(expected.first[id], family.getCodeword(id));
    }
    const int last = static_cast<int>(expected.nbIds) - 1;
    EXPECT_NO_THROW(family.getCodeword(last));
    EXPECT_THROW(family.getCodeword(last + 1), vpException);
    EXPECT_THROW(family.getCodeword(-1), vpException);
  }
}

TEST(CircleMarkerFamily, CodewordsAscendAndAreTheSmallestOfTheirOrbits)
{
  for (const vpCircleMarkerFamily &family : vpCircleMarkerFamily::all()) {
    SCOPED_TRACE(family.getName());
    const unsigned int n = family.getNbSectors();
    std::uint32_t previous = 0;
    for (int id = 0; id < static_cast<int>(family.getNbIds()); ++id) {
      const std::uint32_t word = family.getCodeword(id);
      EXPECT_GT(word, previous);
      previous = word;
      for (unsigned int rotation = 1; rotation < n; ++rotation) {
        ASSERT_LT(word, turned(word, n, rotation)) << "id " << id << " rotation " << rotation;
      }
    }
  }
}

// Brute force over pairs of markers and all their relative rotations, independent of the algebra of the code.
TEST(CircleMarkerFamily, MarkersDifferByTheMinimumDistanceInEveryRotation)
{
  for (const vpCircleMarkerFamily &family : vpCircleMarkerFamily::all()) {
    if (!family.isCoded()) {
      continue;
    }
    SCOPED_TRACE(family.getName());
    const unsigned int n = family.getNbSectors();
    const int nbIds = static_cast<int>(family.getNbIds());
    const std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    std::seed_seq seed(name.begin(), name.end());
    std::mt19937 random(seed);
    std::uniform_int_distribution<int> anyId(0, nbIds - 1);
    for (int trial = 0; trial < 20000; ++trial) {
      const int first = anyId(random);
      const int second = anyId(random);
      for (unsigned int rotation = first == second ? 1 : 0; rotation < n; ++rotation) {
        const std::uint32_t difference = family.getCodeword(first) ^ turned(family.getCodeword(second), n, rotation);
        ASSERT_GE(std::bitset<32>(difference).count(), family.getMinimumDistance())
            << "ids " << first << " and " << second << " rotation " << rotation;
      }
    }
  }
}

TEST(CircleMarkerFamily, SectorZeroIsTheMostSignificantBit)
{
  const vpCircleMarkerFamily golay23(vpCircleMarkerFamily::GOLAY23);
  // 2787 = 0b00000000000101011100011 in 23 bits.
  const std::string sectors = "00000000000101011100011";
  for (unsigned int k = 0; k < 23; ++k) {
    EXPECT_EQ(sectors[k] == '1', golay23.isSectorBlack(0, k)) << "sector " << k;
  }
  EXPECT_THROW(golay23.isSectorBlack(0, 23), vpException);
  EXPECT_THROW(golay23.isSectorBlack(178, 0), vpException);
}

TEST(CircleMarkerFamily, LayoutsAreOrderedFromOutsideIn)
{
  for (const vpCircleMarkerFamily &family : vpCircleMarkerFamily::all()) {
    SCOPED_TRACE(family.getName());
    const vpCircleMarkerLayout &layout = family.getLayout();
    EXPECT_LT(layout.ringInner, 1);
    EXPECT_GT(layout.quietZone, 0);
    if (family.isCoded()) {
      EXPECT_LT(layout.codeOuter, layout.ringInner);
      EXPECT_LT(layout.codeInner, layout.codeOuter);
      EXPECT_GT(layout.codeInner, 0);
    }
    else {
      EXPECT_EQ(0, layout.codeOuter);
      EXPECT_EQ(0, layout.codeInner);
      EXPECT_EQ(0u, family.getNbIds());
      EXPECT_THROW(family.getCodeword(0), vpException);
      EXPECT_THROW(family.isSectorBlack(0, 0), vpException);
    }
  }
  EXPECT_EQ(0, vpCircleMarkerFamily(vpCircleMarkerFamily::DISC).getLayout().ringInner);
}

TEST(CircleMarkerFamily, RingTakesAnyRatioBetweenZeroAndOne)
{
  const vpCircleMarkerFamily ring = vpCircleMarkerFamily::ring(0.7);
  EXPECT_EQ(vpCircleMarkerFamily::RING, ring.getType());
  EXPECT_EQ(0.7, ring.getLayout().ringInner);
  for (const double wrong : {0., 1., -0.5, 1.5, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(vpCircleMarkerFamily::ring(wrong), vpException) << wrong;
  }
}

TEST(CircleMarkerFamily, LayoutsOfAStudyKeepTheCode)
{
  vpCircleMarkerLayout layout;
  layout.ringInner = 0.7;
  layout.codeOuter = 0.6;
  layout.codeInner = 0.3;
  layout.quietZone = 0.25;
  const vpCircleMarkerFamily family = vpCircleMarkerFamily(vpCircleMarkerFamily::BCH31).withLayout(layout);
  EXPECT_EQ(family.getName(), "bch31");
  EXPECT_EQ(family.getCodeword(7), vpCircleMarkerFamily(vpCircleMarkerFamily::BCH31).getCodeword(7));
  EXPECT_EQ(family.getLayout().ringInner, 0.7);
  EXPECT_EQ(family.getLayout().codeInner, 0.3);
  const vpCircleMarkerFamily ring = vpCircleMarkerFamily(vpCircleMarkerFamily::RING).withLayout(layout);
  EXPECT_EQ(ring.getLayout().codeOuter, 0.); // Without a code there is no track.

  const auto refused = [](double codeInner, double codeOuter, double ringInner, double quietZone) {
    vpCircleMarkerLayout bad;
    bad.codeInner = codeInner;
    bad.codeOuter = codeOuter;
    bad.ringInner = ringInner;
    bad.quietZone = quietZone;
    EXPECT_THROW(vpCircleMarkerFamily().withLayout(bad), vpException);
  };
  refused(0.6, 0.4, 0.8, 0.2);
  refused(0.4, 0.9, 0.8, 0.2);
  refused(0., 0.6, 0.8, 0.2);
  refused(0.4, 0.6, 1., 0.2);
  refused(0.4, 0.6, 0.8, 0.);
  refused(std::nan(""), 0.6, 0.8, 0.2);
  refused(0.4, 0.6, 0.8, HUGE_VAL);
}

TEST(CircleMarkerFamily, ADiscIsBlackToItsCentreAndARingIsNot)
{
  const auto isTaken = [](vpCircleMarkerFamily::vpType type, double ringInner) {
    vpCircleMarkerLayout layout;
    layout.ringInner = ringInner;
    try {
      vpCircleMarkerFamily(type).withLayout(layout);
      return true;
    }
    catch (const vpException &error) {
      EXPECT_EQ(error.getCode(), vpException::badValue);
      return false;
    }
  };
  EXPECT_TRUE(isTaken(vpCircleMarkerFamily::DISC, 0.));
  EXPECT_FALSE(isTaken(vpCircleMarkerFamily::DISC, 0.5));
  EXPECT_TRUE(isTaken(vpCircleMarkerFamily::RING, 0.5));
  EXPECT_FALSE(isTaken(vpCircleMarkerFamily::RING, 0.));
}

TEST(CircleMarkerFamily, UnknownNamesAreRefusedWithTheKnownOnes)
{
  for (const std::string unknown : {"", "Golay23", "golay", "bch31 ", "36h11"}) {
    const std::string message = messageOf(unknown);
    for (const vpCircleMarkerFamily &family : vpCircleMarkerFamily::all()) {
      EXPECT_NE(std::string::npos, message.find(family.getName())) << message;
    }
  }
  EXPECT_EQ(5u, vpCircleMarkerFamily::all().size());
}
