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
 * Real photographs: every disc of the calibration grids, and no coded marker where there is none.
 */

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <visp3/circle_marker/vpDetectorCircleMarker.h>
#include <visp3/core/vpException.h>
#include <visp3/core/vpIoTools.h>
#include <visp3/io/vpImageIo.h>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace {
namespace fs = std::filesystem;

// Folder of ViSP's data set, Debian's package visp-images-data or VISP_INPUT_IMAGE_PATH; empty if it is not there.
std::string dataSet()
{
  return vpIoTools::getViSPImagesDataPath();
}

std::string joined(const std::string &folder, const std::string &file)
{
  return vpIoTools::createFilePath(folder, file);
}

// Nearest detection to a point: distance in pixels.
double distanceToNearest(const std::vector<vpCircleMarkerDetection> &detections, const vpImagePoint &point)
{
  double least = HUGE_VAL;
  for (const vpCircleMarkerDetection &detection : detections) {
    least = std::min(least, vpImagePoint::distance(detection.center, point));
  }
  return least;
}

// Centroid of the dark pixels around a point: where the disc is, measured without the detector.
vpImagePoint centroidOfDark(const vpImage<unsigned char> &I, const vpCircleMarkerDetection &detection)
{
  const double reach = detection.ellipse.a + 3.;
  const int left = static_cast<int>(detection.ellipse.center.get_u() - reach);
  const int right = static_cast<int>(detection.ellipse.center.get_u() + reach);
  const int top = static_cast<int>(detection.ellipse.center.get_v() - reach);
  const int bottom = static_cast<int>(detection.ellipse.center.get_v() + reach);
  int darkest = 255;
  int brightest = 0;
  for (int v = top; v <= bottom; ++v) {
    for (int u = left; u <= right; ++u) {
      const int grey = I[static_cast<unsigned int>(v)][static_cast<unsigned int>(u)];
      darkest = std::min(darkest, grey);
      brightest = std::max(brightest, grey);
    }
  }
  double sum = 0.;
  double sumU = 0.;
  double sumV = 0.;
  for (int v = top; v <= bottom; ++v) {
    for (int u = left; u <= right; ++u) {
      if (2 * I[static_cast<unsigned int>(v)][static_cast<unsigned int>(u)] < darkest + brightest) {
        sum += 1.;
        sumU += u;
        sumV += v;
      }
    }
  }
  return vpImagePoint(sumV / sum, sumU / sum);
}

class CalibrationGrid : public testing::TestWithParam<int>
{
};
} // namespace

// 6 x 6 black discs; each is found once, where a count of its dark pixels finds it too.
TEST_P(CalibrationGrid, AllDiscsAreFound)
{
  if (dataSet().empty()) {
    GTEST_SKIP() << "ViSP's data set is not installed";
  }
  vpImage<unsigned char> I;
  vpImageIo::read(I, joined(dataSet(), "calibration/grid36-0" + std::to_string(GetParam()) + ".pgm"));
  vpDetectorCircleMarker detector(vpCircleMarkerFamily::DISC);
  ASSERT_TRUE(detector.detect(I));
  const std::vector<vpCircleMarkerDetection> &discs = detector.getDetections();
  EXPECT_EQ(discs.size(), 36u);
  for (const vpCircleMarkerDetection &disc : discs) {
    EXPECT_GT(disc.visible, 0.9);
    EXPECT_LT(vpImagePoint::distance(disc.ellipse.center, centroidOfDark(I, disc)), 0.3);
    EXPECT_GT(disc.ellipse.a, 12.);
    std::vector<vpCircleMarkerDetection> others;
    std::copy_if(discs.begin(), discs.end(), std::back_inserter(others),
                 [&](const vpCircleMarkerDetection &other) { return &other != &disc; });
    EXPECT_GT(distanceToNearest(others, disc.center), disc.ellipse.a);
  }
}

INSTANTIATE_TEST_SUITE_P(Grid36, CalibrationGrid, testing::Values(1, 2, 3, 4));

namespace {
// Calls look(picture, file) for about a thousand pictures of rooms, objects, people and other systems' tags; their
// number.
template <class Look> unsigned int forEachPicture(const Look &look)
{
  const std::vector<std::string> kinds = {".pgm", ".ppm", ".png", ".jpg", ".jpeg"};
  unsigned int pictures = 0;
  for (const fs::directory_entry &entry : fs::recursive_directory_iterator(dataSet())) {
    if (std::find(kinds.begin(), kinds.end(), entry.path().extension().string()) == kinds.end()) {
      continue;
    }
    vpImage<unsigned char> I;
    try {
      vpImageIo::read(I, entry.path().string());
    }
    catch (const vpException &) {
      continue; // some of the data set's files are no pictures (endianness tests, depth maps)
    }
    ++pictures;
    look(I, entry.path());
  }
  return pictures;
}
} // namespace

TEST(Photographs, HoldNoCodedMarker)
{
  if (dataSet().empty()) {
    GTEST_SKIP() << "ViSP's data set is not installed";
  }
  vpDetectorCircleMarker detector;
  detector.setFamilies({vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31R, vpCircleMarkerFamily::BCH31});
  const unsigned int pictures = forEachPicture([&](const vpImage<unsigned char> &I, const fs::path &file) {
    EXPECT_FALSE(detector.detect(I)) << file << ": " << detector.getMessage(0);
  });
  EXPECT_GT(pictures, 900u);
}

// Letters and wheels are much like rings; of what is found some are (the figure 0 is an ellipse).
TEST(Photographs, HoldARingInAHundredAtMost)
{
  if (dataSet().empty()) {
    GTEST_SKIP() << "ViSP's data set is not installed";
  }
  vpDetectorCircleMarker detector(vpCircleMarkerFamily::RING);
  std::size_t rings = 0;
  const unsigned int pictures = forEachPicture([&](const vpImage<unsigned char> &I, const fs::path &) {
    detector.detect(I);
    rings += detector.getNbObjects();
  });
  EXPECT_GT(pictures, 900u);
  EXPECT_LE(rings, pictures / 100);
}
