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
 * Tests of the search for the two codewords that leave the least.
 */

#include "refine/word_search.h"

#include <gtest/gtest.h>

#include "testRandom.h"

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif
using namespace circle_marker;
using namespace random_test;

namespace {
// A track of pixels that each see some neighbouring sectors, and here and there some on the other side.
Squares trackOf(Random &random, CyclicCode::Word word, int sectors, double noise, double shareAcross)
{
  std::normal_distribution<double> normal;
  Squares squares;
  for (int pixel = 0; pixel < 6 * sectors; ++pixel) {
    SectorVector weights = SectorVector::Zero();
    const double place = uniform(random, 0., sectors);
    const bool seesAcross = uniform(random, 0., 1.) < shareAcross;
    for (int k = -3; k <= 3; ++k) {
      const int sector = static_cast<int>(std::floor(place)) + k;
      const double weight = std::exp(-0.5 * std::pow(sector + 0.5 - place, 2));
      weights[(sector + sectors) % sectors] += weight;
      weights[(sector + sectors + sectors / 2) % sectors] += seesAcross ? 0.7 * weight : 0.;
    }
    double black = noise * normal(random);
    for (int sector = 0; sector < sectors; ++sector) {
      black += isSectorBlack(word, sector, sectors) ? weights[sector] : 0.;
    }
    squares.matrix += weights * weights.transpose();
    squares.right += black * weights;
    squares.squares += black * black;
  }
  return squares;
}

double squaresOfWord(const Squares &squares, CyclicCode::Word word, int sectors)
{
  SectorVector bits = SectorVector::Zero();
  for (int sector = 0; sector < sectors; ++sector) {
    bits[sector] = isSectorBlack(word, sector, sectors) ? 1. : 0.;
  }
  return squares.squares - 2. * squares.right.dot(bits) + bits.dot(squares.matrix * bits);
}

// By trying all.
std::array<CostedWord, 2> bestTwoOfAll(const Squares &squares, const CyclicCode &code)
{
  const int sectors = static_cast<int>(code.getLength());
  std::array<CostedWord, 2> two = {{{0, squares.squares}, {0, HUGE_VAL}}};
  code.forEachCodeword([&](CyclicCode::Word word) {
    const CostedWord here = {word, squaresOfWord(squares, word, sectors)};
    if (here.squares < two[0].squares) {
      two = {{here, two[0]}};
    }
    else if (here.squares < two[1].squares) {
      two[1] = here;
    }
  });
  return two;
}

void expectSame(const Squares &squares, const CyclicCode &code, const std::string &what)
{
  const auto found = bestTwoWords(squares, code);
  const auto truth = bestTwoOfAll(squares, code);
  for (std::size_t i = 0; i < truth.size(); ++i) {
    EXPECT_EQ(found[i].word, truth[i].word) << what << ", place " << i;
    EXPECT_NEAR(found[i].squares, truth[i].squares, 1e-4 * squares.squares) << what << ", place " << i;
  }
}
} // namespace

TEST(WordSearch, FindsWhatTryingAllFinds)
{
  Random random = randomOfTest();
  for (const auto type : {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31R, vpCircleMarkerFamily::BCH31}) {
    const vpCircleMarkerFamily family(type);
    const CyclicCode &code = codeOf(family);
    const int sectors = static_cast<int>(code.getLength());
    const int rounds = type == vpCircleMarkerFamily::BCH31 ? 2 : 10; // it has 65535 words
    for (int i = 0; i < rounds; ++i) {
      for (const double noise : {0.05, 0.5, 3.}) {
        for (const double shareAcross : {0., 0.3}) {
          const auto id = random() % code.getRepresentatives().size();
          const auto turned = static_cast<unsigned int>(random() % code.getLength());
          const CyclicCode::Word word = code.rotate(code.getRepresentatives()[id], turned);
          expectSame(trackOf(random, word, sectors, noise, shareAcross), code,
                     family.getName() + ", noise " + std::to_string(noise));
        }
      }
    }
  }
}

TEST(WordSearch, AWhiteTrackIsTheZeroWordAndABlackOneAllOnes)
{
  Random random = randomOfTest();
  const CyclicCode &code = codeOf(vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23));
  const Squares white = trackOf(random, 0, 23, 0.1, 0.3);
  EXPECT_EQ(bestTwoWords(white, code)[0].word, 0u);
  EXPECT_DOUBLE_EQ(bestTwoWords(white, code)[0].squares, white.squares);
  expectSame(white, code, "white");
  const Squares black = trackOf(random, (1U << 23) - 1, 23, 0.1, 0.3);
  EXPECT_EQ(bestTwoWords(black, code)[0].word, (1U << 23) - 1);
  expectSame(black, code, "black");
}

// Below the limit nothing is missed, beyond it nothing comes out.
TEST(WordSearch, WhatLeavesAsMuchAsTheLimitIsLeftOut)
{
  Random random = randomOfTest();
  const CyclicCode &code = codeOf(vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23));
  const Squares squares = trackOf(random, code.getRepresentatives()[7], 23, 0.5, 0.3);
  const auto all = bestTwoWords(squares, code);
  const auto both = bestTwoWords(squares, code, 1.01 * all[1].squares);
  EXPECT_EQ(both[0].word, all[0].word);
  EXPECT_EQ(both[1].word, all[1].word);
  const auto one = bestTwoWords(squares, code, 0.5 * (all[0].squares + all[1].squares));
  EXPECT_EQ(one[0].word, all[0].word);
  EXPECT_EQ(one[1].squares, HUGE_VAL);
  EXPECT_EQ(bestTwoWords(squares, code, 0.5 * all[0].squares)[0].squares, HUGE_VAL);
}
