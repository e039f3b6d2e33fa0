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
 * What circle-marker-create draws, seen by the detector; and markers of inverse polarity.
 */

#include <cmath>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include <visp3/circle_marker/vpDetectorCircleMarker.h>
#include <visp3/core/vpCameraParameters.h>
#include <visp3/core/vpImage.h>
#include <visp3/core/vpImageConvert.h>
#include <visp3/io/vpImageIo.h>

#include "create_program.h"
#include "rendered_page.h"
#include "run_program.h"

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif
using nlohmann::json;
using test::create;
using test::emptyFolder;
using test::isMissing;
using test::linesOf;
using test::Outcome;
using test::renderPdf;

// A camera that looks straight at the page, upright, sees the markers where they stand, with the spin they have.
TEST(CircleMarkerCreate, PrintedMarkersAreDetected)
{
  if (isMissing(PDFTOPPM)) {
    GTEST_SKIP() << "poppler-utils is not installed";
  }
  const std::filesystem::path folder = emptyFolder();
  const std::vector<json> lines = linesOf(create(
      {"--family", "bch31r", "--ids", "10-13", "--size", "0.07", "--per-sheet", "auto", "--output", "markers.pdf"},
      folder));
  ASSERT_EQ(4u, lines.size()); // All on the first page.
  constexpr int dotsPerInch = 100;
  renderPdf(folder, "markers.pdf", 1, dotsPerInch);
  vpImage<unsigned char> I;
  vpImageIo::read(I, (folder / "page.pgm").string());
  // At this distance a pixel of the camera is a pixel of the page.
  constexpr double focal = 1600;
  constexpr double distance = focal * 0.0254 / dotsPerInch;
  vpCameraParameters cam;
  cam.initPersProjWithoutDistortion(focal, focal, (I.getWidth() - 1.) / 2., (I.getHeight() - 1.) / 2.);
  vpDetectorCircleMarker detector(vpCircleMarkerFamily::BCH31R);
  detector.setZAlignedWithCameraAxis(true);
  std::vector<vpHomogeneousMatrix> poses;
  ASSERT_TRUE(detector.detect(I, 0.07, cam, poses));
  ASSERT_EQ(lines.size(), poses.size());
  std::set<int> ids;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const vpCircleMarkerDetection &detection = detector.getDetections()[i];
    ASSERT_TRUE(detection.id >= 10 && detection.id <= 13) << detection.id;
    ids.insert(detection.id);
    EXPECT_EQ(0u, detection.hamming);
    const json &center = lines[static_cast<std::size_t>(detection.id - 10)].at("center_m");
    EXPECT_NEAR(center.at(0).get<double>() - I.getWidth() * 0.0254 / dotsPerInch / 2, poses[i][0][3], 5e-5);
    EXPECT_NEAR(center.at(1).get<double>() - I.getHeight() * 0.0254 / dotsPerInch / 2, poses[i][1][3], 5e-5);
    EXPECT_NEAR(distance, poses[i][2][3], 5e-4); // Poppler draws edges a fraction of a pixel fat.
    // The spin about the axis of the camera: the tilt of a frontal circle is hardly seen.
    EXPECT_NEAR(0, std::atan2(poses[i][1][0], poses[i][0][0]), 5e-3);
  }
  EXPECT_EQ(lines.size(), ids.size());
}

// A picture without noise or blur, as it was drawn: what edges are off by is nothing that covers the marker. The most
// edges have the codes whose sectors are black and white in turn.
TEST(CircleMarkerCreate, DrawnMarkersAreDetectedAsTheyAre)
{
  const std::filesystem::path folder = emptyFolder();
  vpDetectorCircleMarker detector(vpCircleMarkerFamily::BCH31);
  for (int id = 2107; id <= 2112; ++id) {
    for (const char *dotsPerInch : {"96", "150"}) {
      linesOf(create({"--family", "bch31", "--id", std::to_string(id), "--size", "0.05", "--sheet", "none", "--dpi",
                      dotsPerInch, "--output", "marker.png"},
                     folder));
      const cv::Mat drawn = cv::imread((folder / "marker.png").string(), cv::IMREAD_GRAYSCALE);
      constexpr int around = 20; // pixels of grey
      cv::Mat padded;
      cv::copyMakeBorder(drawn, padded, around, around, around, around, cv::BORDER_CONSTANT, cv::Scalar(128));
      vpImage<unsigned char> I;
      vpImageConvert::convert(padded, I);
      vpCameraParameters cam;
      cam.initPersProjWithoutDistortion(800., 800., (I.getWidth() - 1.) / 2., (I.getHeight() - 1.) / 2.);
      std::vector<vpHomogeneousMatrix> poses;
      detector.detect(I, 0.05, cam, poses);
      ASSERT_EQ(1u, detector.getNbObjects()) << id << ", " << dotsPerInch << " dots an inch";
      EXPECT_EQ(id, detector.getDetections()[0].id);
    }
  }
}

// White on black: the square of the same marker with black and white exchanged, on a page that is white.
TEST(CircleMarkerCreate, InverseMarkerIsTheNegativeOfTheMarker)
{
  const std::filesystem::path folder = emptyFolder();
  for (const char *family : {"golay23", "ring", "disc"}) {
    SCOPED_TRACE(family);
    const std::vector<std::string> common = {"--family", family,    "--id", "0",     "--size",
                                             "0.06",     "--sheet", "none", "--dpi", "300"};
    std::vector<std::string> usual = common;
    usual.insert(usual.end(), {"--output", "usual.png"});
    linesOf(create(usual, folder));
    const cv::Mat expected = 255 - cv::imread((folder / "usual.png").string(), cv::IMREAD_GRAYSCALE);
    const auto createInverse = [&](const std::string &output) {
      std::vector<std::string> arguments = common;
      arguments.insert(arguments.end(), {"--inverse", "--output", output});
      const std::vector<json> lines = linesOf(create(arguments, folder));
      ASSERT_EQ(1u, lines.size());
      EXPECT_TRUE(lines[0].at("inverse").get<bool>());
    };
    createInverse("inverse.png");
    const cv::Mat inverse = cv::imread((folder / "inverse.png").string(), cv::IMREAD_GRAYSCALE);
    ASSERT_EQ(expected.size(), inverse.size());
    // Cairo tells coverage by 15 lines a pixel: a corner may win or lose one, a shift or another radius would do more.
    EXPECT_LE(cv::norm(expected, inverse, cv::NORM_INF), 255 / 15);
    EXPECT_LT(cv::norm(expected, inverse, cv::NORM_L1) / static_cast<double>(expected.total()), 0.02);
    if (!isMissing(RSVG_CONVERT)) {
      createInverse("inverse.svg");
      const std::string pixels = std::to_string(expected.cols);
      const Outcome drawn = test::run(
          RSVG_CONVERT, {"--width", pixels, "--height", pixels, "--output", "drawn.png", "inverse.svg"}, folder);
      ASSERT_EQ(0, drawn.status) << drawn.err;
      const cv::Mat vectors = cv::imread((folder / "drawn.png").string(), cv::IMREAD_GRAYSCALE);
      ASSERT_EQ(expected.size(), vectors.size());
      EXPECT_LT(cv::norm(expected, vectors, cv::NORM_L1) / static_cast<double>(expected.total()), 1.);
    }
  }
}

TEST(CircleMarkerCreate, PrintedInverseMarkersAreDetected)
{
  if (isMissing(PDFTOPPM)) {
    GTEST_SKIP() << "poppler-utils is not installed";
  }
  const std::filesystem::path folder = emptyFolder();
  linesOf(create({"--ids", "10-13", "--size", "0.07", "--per-sheet", "auto", "--inverse", "--output", "markers.pdf"},
                 folder));
  renderPdf(folder, "markers.pdf", 1, 100);
  vpImage<unsigned char> I;
  vpImageIo::read(I, (folder / "page.pgm").string());
  vpDetectorCircleMarker detector(vpCircleMarkerFamily::GOLAY23);
  EXPECT_FALSE(detector.detect(I)) << "white on black is an option";
  detector.setPolarity(vpCircleMarkerPolarity::WHITE_ON_BLACK);
  ASSERT_TRUE(detector.detect(I));
  std::set<int> ids;
  for (const vpCircleMarkerDetection &detection : detector.getDetections()) {
    EXPECT_TRUE(detection.isInverse);
    ids.insert(detection.id);
  }
  EXPECT_EQ(std::set<int>({10, 11, 12, 13}), ids);
}
