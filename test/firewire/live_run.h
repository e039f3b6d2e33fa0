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

#ifndef VP_TEST_LIVE_RUN_H
#define VP_TEST_LIVE_RUN_H

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "run_program.h"

namespace test {
using Json = nlohmann::json;

/*! Poses of a marker of 0.18 m that stay in a quarter of the image, as many as asked for; row by row. */
std::vector<std::vector<double>> pathOfPoses(int count);

/*! A bus with one camera of the thesis's kind, which sees a marker on a path of 12 poses. */
Json chameleonBus();

/*!
  Runs a program on a simulated bus, in a folder; ends it after a minute, with the status 124.
  \e bus: The scenario; null: no simulated bus.
*/
Outcome runOnBus(const std::string &program, const std::vector<std::string> &arguments,
                 const std::filesystem::path &folder, const Json &bus, const std::vector<std::string> &before = {});

/*! The usual arguments of the live detector. */
std::vector<std::string> liveArguments(const std::vector<std::string> &more);

/*! Lines of JSON. */
std::vector<Json> linesOf(const std::string &text);

/*! Writes the elements of an array as lines of JSON. */
void writeLines(const std::filesystem::path &file, const Json &elements);

/*! The number behind "#" in the name of an image. */
long numberOf(const Json &line);

/*! How far a pose is from the truth. */
struct PoseDistance
{
  double metres = 0.;
  double degrees = 0.;
};
PoseDistance poseDistance(const Json &cMo, const std::vector<double> &truth);

/*! Every line has the marker 5, and it is where the bus has it. */
void expectPoses(const std::vector<Json> &lines, const Json &bus);
} // namespace test

#endif
