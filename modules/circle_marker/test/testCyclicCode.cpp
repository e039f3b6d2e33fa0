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
 * Tests of cyclic codes: distances, error correction, erasures, identification.
 */

#include <algorithm>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <visp3/core/vpException.h>

#include "../src/decode/cyclic_code.h"

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif
using circle_marker::codeOf;
using circle_marker::CyclicCode;
using circle_marker::hammingDistance;
using Word = CyclicCode::Word;

namespace {
const vpCircleMarkerFamily::vpType codedFamilies[] = {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31,
                                                      vpCircleMarkerFamily::BCH31R};

/*! A generator of random numbers that depends on the running test's name and nothing else. */
std::mt19937 randomOfTest()
{
  const std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name();
  std::seed_seq seed(name.begin(), name.end());
  return std::mt19937(seed);
}

/*! A word with \e nbOnes ones among the \e n bits, all such words equally likely. */
Word randomPattern(unsigned int n, unsigned int nbOnes, std::mt19937 &random)
{
  std::vector<unsigned int> bits(n);
  std::iota(bits.begin(), bits.end(), 0U);
  std::shuffle(bits.begin(), bits.end(), random);
  Word pattern = 0;
  for (unsigned int i = 0; i < nbOnes; ++i) {
    pattern |= Word(1) << bits[i];
  }
  return pattern;
}

Word randomCodeword(const CyclicCode &code, std::mt19937 &random)
{
  return code.encode(static_cast<Word>(random()) & ((Word(1) << code.getDimension()) - 1));
}

/*! Nearest codewords by comparing with every one of the code. */
unsigned int nearestByBruteForce(const CyclicCode &code, Word word, Word &nearest)
{
  unsigned int best = 32;
  for (Word message = 0; message < (Word(1) << code.getDimension()); ++message) {
    const Word codeword = code.encode(message);
    const unsigned int distance = hammingDistance(codeword, word);
    if (distance < best) {
      best = distance;
      nearest = codeword;
    }
  }
  return best;
}
} // namespace

// In a linear code the minimum distance is the least weight of the nonzero codewords; in a cyclic one every rotation
// of a codeword is among them, so this is the distance between any two markers in any rotations.
TEST(CyclicCode, MinimumWeightIsTheMinimumDistance)
{
  for (const vpCircleMarkerFamily::vpType type : codedFamilies) {
    const vpCircleMarkerFamily family(type);
    SCOPED_TRACE(family.getName());
    const CyclicCode &code = codeOf(family);
    unsigned int minimumWeight = 32;
    std::set<Word> codewords;
    for (Word message = 0; message < (Word(1) << code.getDimension()); ++message) {
      const Word codeword = code.encode(message);
      ASSERT_EQ(code.correct(codeword, 0), std::optional<Word>(codeword));
      const Word turned = code.rotate(codeword, 1);
      ASSERT_EQ(code.correct(turned, 0), std::optional<Word>(turned)) << "is a codeword, too";
      codewords.insert(codeword);
      if (codeword != 0) {
        minimumWeight = std::min(minimumWeight, hammingDistance(codeword, 0));
      }
    }
    EXPECT_EQ(family.getMinimumDistance(), minimumWeight);
    EXPECT_EQ(std::size_t(1) << code.getDimension(), codewords.size());
    // All codewords but the two constant ones are rotations of the markers, each of exactly one.
    EXPECT_EQ(codewords.size() - 2, code.getRepresentatives().size() * code.getLength());
    EXPECT_EQ(family.getNbIds(), code.getRepresentatives().size());
  }
}

TEST(CyclicCode, RotationMovesSectorsUp)
{
  const CyclicCode &code = codeOf(vpCircleMarkerFamily::GOLAY23);
  std::mt19937 random = randomOfTest();
  for (int trial = 0; trial < 100; ++trial) {
    const Word word = static_cast<Word>(random()) & 0x7FFFFF;
    for (unsigned int rotation = 0; rotation <= 46; ++rotation) {
      const Word turned = code.rotate(word, rotation);
      for (unsigned int k = 0; k < 23; ++k) {
        ASSERT_EQ((word >> (22 - k)) & 1, (turned >> (22 - (k + rotation) % 23)) & 1);
      }
    }
  }
}

TEST(CyclicCode, EveryRotationOfEveryIdIsIdentified)
{
  for (const vpCircleMarkerFamily::vpType type : codedFamilies) {
    const vpCircleMarkerFamily family(type);
    SCOPED_TRACE(family.getName());
    const CyclicCode &code = codeOf(family);
    for (int id = 0; id < static_cast<int>(family.getNbIds()); ++id) {
      for (unsigned int rotation = 0; rotation < code.getLength(); ++rotation) {
        const auto identity = code.identify(code.rotate(family.getCodeword(id), rotation));
        ASSERT_TRUE(identity);
        ASSERT_EQ(id, identity->id);
        ASSERT_EQ(rotation, identity->rotation);
      }
    }
  }
}

TEST(CyclicCode, ConstantAndForeignWordsAreNoMarkers)
{
  for (const vpCircleMarkerFamily::vpType type : codedFamilies) {
    const CyclicCode &code = codeOf(type);
    const Word ones = (Word(1) << code.getLength()) - 1;
    EXPECT_FALSE(code.identify(0));
    EXPECT_FALSE(code.identify(ones));
    EXPECT_FALSE(code.identify(code.getRepresentatives()[0] ^ 1));
    EXPECT_FALSE(code.identify(code.getRepresentatives()[0] | (Word(1) << code.getLength())));
  }
  EXPECT_THROW(codeOf(vpCircleMarkerFamily::RING), vpException);
  EXPECT_THROW(codeOf(vpCircleMarkerFamily::DISC), vpException);
}

// Not even one that is a codeword but for bits that no sector has.
TEST(CyclicCode, BitsBeyondTheSectorsAreNoMarkers)
{
  for (const vpCircleMarkerFamily::vpType type : codedFamilies) {
    const vpCircleMarkerFamily family(type);
    const CyclicCode &code = codeOf(family);
    const Word beyond = Word(1) << code.getLength();
    for (int id = 0; id < static_cast<int>(family.getNbIds()); ++id) {
      for (unsigned int rotation = 0; rotation < code.getLength(); ++rotation) {
        ASSERT_FALSE(code.identify(code.rotate(family.getCodeword(id), rotation) | beyond)) << family.getName();
      }
    }
  }
}

// The Golay code is perfect: the patterns of up to 3 errors are all its cosets, 1 + 23 + 253 + 1771 = 2^11.
TEST(CyclicCode, GolayCorrectsEveryPatternOfUpToThreeErrors)
{
  const CyclicCode &code = codeOf(vpCircleMarkerFamily::GOLAY23);
  std::mt19937 random = randomOfTest();
  unsigned int nbPatterns = 0;
  for (Word errors = 0; errors < (Word(1) << 23); ++errors) {
    const unsigned int nbErrors = hammingDistance(errors, 0);
    if (nbErrors > 3) {
      continue;
    }
    ++nbPatterns;
    const Word codeword = randomCodeword(code, random);
    const auto corrected = code.correct(codeword ^ errors, 3);
    ASSERT_TRUE(corrected);
    ASSERT_EQ(codeword, *corrected);
    if (nbErrors > 0) {
      ASSERT_FALSE(code.correct(codeword ^ errors, nbErrors - 1));
    }
  }
  EXPECT_EQ(2048u, nbPatterns);
}

TEST(CyclicCode, RandomErrorsUpToTheCapacityAreCorrected)
{
  for (const vpCircleMarkerFamily::vpType type : codedFamilies) {
    SCOPED_TRACE(vpCircleMarkerFamily(type).getName());
    const CyclicCode &code = codeOf(type);
    std::mt19937 random = randomOfTest();
    for (int trial = 0; trial < 20000; ++trial) {
      const unsigned int nbErrors = static_cast<unsigned int>(trial) % (code.getCapacity() + 1);
      const Word codeword = randomCodeword(code, random);
      const Word word = codeword ^ randomPattern(code.getLength(), nbErrors, random);
      const auto corrected = code.correct(word, code.getCapacity() + 7);
      ASSERT_TRUE(corrected);
      ASSERT_EQ(codeword, *corrected);
      if (nbErrors > 0) {
        ASSERT_FALSE(code.correct(word, nbErrors - 1));
      }
    }
  }
}

// Any word, also far from the code: the answer is that of a search through all codewords.
TEST(CyclicCode, AnyWordIsCorrectedAsByBruteForce)
{
  for (const vpCircleMarkerFamily::vpType type : codedFamilies) {
    SCOPED_TRACE(vpCircleMarkerFamily(type).getName());
    const CyclicCode &code = codeOf(type);
    std::mt19937 random = randomOfTest();
    int nbRefused = 0;
    for (int trial = 0; trial < 200; ++trial) {
      const Word word = static_cast<Word>(random()) & ((Word(1) << code.getLength()) - 1);
      Word nearest = 0;
      const unsigned int distance = nearestByBruteForce(code, word, nearest);
      const auto corrected = code.correct(word, code.getCapacity());
      ASSERT_EQ(distance <= code.getCapacity(), corrected.has_value());
      if (corrected) {
        ASSERT_EQ(nearest, *corrected);
      }
      else {
        ++nbRefused;
      }
    }
    // The perfect code accepts any word; the others refuse most: 1 - (sum of C(31, 0..t)) / 2^(31-k).
    if (type == vpCircleMarkerFamily::GOLAY23) {
      EXPECT_EQ(0, nbRefused);
    }
    else {
      EXPECT_GT(nbRefused, 100);
    }
  }
}

TEST(CyclicCode, GeneratorsThatMakeNoCyclicCodeAreRefused)
{
  EXPECT_THROW(CyclicCode(23, 0xAE5, 7), vpException);
  EXPECT_THROW(CyclicCode(24, 0xAE3, 7), vpException);
  EXPECT_THROW(CyclicCode(32, 0x8FAF, 7), vpException);
  EXPECT_THROW(CyclicCode(23, 1, 7), vpException);
  EXPECT_NO_THROW(CyclicCode(7, 0xB, 3)); // Hamming [7,4,3]: x^3 + x + 1 divides x^7 - 1.
}

TEST(CyclicCode, OneTableWhateverTheNumberOfThreads)
{
  std::vector<const CyclicCode *> codes(8, nullptr);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < codes.size(); ++i) {
    threads.emplace_back([&codes, i] { codes[i] = &codeOf(vpCircleMarkerFamily::BCH31R); });
  }
  for (std::thread &thread : threads) {
    thread.join();
  }
  for (const CyclicCode *code : codes) {
    EXPECT_EQ(codes[0], code);
  }
}
