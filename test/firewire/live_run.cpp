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
 * Running the live programs on a simulated bus.
 */

#include "live_run.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/core/vpThetaUVector.h>

#include <visp3/circle_marker/vpConfigCircleMarker.h>

#ifdef ENABLE_VISP_NAMESPACE
using namespace VISP_NAMESPACE_NAME;
#endif

namespace test {
std::vector<std::vector<double>> pathOfPoses(int count)
{
  std::vector<std::vector<double>> poses;
  for (int i = 0; i < count; ++i) {
    const double phase = 2. * M_PI * i / count;
    // 1.8 m away: a ring of 160 pixels, within 200 pixels of the image's centre; tilted by 25 to 45 degrees.
    const double tilt = (35. + 10. * std::sin(phase)) * M_PI / 180.;
    const vpHomogeneousMatrix cMo(
        vpTranslationVector(0.12 * std::cos(phase), 0.08 * std::sin(phase), 1.8 + 0.1 * std::sin(2. * phase)),
        vpRotationMatrix(vpThetaUVector(tilt * std::cos(phase), tilt * std::sin(phase), 0.)) *
            vpRotationMatrix(vpThetaUVector(0., 0., phase)));
    poses.emplace_back(cMo.data, cMo.data + 16);
  }
  return poses;
}

Json chameleonBus()
{
  return {{"cameras", {{{"guid", 0x00b09d01007e0ee7ULL}, {"vendor", "Point Grey Research"}, {"model", "Chameleon"}}}},
          {"poses", pathOfPoses(12)}};
}

Outcome runOnBus(const std::string &program, const std::vector<std::string> &arguments,
                 const std::filesystem::path &folder, const Json &bus, const std::vector<std::string> &before)
{
  std::vector<std::string> words = before;
  words.insert(words.end(), {"timeout", "--kill-after=5", "60", "env"});
  if (!bus.is_null()) {
    // Beside the folder, not in it: what is in it is the program's.
    const std::string scenario = folder.string() + ".bus.json";
    std::ofstream(scenario) << bus.dump();
    words.push_back(std::string("LD_PRELOAD=") + SIMULATED_LIBRARY);
    words.push_back("CIRCLE_MARKER_SIMULATED_BUS=" + scenario);
    // Where everything is built with sanitizers, what is preloaded comes before their own library.
    words.push_back("ASAN_OPTIONS=verify_asan_link_order=0:detect_leaks=0");
  }
  words.push_back(program);
  words.insert(words.end(), arguments.begin(), arguments.end());
  return run(words.front(), std::vector<std::string>(words.begin() + 1, words.end()), folder);
}

std::vector<std::string> liveArguments(const std::vector<std::string> &more)
{
  std::vector<std::string> arguments = {
      "--intrinsic", std::string(CIRCLE_MARKER_DATA_DIR) + "/camera.xml", "--camera-name", "Camera", "--size", "0.18"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

std::vector<Json> linesOf(const std::string &text)
{
  std::vector<Json> lines;
  std::istringstream in(text);
  std::string line;
  while (std::getline(in, line)) {
    lines.push_back(Json::parse(line));
  }
  return lines;
}

void writeLines(const std::filesystem::path &file, const Json &elements)
{
  std::ofstream out(file);
  for (const Json &element : elements) {
    out << element.dump() << '\n';
  }
}

long numberOf(const Json &line)
{
  const std::string name = line["image"];
  return std::stol(name.substr(name.find('#') + 1));
}

PoseDistance poseDistance(const Json &cMo, const std::vector<double> &truth)
{
  double square = 0., trace = 0.;
  for (std::size_t row = 0; row < 3; ++row) {
    const double difference = cMo[4 * row + 3].get<double>() - truth[4 * row + 3];
    square += difference * difference;
    for (std::size_t column = 0; column < 3; ++column) {
      trace += cMo[4 * row + column].get<double>() * truth[4 * row + column];
    }
  }
  return PoseDistance{std::sqrt(square), std::acos(std::min(1., 0.5 * (trace - 1.))) * 180. / M_PI};
}

void expectPoses(const std::vector<Json> &lines, const Json &bus)
{
  const auto &poses = bus["poses"];
  for (const Json &line : lines) {
    ASSERT_EQ(line["markers"].size(), 1U) << line["image"];
    EXPECT_EQ(line["markers"][0]["id"], 5);
    const auto truth = poses[static_cast<std::size_t>(numberOf(line)) % poses.size()].get<std::vector<double>>();
    const PoseDistance distance = poseDistance(line["markers"][0]["cMo"], truth);
    // The bounds of noise at 1.8 m and 25 to 45 degrees are 0.04 mm in depth and 0.006 degrees; five times that.
    EXPECT_LT(distance.metres, 2e-4) << line["image"];
    EXPECT_LT(distance.degrees, 0.03) << line["image"];
  }
}
} // namespace test
