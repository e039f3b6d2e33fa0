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
 * How large must a circular marker be, and how far does it reach: the least errors of its pose.
 */

/*!
  \example circle-marker-bound/main.cpp
  How large must a circular marker be, and how far does it reach: the least errors of its pose that the noise of an
  image allows, for a camera, a size and a range of distances.
*/

#include <iostream>

#include "circle_marker/common/program.h"
#include "command_line.h"
#include "common/files.h"
#include "common/progress.h"
#include "report.h"

using namespace planner;

namespace {
int carryOut(const Settings &settings)
{
  if (!settings.output.empty()) {
    makeFolder(settings.output); // Before the seconds that the bounds take.
  }
  std::vector<Row> rows;
  std::vector<Reach> reaches;
  {
    ProgressLine line;
    rows = rowsOf(settings, [&line](std::size_t done, std::size_t all) { line.show(done, all); });
  }
  if (settings.wanted.any()) {
    reaches = reachesOf(settings, {});
  }
  std::cout << tableOf(settings, rows);
  if (settings.wanted.any()) {
    std::cout << '\n' << answerOf(settings, reaches);
  }
  std::cout << std::flush;
  if (!settings.output.empty()) {
    writeWhole(settings.output, "bound.csv", csvOf(rows));
    writeWhole(settings.output, "bound.json", jsonOf(settings, rows, reaches));
    writeWhole(settings.output, "bound.gp", plotScript(settings, rows));
    drawPlots(settings.output, "bound.gp", {"bound.svg"});
  }
  return 0;
}
} // namespace

int main(int argc, const char *argv[])
{
  return tutorial::Program("circle-marker-bound").run(parseCommandLine, argc, argv, carryOut);
}
