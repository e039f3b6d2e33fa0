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
 * Compares circular markers with ViSP's AprilTag detector on the simulated camera.
 */

/*!
  \example circle-marker-compare-apriltag/main.cpp
  Compares circular markers with ViSP's AprilTag detector on the simulated camera: same footprint, same poses, same
  camera and noise.
*/

#include <iostream>

#include "circle_marker/common/program.h"
#include "command_line.h"
#include "common/files.h"
#include "common/progress.h"
#include "plots.h"
#include "report.h"
#include "summary.h"
#include "trial.h"

using namespace compare;

namespace {
std::vector<Trial> makeTrialsWithProgress(const Settings &settings)
{
  ProgressLine line;
  return makeTrials(settings, [&line](std::size_t done, std::size_t all) { line.show(done, all); });
}

int carryOut(const Settings &settings)
{
  makeFolder(settings.output); // Before the minutes that the trials take.
  const std::vector<Trial> trials = makeTrialsWithProgress(settings);
  const Summary summary = summaryOf(trials);
  writeWhole(settings.output, "compare.csv", csvOf(trials));
  writeWhole(settings.output, "compare.json", jsonOf(settings, summary));
  writeWhole(settings.output, "compare.gp", plotScript(settings, trials));
  std::cout << tableOf(settings, summary) << std::flush;
  drawPlots(settings.output, "compare.gp", plotFiles);
  return 0;
}
} // namespace

int main(int argc, const char *argv[])
{
  return tutorial::Program("circle-marker-compare-apriltag").run(parseCommandLine, argc, argv, carryOut);
}
