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
 * How near the detector's poses are to the information limit, on the simulated camera.
 */

/*!
  \example circle-marker-accuracy/main.cpp
  How near the detector's poses are to the information limit, on the simulated camera.
*/

#include <iostream>
#include <sstream>

#include "circle_marker/common/program.h"
#include "command_line.h"
#include "common/files.h"
#include "common/progress.h"
#include "parts.h"
#include "report.h"
#include "tables.h"

using namespace accuracy;

namespace {
std::vector<std::string> commentsOf(const Settings &settings)
{
  std::ostringstream parts;
  for (const std::string &part : settings.parts) {
    parts << ' ' << part;
  }
  return {"circle-marker-accuracy, ViSP " + vispVersion(),
          "frames " + std::to_string(settings.frames) + ", seed " + std::to_string(settings.seed) + ", parts" +
              parts.str(),
          std::string("bound: levels and blur unknown, surround ") +
              (settings.surround == vpMarkerPoseBound::WHITE_SURROUND ? "white" : "unknown")};
}

Records makeRecordsWithProgress(const Settings &settings)
{
  ProgressLine line;
  return makeRecords(settings, [&line](std::size_t done, std::size_t all) { line.show(done, all); });
}

int carryOut(const Settings &settings)
{
  if (!settings.page.empty()) {
    makeFolder(settings.page); // Before the minutes that the measurements take.
  }
  Records records;
  std::vector<std::string> comments;
  if (settings.from.empty()) {
    makeFolder(settings.output);
    records = makeRecordsWithProgress(settings);
    comments = commentsOf(settings);
    writeWhole(settings.output, "accuracy.csv", csvOf(comments, records));
  }
  else {
    records = readCsv(settings.from + "/accuracy.csv");
    comments = readComments(settings.from + "/accuracy.csv");
  }
  const std::vector<Check> checks = checksOf(records);
  std::vector<Table> tables = tablesOf(records);
  tables.push_back(missesOf(checks));
  for (const Table &table : tables) {
    std::cout << textOf(table) << '\n';
  }
  std::cout << std::flush;
  if (settings.from.empty()) {
    writeWhole(settings.output, "accuracy.json", jsonOf(comments, tables, checks));
  }
  if (!settings.page.empty()) {
    writePage(settings.page, comments, records, tables);
  }
  return 0;
}
} // namespace

int main(int argc, const char *argv[])
{
  return tutorial::Program("circle-marker-accuracy").run(parseCommandLine, argc, argv, carryOut);
}
