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
 * The interface of vpDetectorCircleMarker: which families are read, and how strictly.
 */

#include "detector_scenes.h"

using namespace detector_test;

TEST(DetectorInterface, TwoFamiliesInOneImage)
{
  Random random = randomOfTest();
  const vpImage<unsigned char> I =
      imageOf(straightCamera(),
              {printed(vpCircleMarkerFamily::BCH31, 1234).setPose(randomPose(random, 120., 0.4, 170., 240.)),
               printed(vpCircleMarkerFamily::GOLAY23, 3).setPose(randomPose(random, 90., 0.4, 460., 240.))},
              random);
  vpDetectorCircleMarker detector(vpCircleMarkerFamily::GOLAY23);
  ASSERT_TRUE(detector.detect(I));
  ASSERT_EQ(detector.getNbObjects(), 1u);
  EXPECT_EQ(detector.getMessage(0), "golay23 id: 3");
  detector.setFamilies({vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31});
  ASSERT_TRUE(detector.detect(I));
  ASSERT_EQ(detector.getNbObjects(), 2u);
  EXPECT_EQ(detector.getMessage(0), "bch31 id: 1234");
  EXPECT_EQ(detector.getMessage(1), "golay23 id: 3");
  detector.setFamily(vpCircleMarkerFamily::BCH31);
  ASSERT_TRUE(detector.detect(I));
  EXPECT_EQ(detector.getTagsId(), std::vector<int>({1234}));
}

TEST(DetectorInterface, MarginCanBeDemanded)
{
  TwoMarkers scene;
  vpDetectorCircleMarker detector;
  detector.setMinimumMargin(1.);
  EXPECT_FALSE(detector.detect(scene.I));
  detector.setMinimumMargin(0.);
  detector.setMaximumHammingDistance(0);
  ASSERT_TRUE(detector.detect(scene.I));
  EXPECT_EQ(detector.getNbObjects(), 2u);
}

TEST(DetectorInterface, CorrectionCanBeForbidden)
{
  // Markers whose print has one wrong sector, or two.
  constexpr int count = 20;
  const vpCircleMarkerFamily golay(vpCircleMarkerFamily::GOLAY23);
  const vpCircleMarkerLayout &layout = golay.getLayout();
  Random random = randomOfTest();
  for (const unsigned int wrong : {1u, 2u}) {
    int corrected = 0;
    int forbidden = 0;
    for (int i = 0; i < count; ++i) {
      const int id = randomId(random, golay);
      std::uint32_t word = vpSimulatedMarker::codewords("golay23")[static_cast<std::size_t>(id)];
      const unsigned int first = static_cast<unsigned int>(random() % 23);
      word ^= 1U << first;
      word ^= wrong == 2 ? 1U << ((first + 1 + random() % 22) % 23) : 0U;
      vpSimulatedMarker marker = vpSimulatedMarker::rings({{layout.ringInner, 1.}}, size);
      marker.setTrack(layout.codeInner, layout.codeOuter, 23, word);
      marker.setPose(randomPose(random, 90., uniform(random, 0.1, 0.8)));
      const vpImage<unsigned char> I = imageOf(straightCamera(), {marker}, random);
      vpDetectorCircleMarker detector;
      if (detector.detect(I)) {
        EXPECT_EQ(detector.getTagsId(), std::vector<int>({id}));
        corrected += detector.getHammingDistance(0) == wrong ? 1 : 0;
      }
      detector.setMaximumHammingDistance(wrong - 1);
      forbidden += detector.detect(I) ? 1 : 0;
    }
    EXPECT_GE(corrected, count - 2) << wrong;
    EXPECT_LE(forbidden, count / 2) << wrong << ": a wrong sector can pass for one that something covers";
  }
}

// Sectors of a pixel or two cannot be read for certain one by one: all together they prove a code, which is as much as
// the usual settings ask for, but not who asks for more.
TEST(DetectorInterface, DoubtfulReadingsAreNoneForWhoAsksForMore)
{
  constexpr int images = 30;
  constexpr double usualMargin = 0.6; // what is asked for unless said otherwise
  constexpr double demanded = 0.9;
  Random random = randomOfTest();
  std::size_t usual = 0;
  std::size_t uncorrected = 0;
  std::size_t clear = 0;
  for (int i = 0; i < images; ++i) {
    const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
    vpMarkerSceneSimulator simulator(straightCamera(), width, height);
    simulator.setBackground(vpSceneBackground::plain(220.));
    vpSimulatedMarker marker = printed(family, randomId(random, family));
    simulator.addMarker(marker.setPose(randomPose(random, uniform(random, 9., 13.), uniform(random, 0., 0.6))));
    vpImage<unsigned char> I;
    simulator.render(I, random());
    vpDetectorCircleMarker detector;
    detector.detect(I);
    usual += detector.getNbObjects();
    vpDetectorCircleMarker withoutCorrection;
    withoutCorrection.setMaximumHammingDistance(0);
    withoutCorrection.detect(I);
    uncorrected += withoutCorrection.getNbObjects();
    for (const vpCircleMarkerDetection &detection : withoutCorrection.getDetections()) {
      EXPECT_GE(detection.margin, usualMargin) << i;
    }
    vpDetectorCircleMarker withMargin;
    withMargin.setMinimumMargin(demanded);
    withMargin.detect(I);
    clear += withMargin.getNbObjects();
    for (const vpCircleMarkerDetection &detection : withMargin.getDetections()) {
      EXPECT_GE(detection.margin, demanded) << i;
    }
  }
  EXPECT_LT(uncorrected, usual);
  EXPECT_LT(clear, usual);
}

// Half of the sectors of another family's marker agree with some codeword, and the others are not what covers it.
// Before that was asked, 22 of these were read.
TEST(DetectorInterface, MarkersOfAnotherFamilyAreNotRead)
{
  constexpr int frames = 30;
  constexpr unsigned int most = 2;
  using Family = vpCircleMarkerFamily;
  Random random = randomOfTest();
  unsigned int wrong = 0;
  for (const auto &[shown, sought] : {std::pair{Family::GOLAY23, Family::BCH31R},
                                      {Family::GOLAY23, Family::BCH31},
                                      {Family::BCH31, Family::GOLAY23},
                                      {Family::BCH31R, Family::GOLAY23}}) {
    vpDetectorCircleMarker detector(sought);
    for (int frame = 0; frame < frames; ++frame) {
      vpMarkerSceneSimulator simulator(straightCamera(), width, height);
      std::vector<vpSimulatedMarker> markers;
      for (const double u : {170., 460.}) {
        const vpHomogeneousMatrix cMo =
            randomPose(random, uniform(random, 40., 160.), uniform(random, 0., 0.8), u, 240.);
        markers.push_back(printed(shown, randomId(random, shown)).setPose(cMo));
        simulator.addMarker(markers.back());
      }
      vpImage<unsigned char> I;
      simulator.render(I, random());
      detector.detect(I);
      wrong += static_cast<unsigned int>(detector.getNbObjects());
    }
  }
  EXPECT_LE(wrong, most) << "of " << 8 * frames;
}
