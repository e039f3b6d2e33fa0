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
 * Tests of circle-marker-create: its files are rendered back and measured.
 */

#include <cmath>
#include <cstdint>
#include <regex>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include <visp3/circle_marker/vpCircleMarkerFamily.h>

#include "create_program.h"
#include "rendered_page.h"
#include "run_program.h"

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif
using nlohmann::json;
using test::contentOf;
using test::create;
using test::emptyFolder;
using test::filesIn;
using test::isMissing;
using test::linesOf;
using test::loadPage;
using test::Outcome;
using test::RenderedPage;
using test::renderPdf;
using test::renderSvg;

namespace {
// Lengths on the page are right to this, millimetres: what the printed sheets promise.
constexpr double lengthTolerance = 0.1;

/*! All that a page must hold at a marker: circles of the right size at the right place, its word, a clean margin. */
void expectMarker(const RenderedPage &page, const vpCircleMarkerFamily &family, int id, double diameter, double x,
                  double y)
{
  SCOPED_TRACE(family.getName() + " " + std::to_string(id));
  const double radius = diameter / 2;
  const RenderedPage::Circle outer = page.circleAround(x, y, 1.15 * radius, 0.9 * radius);
  EXPECT_NEAR(diameter, outer.diameter, lengthTolerance);
  EXPECT_NEAR(x, outer.x, lengthTolerance / 2);
  EXPECT_NEAR(y, outer.y, lengthTolerance / 2);
  EXPECT_LT(outer.roundness, lengthTolerance / 2);
  const double ratio = family.getLayout().ringInner;
  if (ratio > 0) {
    const RenderedPage::Circle inner = page.circleAround(x, y, (ratio - 0.05) * radius, 0.95 * radius);
    EXPECT_NEAR(ratio * diameter, inner.diameter, lengthTolerance);
    EXPECT_LT(std::hypot(inner.x - x, inner.y - y), lengthTolerance / 2);
  }
  EXPECT_EQ(255, page.darkestAround(x, y, diameter * 7 / 6, diameter)) << "the quiet zone is not clean";
  if (family.isCoded()) {
    bool clean = false;
    EXPECT_EQ(family.getCodeword(id), page.wordAround(x, y, diameter, family.getNbSectors(), clean));
    EXPECT_TRUE(clean);
    EXPECT_GT(page.at(x, y), 254);
  }
}

std::uint32_t bigEndianAt(const std::string &bytes, std::size_t position)
{
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    value = (value << 8) | static_cast<unsigned char>(bytes.at(position + i));
  }
  return value;
}
} // namespace

TEST(CircleMarkerCreate, PdfSheetsAreInTrueMillimetres)
{
  if (isMissing(PDFTOPPM) || isMissing(PDFINFO)) {
    GTEST_SKIP() << "poppler-utils is not installed";
  }
  struct Case
  {
    const char *family;
    int id;
    double size;
    const char *sheet;
    double width, height; // Points.
  };
  const Case cases[] = {{"golay23", 5, 0.18, "a4", 595.276, 841.890},
                        {"bch31", 2113, 0.25, "a3", 841.890, 1190.551},
                        {"bch31r", 65, 0.1, "letter", 612, 792},
                        {"ring", -1, 0.0725, "a4", 595.276, 841.890},
                        {"disc", -1, 0.05, "a4", 595.276, 841.890}};
  const std::filesystem::path folder = emptyFolder();
  for (const Case &c : cases) {
    SCOPED_TRACE(c.family);
    std::vector<std::string> arguments = {"--family", c.family, "--size",   std::to_string(c.size),
                                          "--sheet",  c.sheet,  "--output", "marker.pdf"};
    if (c.id >= 0) {
      arguments.insert(arguments.end(), {"--id", std::to_string(c.id)});
    }
    const std::vector<json> lines = linesOf(create(arguments, folder));
    ASSERT_EQ(1u, lines.size());
    EXPECT_EQ(c.family, lines[0].at("family"));
    EXPECT_EQ(c.id, lines[0].at("id"));
    EXPECT_NEAR(c.size, lines[0].at("size_m").get<double>(), 1e-9);
    EXPECT_NEAR(c.width / 72 * 0.0254, lines[0].at("picture_m").at(0).get<double>(), 1e-6);
    EXPECT_NEAR(c.height / 72 * 0.0254, lines[0].at("picture_m").at(1).get<double>(), 1e-6);

    const std::string info = test::run(PDFINFO, {"marker.pdf"}, folder).out;
    std::smatch found;
    ASSERT_TRUE(std::regex_search(info, found, std::regex("Page size: +([0-9.]+) x ([0-9.]+) pts"))) << info;
    EXPECT_NEAR(c.width, std::stod(found[1]), 0.01);
    EXPECT_NEAR(c.height, std::stod(found[2]), 0.01);

    const RenderedPage page = renderPdf(folder, "marker.pdf", 1, 300);
    expectMarker(page, vpCircleMarkerFamily::fromName(c.family), c.id, c.size * 1000,
                 1000 * lines[0].at("center_m").at(0).get<double>(),
                 1000 * lines[0].at("center_m").at(1).get<double>());
    // The scale bar, 10 mm above the foot of the paper; its labels stand off its ends.
    const double middle = c.width / 72 * 25.4 / 2;
    EXPECT_NEAR(100, page.darkLength(c.height / 72 * 25.4 - 10, middle - 52, middle + 52), 0.3);
  }
}

// The word of golay23 id 0, 2787, written out: nothing of the library's tables is used.
TEST(CircleMarkerCreate, SectorZeroStartsAtRightAndSectorsGoClockwise)
{
  const std::filesystem::path folder = emptyFolder();
  linesOf(create({"--id", "0", "--sheet", "none", "--dpi", "100", "--output", "marker.png"}, folder));
  const cv::Mat picture = cv::imread((folder / "marker.png").string(), cv::IMREAD_GRAYSCALE);
  const std::string sectors = "00000000000101011100011";
  const double center = (picture.cols - 1) / 2.;
  const double radius = 0.54 * picture.cols * 6 / 7 / 2;
  for (int k = 0; k < 23; ++k) {
    const double angle = 2 * std::acos(-1.) * (k + 0.5) / 23;
    const int column = static_cast<int>(std::lround(center + radius * std::cos(angle)));
    const int row = static_cast<int>(std::lround(center + radius * std::sin(angle))); // Rows go down.
    EXPECT_EQ(sectors[static_cast<std::size_t>(k)] == '1' ? 0 : 255,
              static_cast<int>(picture.at<unsigned char>(row, column)))
        << "sector " << k;
  }
}

TEST(CircleMarkerCreate, SquarePngIsCoveredByWholePixels)
{
  const std::filesystem::path folder = emptyFolder();
  for (const double size : {0.18, 0.2, 0.0333}) {
    for (const int dotsPerInch : {72, 150, 600}) {
      SCOPED_TRACE(std::to_string(size) + " m at " + std::to_string(dotsPerInch) + " dpi");
      const std::vector<json> lines =
          linesOf(create({"--family", "bch31r", "--id", "7", "--size", std::to_string(size), "--sheet", "none", "--dpi",
                          std::to_string(dotsPerInch), "--output", "marker.png"},
                         folder));
      ASSERT_EQ(1u, lines.size());
      const double side = size * 7 / 6;
      EXPECT_EQ(5u, lines[0].size());
      EXPECT_EQ("bch31r", lines[0].at("family"));
      EXPECT_EQ(7, lines[0].at("id"));
      EXPECT_NEAR(size, lines[0].at("size_m").get<double>(), 1e-12);
      EXPECT_NEAR(side, lines[0].at("picture_m").at(0).get<double>(), 1e-9);
      EXPECT_NEAR(side, lines[0].at("picture_m").at(1).get<double>(), 1e-9);
      const long pixels = std::lround(side / 0.0254 * dotsPerInch);
      EXPECT_EQ(pixels, lines[0].at("pixels").at(0).get<long>());
      EXPECT_EQ(pixels, lines[0].at("pixels").at(1).get<long>());

      const cv::Mat picture = cv::imread((folder / "marker.png").string(), cv::IMREAD_UNCHANGED);
      ASSERT_EQ(CV_8UC1, picture.type()) << "not a grey picture";
      ASSERT_EQ(pixels, picture.cols);
      ASSERT_EQ(pixels, picture.rows);
      const double density = static_cast<double>(pixels) / (side * 1000);
      // Ink: ring, 1 - 0.8^2, and black sectors, 0.68^2 - 0.4^2 each n-th. Antialiased by area, so to a part in 10^4.
      const vpCircleMarkerFamily family(vpCircleMarkerFamily::BCH31R);
      double blackSectors = 0;
      for (unsigned int k = 0; k < 31; ++k) {
        blackSectors += family.isSectorBlack(7, k) ? 1 : 0;
      }
      const double ink = (1 - 0.64 + (0.4624 - 0.16) * blackSectors / 31) * std::acos(-1.) * 9 / 49;
      const double mean = cv::mean(picture)[0];
      EXPECT_NEAR(ink, 1 - mean / 255, 2e-4);
      if (dotsPerInch > 72) {
        const RenderedPage page(picture, density);
        expectMarker(page, family, 7, size * 1000, side * 500, side * 500);
      }

      const std::string png = contentOf(folder / "marker.png");
      const std::size_t chunk = png.find("pHYs");
      ASSERT_NE(std::string::npos, chunk);
      EXPECT_NEAR(density * 1000, bigEndianAt(png, chunk + 4), 1);
      EXPECT_NEAR(density * 1000, bigEndianAt(png, chunk + 8), 1);
      EXPECT_EQ(1, png.at(chunk + 12)); // The metre.
    }
  }
}

TEST(CircleMarkerCreate, PngSheetHasExactlyTheDensity)
{
  const std::filesystem::path folder = emptyFolder();
  const std::vector<json> lines =
      linesOf(create({"--id", "11", "--size", "0.1", "--dpi", "300", "--output", "marker.png"}, folder));
  ASSERT_EQ(1u, lines.size());
  const RenderedPage page = loadPage(folder / "marker.png", 300 / 25.4);
  EXPECT_EQ(2480, page.getColumns()); // 210 mm and 297 mm to the nearest pixel.
  EXPECT_EQ(3508, page.getRows());
  EXPECT_NEAR(2480 * 0.0254 / 300, lines[0].at("picture_m").at(0).get<double>(), 1e-9);
  EXPECT_NEAR(3508 * 0.0254 / 300, lines[0].at("picture_m").at(1).get<double>(), 1e-9);
  expectMarker(page, vpCircleMarkerFamily(), 11, 100, 1000 * lines[0].at("center_m").at(0).get<double>(),
               1000 * lines[0].at("center_m").at(1).get<double>());
}

TEST(CircleMarkerCreate, SvgIsInTrueMillimetres)
{
  if (isMissing(RSVG_CONVERT)) {
    GTEST_SKIP() << "librsvg2-bin is not installed";
  }
  const std::filesystem::path folder = emptyFolder();
  const vpCircleMarkerFamily family(vpCircleMarkerFamily::BCH31);
  const std::vector<json> sheet =
      linesOf(create({"--family", "bch31", "--id", "99", "--size", "0.12", "--output", "sheet.svg"}, folder));
  EXPECT_NE(std::string::npos, contentOf(folder / "sheet.svg").find("width=\"210mm\" height=\"297mm\""));
  ASSERT_EQ(1u, sheet.size());
  expectMarker(renderSvg(folder, "sheet.svg", 210, 12), family, 99, 120,
               1000 * sheet[0].at("center_m").at(0).get<double>(), 1000 * sheet[0].at("center_m").at(1).get<double>());

  linesOf(create({"--family", "bch31", "--id", "99", "--size", "0.12", "--sheet", "none", "--output", "square.svg"},
                 folder));
  EXPECT_NE(std::string::npos, contentOf(folder / "square.svg").find("width=\"140mm\" height=\"140mm\""));
  expectMarker(renderSvg(folder, "square.svg", 140, 12), family, 99, 120, 70, 70);
}

TEST(CircleMarkerCreate, RingOfAnyRatio)
{
  const std::filesystem::path folder = emptyFolder();
  linesOf(create({"--family", "ring", "--ratio", "0.7", "--size", "0.1", "--sheet", "none", "--dpi", "300", "--output",
                  "ring.png"},
                 folder));
  const double density = std::lround(0.7 / 6 / 0.0254 * 300) / (700. / 6);
  const RenderedPage page = loadPage(folder / "ring.png", density);
  expectMarker(page, vpCircleMarkerFamily::ring(0.7), -1, 100, 350. / 6, 350. / 6);
}

TEST(CircleMarkerCreate, SeveralIdsArePagesOfOnePdf)
{
  if (isMissing(PDFTOPPM)) {
    GTEST_SKIP() << "poppler-utils is not installed";
  }
  const std::filesystem::path folder = emptyFolder();
  const std::vector<json> lines = linesOf(create({"--ids", "3,7-8", "--output", "markers.pdf"}, folder));
  ASSERT_EQ(3u, lines.size());
  EXPECT_EQ(std::vector<std::string>({"markers.pdf"}), filesIn(folder));
  const int ids[] = {3, 7, 8};
  for (int i = 0; i < 3; ++i) {
    const json &line = lines[static_cast<std::size_t>(i)];
    EXPECT_EQ(ids[i], line.at("id"));
    expectMarker(renderPdf(folder, "markers.pdf", i + 1, 150), vpCircleMarkerFamily(), ids[i], 180,
                 1000 * line.at("center_m").at(0).get<double>(), 1000 * line.at("center_m").at(1).get<double>());
  }
}

TEST(CircleMarkerCreate, SeveralMarkersOnASheet)
{
  if (isMissing(PDFTOPPM)) {
    GTEST_SKIP() << "poppler-utils is not installed";
  }
  const std::filesystem::path folder = emptyFolder();
  const std::vector<json> lines =
      linesOf(create({"--ids", "0-9", "--size", "0.04", "--per-sheet", "auto", "--output", "markers.pdf"}, folder));
  ASSERT_EQ(10u, lines.size());
  const RenderedPage page = renderPdf(folder, "markers.pdf", 1, 300);
  for (int id = 0; id < 10; ++id) {
    const json &center = lines[static_cast<std::size_t>(id)].at("center_m");
    expectMarker(page, vpCircleMarkerFamily(), id, 40, 1000 * center.at(0).get<double>(),
                 1000 * center.at(1).get<double>());
  }
}

TEST(CircleMarkerCreate, SeveralPagesAsPngOrSvgAreFilesWithTheIdInTheName)
{
  const std::filesystem::path folder = emptyFolder();
  linesOf(create({"--ids", "0-2", "--sheet", "none", "--dpi", "50", "--output", "m.png"}, folder));
  linesOf(create({"--ids", "0-4", "--size", "0.04", "--per-sheet", "2", "--output", "m.svg"}, folder));
  linesOf(create({"--ids", "5", "--output", "single.svg"}, folder));
  EXPECT_EQ(
      std::vector<std::string>({"m-0-1.svg", "m-0.png", "m-1.png", "m-2-3.svg", "m-2.png", "m-4.svg", "single.svg"}),
      filesIn(folder));
}

TEST(CircleMarkerCreate, HelpAndFamilies)
{
  const std::filesystem::path folder = emptyFolder();
  const Outcome help = create({"--help"}, folder);
  EXPECT_EQ(0, help.status);
  for (const std::string option : {"--family", "--id", "--ids", "--size", "--output", "--sheet", "--per-sheet", "--dpi",
                                   "--ratio", "--inverse", "--list-families"}) {
    EXPECT_NE(std::string::npos, help.out.find(option)) << option;
  }
  for (const std::string option : {"--list-families", "--list_families"}) {
    const Outcome families = create({option}, folder);
    EXPECT_EQ(0, families.status) << families.err;
    for (const vpCircleMarkerFamily &family : vpCircleMarkerFamily::all()) {
      EXPECT_NE(std::string::npos, families.out.find(family.getName()));
    }
    EXPECT_NE(std::string::npos, families.out.find("2114"));
  }
}

TEST(CircleMarkerCreate, OlderFileIsReplaced)
{
  const std::filesystem::path folder = emptyFolder();
  linesOf(create({"--id", "3", "--sheet", "none", "--output", "x.svg"}, folder));
  const std::string before = contentOf(folder / "x.svg");
  linesOf(create({"--id", "4", "--sheet", "none", "--output", "x.svg"}, folder));
  EXPECT_NE(before, contentOf(folder / "x.svg"));
  linesOf(create({"--id", "3", "--sheet", "none", "--output", "x.svg"}, folder));
  EXPECT_EQ(before, contentOf(folder / "x.svg"));
}
