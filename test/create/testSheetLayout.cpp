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
 * Tests of the layout of pages, without drawing them.
 */

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <variant>

#include <gtest/gtest.h>

#include "command_line.h"
#include "page.h"

using namespace create;

namespace {
/*! A generator of random numbers that depends on the running test's name and nothing else. */
std::mt19937 randomOfTest()
{
  const std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name();
  std::seed_seq seed(name.begin(), name.end());
  return std::mt19937(seed);
}

/*! Whether a rectangle given by its smallest and largest coordinates has area in common with a square. */
bool overlaps(double left, double top, double right, double bottom, const Square &square)
{
  constexpr double touching = 1e-6;
  return left < square.left + square.side - touching && right > square.left + touching &&
         top < square.top + square.side - touching && bottom > square.top + touching;
}

/*! Whether a line or a text enters a square; the letters' width and descent are taken generously. */
bool enters(const Shape &shape, const Square &square)
{
  if (const Line *line = std::get_if<Line>(&shape)) {
    const bool horizontal = line->y1 == line->y2;
    const double halfX = horizontal ? 0 : line->thickness / 2;
    const double halfY = horizontal ? line->thickness / 2 : 0;
    return overlaps(std::min(line->x1, line->x2) - halfX, std::min(line->y1, line->y2) - halfY,
                    std::max(line->x1, line->x2) + halfX, std::max(line->y1, line->y2) + halfY, square);
  }
  if (const Text *text = std::get_if<Text>(&shape)) {
    const double halfWidth = 0.35 * text->height * static_cast<double>(text->text.size());
    return overlaps(text->x - halfWidth, text->y - text->height, text->x + halfWidth, text->y + 0.3 * text->height,
                    square);
  }
  return false;
}

const std::string sheetNames[] = {"a4", "a3", "letter"};
} // namespace

TEST(SheetLayout, SheetsHaveTheirStandardSizes)
{
  EXPECT_EQ(210, sheetOfName("a4")->width);
  EXPECT_EQ(297, sheetOfName("a4")->height);
  EXPECT_EQ(297, sheetOfName("a3")->width);
  EXPECT_EQ(420, sheetOfName("a3")->height);
  EXPECT_DOUBLE_EQ(8.5 * 25.4, sheetOfName("letter")->width);
  EXPECT_DOUBLE_EQ(11 * 25.4, sheetOfName("letter")->height);
  EXPECT_FALSE(sheetOfName("A4"));
  EXPECT_FALSE(sheetOfName("none"));
}

TEST(SheetLayout, DefaultMarkerIsAsWideAsA4)
{
  const vpCircleMarkerFamily family;
  EXPECT_NEAR(210, squareSide(family, 180), 1e-9);
  EXPECT_EQ(1u, capacity(*sheetOfName("a4"), squareSide(family, 180)));
  EXPECT_EQ(0u, capacity(*sheetOfName("a4"), squareSide(family, 180.001)));
  EXPECT_NEAR(180, diameterInSquare(family, largestSquare(*sheetOfName("a4"))), 1e-9);
}

// Whatever the size and the number: squares stay on the paper, above the foot, apart from each other, and no line and
// no text enters one.
TEST(SheetLayout, NothingEntersAQuietZone)
{
  std::mt19937 random = randomOfTest();
  const vpCircleMarkerFamily family;
  for (int trial = 0; trial < 300; ++trial) {
    const Sheet sheet = *sheetOfName(sheetNames[trial % 3]);
    const double largest = diameterInSquare(family, largestSquare(sheet));
    // Logarithmic, so that sheets with one marker and with hundreds are equally likely; the largest itself as well.
    const double diameter =
        trial < 3 ? largest
        : std::uniform_real_distribution<double>(0, 1)(random) < 0.3
            ? std::uniform_real_distribution<double>(0.5 * largest, largest)(random)
            : std::exp(std::uniform_real_distribution<double>(std::log(8), std::log(largest))(random));
    const double side = squareSide(family, diameter);
    const unsigned int most = std::min(capacity(sheet, side), family.getNbIds());
    ASSERT_GE(most, 1u) << sheet.name << " " << diameter;
    std::vector<int> ids(std::uniform_int_distribution<unsigned int>(1, most)(random));
    for (std::size_t i = 0; i < ids.size(); ++i) {
      ids[i] = static_cast<int>(i);
    }
    const Page page = sheetPage(family, ids, diameter, false, sheet);
    ASSERT_EQ(ids.size(), page.markers.size());

    std::vector<Square> squares;
    for (const PlacedMarker &marker : page.markers) {
      squares.push_back(Square{marker.x - side / 2, marker.y - side / 2, side});
    }
    for (std::size_t i = 0; i < squares.size(); ++i) {
      const Square &square = squares[i];
      ASSERT_GE(square.left, -1e-6);
      ASSERT_LE(square.left + side, sheet.width + 1e-6);
      ASSERT_GE(square.top, -1e-6);
      ASSERT_LE(square.top + side + captionHeight, sheet.height - footHeight + 1e-6);
      for (std::size_t j = 0; j < i; ++j) {
        ASSERT_FALSE(overlaps(square.left, square.top, square.left + side, square.top + side, squares[j]));
      }
      for (const Shape &shape : page.picture.shapes) {
        ASSERT_FALSE(enters(shape, square)) << sheet.name << " ring " << diameter << " of " << ids.size();
      }
    }
  }
}

TEST(SheetLayout, MarkersStandInReadingOrder)
{
  const Sheet sheet = *sheetOfName("a4");
  const std::vector<Square> squares = placeSquares(sheet, 50, 7);
  ASSERT_EQ(7u, squares.size());
  for (std::size_t i = 1; i < squares.size(); ++i) {
    const bool sameRow = squares[i].top == squares[i - 1].top;
    EXPECT_TRUE(sameRow ? squares[i].left > squares[i - 1].left : squares[i].top > squares[i - 1].top);
  }
}

TEST(SheetLayout, AllLinesAreOnThePaper)
{
  const vpCircleMarkerFamily family;
  for (const std::string &name : sheetNames) {
    const Sheet sheet = *sheetOfName(name);
    for (const double diameter : {20., 80., diameterInSquare(family, largestSquare(sheet))}) {
      const Page page = sheetPage(family, {0}, diameter, false, sheet);
      int nbLines = 0;
      for (const Shape &shape : page.picture.shapes) {
        if (const Line *line = std::get_if<Line>(&shape)) {
          ++nbLines;
          for (const double x : {line->x1, line->x2}) {
            EXPECT_TRUE(x >= 0 && x <= sheet.width) << name << " " << diameter << " " << x;
          }
          for (const double y : {line->y1, line->y2}) {
            EXPECT_TRUE(y >= 0 && y <= sheet.height) << name << " " << diameter << " " << y;
          }
        }
      }
      // 12 lines of the scale bar, and a cut mark at each corner at least.
      EXPECT_GE(nbLines, 12 + 4);
    }
  }
}

// One shape for a run of black sectors, none across a white one; together they span the black sectors.
TEST(MarkerShapes, BlackSectorsAreJoined)
{
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::BCH31);
  const double fullTurn = 2 * std::acos(-1.);
  for (int id = 0; id < static_cast<int>(family.getNbIds()); id += 13) {
    const std::vector<Shape> shapes = markerShapes(family, id, 100, false, 0, 0);
    double sum = 0;
    for (std::size_t i = 1; i < shapes.size(); ++i) {
      sum += std::get<AnnularSector>(shapes[i]).sweep;
    }
    unsigned int nbBlack = 0, nbRuns = 0;
    for (unsigned int k = 0; k < 31; ++k) {
      nbBlack += family.isSectorBlack(id, k);
      nbRuns += family.isSectorBlack(id, k) && !family.isSectorBlack(id, (k + 30) % 31);
    }
    EXPECT_NEAR(fullTurn * nbBlack / 31, sum, 1e-9);
    EXPECT_EQ(nbRuns, shapes.size() - 1);
  }
}

// White on black: the square of marker and quiet zone without the marker's own shapes.
TEST(MarkerShapes, TheInverseIsTheSquareWithoutTheMarker)
{
  const vpCircleMarkerFamily family;
  const std::vector<Shape> marker = markerShapes(family, 5, 60, false, 50, 40);
  const std::vector<Shape> inverse = markerShapes(family, 5, 60, true, 50, 40);
  ASSERT_EQ(1u, inverse.size());
  const PiercedSquare &square = std::get<PiercedSquare>(inverse[0]);
  EXPECT_DOUBLE_EQ(70, square.side);
  EXPECT_DOUBLE_EQ(15, square.left);
  EXPECT_DOUBLE_EQ(5, square.top);
  EXPECT_EQ(marker.size(), square.holes.size());
}

TEST(Captions, SayFamilyIdAndSize)
{
  EXPECT_EQ("golay23  id 5  ring 180 mm", caption(vpCircleMarkerFamily(), 5, 180, false));
  EXPECT_EQ("golay23  inverse  id 5  ring 180 mm", caption(vpCircleMarkerFamily(), 5, 180, true));
  EXPECT_EQ("ring of ratio 0.7  52.5 mm", caption(vpCircleMarkerFamily::ring(0.7), noId, 52.5, false));
  EXPECT_EQ("disc  10 mm", caption(vpCircleMarkerFamily(vpCircleMarkerFamily::DISC), noId, 10, false));
  EXPECT_EQ("0.25", millimetres(0.25));
  EXPECT_EQ("100", millimetres(100));
}

TEST(IdLists, AreRead)
{
  EXPECT_EQ(std::vector<int>({5}), parseIds("5"));
  EXPECT_EQ(std::vector<int>({0, 1, 2, 3}), parseIds("0-3"));
  EXPECT_EQ(std::vector<int>({1, 4, 7}), parseIds("1,4,7"));
  EXPECT_EQ(std::vector<int>({8, 0, 1}), parseIds("8,0-1"));
}

TEST(IdLists, OtherTextsAreRefused)
{
  for (const std::string wrong : {"", ",", "1,", ",1", "a", "1-", "-1", "3-1", "1--2", "1 2", "1.5", "0x1", "1,1",
                                  "0-3,2", "99999999999999999999", "0-9999999999", "+1", "1;2"}) {
    EXPECT_THROW(parseIds(wrong), UsageError) << wrong;
  }
}

TEST(PageFiles, CarryTheIds)
{
  EXPECT_EQ("markers-5.png", pageFile("markers.png", 5, 5));
  EXPECT_EQ("a.b/markers-5-8.svg", pageFile("a.b/markers.svg", 5, 8));
}
