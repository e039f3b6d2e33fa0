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
 * What a user writes for vpDetectorAprilTag, compiled and run for both detectors.
 */

#include <cstdlib>
#include <map>

#include <visp3/core/vpMeterPixelConversion.h>
#include <visp3/core/vpPoint.h>
#include <visp3/detection/vpDetectorAprilTag.h>

#include <Eigen/Geometry>

#include "detector_scenes.h"

using namespace detector_test;

namespace {
/*! What differs: how each detector's marker is printed, and how well it is found. */
template <class Detector> struct Kind;

template <> struct Kind<vpDetectorCircleMarker>
{
  static vpSimulatedMarker print(int id) { return vpSimulatedMarker::circle("golay23", id, size); }
  static constexpr const char *family = "golay23";
  static constexpr double pixelShift = 0.;
  static constexpr double closeness = 1e-6; // pixels; the outline is that of the pose
};

#if defined(VISP_HAVE_APRILTAG)
template <> struct Kind<vpDetectorAprilTag>
{
  static vpSimulatedMarker print(int id) { return vpSimulatedMarker::aprilTag36h11(id, size); }
  static constexpr const char *family = "36h11";
  static constexpr double pixelShift = 0.5; // AprilTag's own origin is the pixel's corner
  static constexpr double closeness = 1.5;  // pixels; the corners are measured, and the pose is another measurement
};
using Detectors = ::testing::Types<vpDetectorCircleMarker, vpDetectorAprilTag>;
#else
using Detectors = ::testing::Types<vpDetectorCircleMarker>;
#endif

// The simulator knows the first ten tags. Bounds of both detectors, for a marker of 150 pixels.
constexpr double largestDistance = 0.01; // of the depth
constexpr double largestAngle = 0.05;    // rad

template <class Detector> class DetectorSwap : public ::testing::Test
{
protected:
  //! A frontal half of all poses: both detectors see it without doubt.
  vpHomogeneousMatrix seenPose(Random &random) const { return randomPose(random, 150., uniform(random, 0.3, 0.7)); }

  vpCameraParameters camera() const
  {
    const double shift = Kind<Detector>::pixelShift;
    return vpCameraParameters(focal, focal, 319.5 + shift, 239.5 + shift);
  }

  vpImage<unsigned char> picture(const vpHomogeneousMatrix &aligned, int id, Random &random) const
  {
    vpSimulatedMarker marker = Kind<Detector>::print(id);
    marker.setPose(aligned);
    return imageOf(marker, random);
  }
};

TYPED_TEST_SUITE(DetectorSwap, Detectors);

// Half a turn about x: from the frame whose z axis points into the marker to that whose z axis points to the camera.
vpHomogeneousMatrix towardCamera(const vpHomogeneousMatrix &aligned)
{
  return poseOf(rotationOf(aligned) * Eigen::Vector3d(1., -1., -1.).asDiagonal(), translationOf(aligned));
}

void expectPose(const vpHomogeneousMatrix &found, const vpHomogeneousMatrix &truth)
{
  EXPECT_LT((translationOf(found) - translationOf(truth)).norm(), largestDistance * translationOf(truth).z());
  const Eigen::Matrix3d difference = rotationOf(found) * rotationOf(truth).transpose();
  EXPECT_LT(Eigen::AngleAxisd(difference).angle(), largestAngle);
}
} // namespace

TYPED_TEST(DetectorSwap, PosesAreInTheSameFrames)
{
  Random random = randomOfTest();
  for (int round = 0; round < 4; ++round) {
    const int id = static_cast<int>(random() % 10);
    const vpHomogeneousMatrix truth = this->seenPose(random);
    vpImage<unsigned char> I = this->picture(truth, id, random);
    for (const bool aligned : {false, true}) {
      TypeParam detector;
      detector.setZAlignedWithCameraAxis(aligned);
      std::vector<vpHomogeneousMatrix> cMo, cMo2;
      std::vector<double> errors, errors2;
      ASSERT_TRUE(detector.detect(I, size, this->camera(), cMo, &cMo2, &errors, &errors2));
      ASSERT_EQ(cMo.size(), 1u);
      ASSERT_EQ(cMo2.size(), 1u);
      ASSERT_EQ(errors.size(), 1u);
      ASSERT_EQ(errors2.size(), 1u);
      expectPose(cMo[0], aligned ? truth : towardCamera(truth));
    }
  }
}

TYPED_TEST(DetectorSwap, IdsAreReadFromTheMessage)
{
  Random random = randomOfTest();
  const int id = static_cast<int>(random() % 10);
  vpImage<unsigned char> I = this->picture(this->seenPose(random), id, random);
  TypeParam detector;
  ASSERT_TRUE(detector.detect(I));
  ASSERT_EQ(detector.getNbObjects(), 1u);
  EXPECT_EQ(detector.getMessage(0), std::string(Kind<TypeParam>::family) + " id: " + std::to_string(id));
  ASSERT_EQ(detector.getTagsId().size(), 1u);
  EXPECT_EQ(detector.getTagsId()[0], id);
  const std::string message = detector.getMessage(0);
  EXPECT_EQ(atoi(message.substr(message.find("id: ") + 4).c_str()), id);
}

TYPED_TEST(DetectorSwap, PoseAfterwardsWithAnotherSize)
{
  Random random = randomOfTest();
  const vpHomogeneousMatrix truth = this->seenPose(random);
  vpImage<unsigned char> I = this->picture(truth, 3, random);
  TypeParam detector;
  ASSERT_TRUE(detector.detect(I));
  vpHomogeneousMatrix cMo, cMo2;
  double error = -1., error2 = -1.;
  ASSERT_TRUE(detector.getPose(0, 2. * size, this->camera(), cMo, &cMo2, &error, &error2));
  vpHomogeneousMatrix twice = towardCamera(truth);
  for (unsigned int row = 0; row < 3; ++row) {
    twice[row][3] *= 2.;
  }
  expectPose(cMo, twice);
}

TYPED_TEST(DetectorSwap, CornersBelongToThePointsOfTheMarker)
{
  Random random = randomOfTest();
  const int id = 7;
  vpImage<unsigned char> I = this->picture(this->seenPose(random), id, random);
  for (const bool aligned : {false, true}) {
    TypeParam detector;
    detector.setZAlignedWithCameraAxis(aligned);
    std::vector<vpHomogeneousMatrix> cMo;
    ASSERT_TRUE(detector.detect(I, size, this->camera(), cMo));
    const std::map<int, double> named = {{-1, 5. * size}, {id, size}};
    const std::map<int, double> all = {{-1, size}};
    for (const std::map<int, double> &sizes : {named, all}) {
      const auto corners = detector.getTagsCorners();
      const auto points = detector.getTagsPoints3D(detector.getTagsId(), sizes);
      ASSERT_EQ(corners.size(), 1u);
      ASSERT_EQ(points.size(), 1u);
      ASSERT_EQ(points[0].size(), corners[0].size());
      ASSERT_GE(points[0].size(), 4u);
      for (std::size_t i = 0; i < points[0].size(); ++i) {
        vpPoint point = points[0][i];
        point.project(cMo[0]);
        vpImagePoint seen;
        vpMeterPixelConversion::convertPoint(this->camera(), point.get_x(), point.get_y(), seen);
        EXPECT_LT(vpImagePoint::distance(seen, corners[0][i]), Kind<TypeParam>::closeness) << "point " << i;
      }
    }
    EXPECT_THROW(detector.getTagsPoints3D(detector.getTagsId(), {{id + 1, size}}), vpException);
  }
}

TYPED_TEST(DetectorSwap, NothingInAWhiteImage)
{
  vpImage<unsigned char> I(height, width, 255);
  TypeParam detector;
  std::vector<vpHomogeneousMatrix> cMo;
  EXPECT_FALSE(detector.detect(I, size, this->camera(), cMo));
  EXPECT_TRUE(cMo.empty());
  EXPECT_EQ(detector.getNbObjects(), 0u);
}

TYPED_TEST(DetectorSwap, CopiesAndBaseClass)
{
  Random random = randomOfTest();
  vpImage<unsigned char> I = this->picture(this->seenPose(random), 8, random);
  TypeParam first;
  TypeParam second(first);
  TypeParam third;
  third = second;
  vpDetectorBase &base = third;
  ASSERT_TRUE(base.detect(I));
  EXPECT_EQ(base.getMessage().size(), base.getNbObjects());
  EXPECT_EQ(base.getPolygon().size(), base.getNbObjects());
  const vpImagePoint cog = base.getCog(0);
  EXPECT_TRUE(base.getBBox(0).isInside(cog));
}

// The members that later ViSP gave its AprilTag detector: here they are looked at by the compiler.
#if (VISP_VERSION_INT >= VP_VERSION_INT(3, 7, 0))
TYPED_TEST(DetectorSwap, MembersOfLaterVersions)
{
  Random random = randomOfTest();
  vpImage<unsigned char> I = this->picture(this->seenPose(random), 2, random);
  TypeParam detector;
  EXPECT_FALSE(detector.isZAlignedWithCameraAxis());
  ASSERT_TRUE(detector.detect(I));
  EXPECT_EQ(detector.getTagsHammingDistance(), std::vector<int>{0});
  EXPECT_EQ(detector.getTagsDecisionMargin().size(), 1u);
  EXPECT_THROW(detector.loadConfigFile("no-such-file.json"), vpException);
  using Corners = std::vector<std::vector<vpImagePoint>>;
  using Poses = std::vector<vpHomogeneousMatrix>;
  void (TypeParam::*tags)(const vpImage<unsigned char> &, const Corners &, const vpColor &, unsigned int) const =
      &TypeParam::displayTags;
  void (TypeParam::*frames)(const vpImage<vpRGBa> &, const Poses &, const vpCameraParameters &, double, const vpColor &,
                            unsigned int) const = &TypeParam::displayFrames;
  EXPECT_TRUE(tags != nullptr && frames != nullptr);
}
#endif
