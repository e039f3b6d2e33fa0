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
 * Test of the measurement of markers in light that looks uneven.
 */

#include "testScriptedMeasure.h"

using namespace scripted_test;

namespace {
// Paper that is brighter to the right, with as much black as white everywhere.
std::vector<ExplainedPixel> inSlantedLight()
{
  std::vector<ExplainedPixel> pixels;
  for (int i = 0; i < 400; ++i) {
    ExplainedPixel pixel;
    pixel.offset = Eigen::Vector2f(static_cast<float>(i / 20) / 10 - 1.f, static_cast<float>(i % 20) / 10 - 1.f);
    pixel.darkness = static_cast<float>(i % 2);
    pixel.grey = 170.f - 120.f * pixel.darkness + 30.f * pixel.offset.x();
    pixel.weight = 1.f;
    pixels.push_back(pixel);
  }
  return pixels;
}

// The measurement of a marker of which the first two fits, to few pixels, leave much, and all others to few pixels
// little: as if the light that was found between them explained it. Those to all pixels leave so much in that light,
// and so much in even light, grey levels.
Measurement measurementOf(const vpCircleMarkerFamily &family, double inLight, double inEvenLight, double diameter = 80.)
{
  const MarkerScene scene = tilted(family, 0.5, diameter);
  int few = 0;
  int begun = 0; // measurements
  bool isFine = true;
  const auto alter = [&](FittedPose &fit, const ScriptedFitter::Asked &asked) {
    begun += isFine && !asked.settings.exactBends ? 1 : 0;
    isFine = asked.settings.exactBends;
    fit.photometry = Photometry();
    fit.noise = begun == 1 ? inLight : inEvenLight;
    if (!isFine) {
      const bool isFirst = ++few <= 2;
      fit.noise = isFirst ? 10. : 1.;
      fit.correlation = isFirst ? 0.92 : 0.98; // with more they would be asked for a shadow first
    }
  };
  const Recognition marker = recognised(scene, family.isCoded() ? 8 : -1, false);
  return outcomeOf(scene, marker, true, alter, Deadline(), inSlantedLight()).measurement.value();
}
} // namespace

TEST(MeasureLight, LightThatExplainsTheImageIsTakenOutOfIt)
{
  for (const vpCircleMarkerFamily &family : {coded, ring}) {
    EXPECT_TRUE(measurementOf(family, 2., 3.).uneven.has_value()) << family.getName();
  }
}

// What few pixels leave by chance is explained by light, too, and the pose follows it.
TEST(MeasureLight, PlainRingsAreInEvenLightIfThatExplainsThemAsWell)
{
  const Measurement ofRing = measurementOf(ring, 3., 2.);
  EXPECT_FALSE(ofRing.uneven.has_value());
  EXPECT_EQ(ofRing.first.noise, 2.);
}

// Large ones keep the light: what covers them is a reason for it as well, and without it they are read as others.
TEST(MeasureLight, SmallCodesAreInEvenLightIfThatExplainsThemAsWell)
{
  EXPECT_FALSE(measurementOf(coded, 3., 2., 38.).uneven.has_value());
  EXPECT_TRUE(measurementOf(coded, 3., 2., 42.).uneven.has_value());
}
