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
 * The lines of JSON of the detector's program, of what no picture is sure to give.
 */

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "circle_marker/common/detection/json_line.h"

using namespace tutorial;

namespace {
using Json = nlohmann::json;

Json lineOf(const vpCircleMarkerDetection &detection)
{
  ImageResult result;
  result.name = "image.png";
  result.detections = {detection};
  return Json::parse(jsonLine(result));
}
} // namespace

// JSON has no infinity, and who reads "log_odds" expects a number.
TEST(JsonLine, OfAMarkerWithOnePoseTheLogOddsAreANumber)
{
  vpCircleMarkerDetection detection;
  ASSERT_FALSE(detection.hasSecondPose);
  ASSERT_EQ(detection.logOdds, HUGE_VAL);
  const Json marker = lineOf(detection)["markers"][0];
  EXPECT_TRUE(marker["cMo2"].is_null());
  ASSERT_TRUE(marker["log_odds"].is_number());
  EXPECT_EQ(marker["log_odds"].get<double>(), std::numeric_limits<double>::max());
}

TEST(JsonLine, OfAMarkerWithTwoPosesBothAreTold)
{
  vpCircleMarkerDetection detection;
  detection.hasSecondPose = true;
  detection.logOdds = 12.5;
  const Json marker = lineOf(detection)["markers"][0];
  EXPECT_EQ(marker["cMo2"].size(), 16u);
  EXPECT_EQ(marker["log_odds"].get<double>(), 12.5);
}

TEST(JsonLine, ANameThatIsNotUnicodeIsNoEndOfTheProgram)
{
  ImageResult result;
  result.name = "image-\xff.png";
  EXPECT_NO_THROW(Json::parse(jsonLine(result)));
}
