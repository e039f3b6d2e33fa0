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
 * The experiments of the thesis this work began with, done again and finished.
 */

/*!
  \example circle-marker-experiments/main.cpp
  The experiments of the thesis this work began with, done again and finished: lines of poses, random poses, resilience,
  requirements.
*/

#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>

#include "circle_marker/common/program.h"
#include "command_line.h"
#include "common/files.h"
#include "common/progress.h"
#include "report.h"
#include "report_recording.h"
#include "run.h"

using namespace experiments;

namespace {
/*! What an experiment adds to the report. */
struct Reporter
{
  void (*addSection)(const Experiment &, const RunData &, Document &);
  std::vector<CaptionedFigure> (*figures)(const Experiment &, const RunData &);
};

const std::map<std::string, Reporter> reporters = {{"2", {addLines, figuresOfLines}},
                                                   {"3", {addCells, figuresOfCells}},
                                                   {"resilience", {addResilience, figuresOfResilience}},
                                                   {"requirements", {addRequirements, figuresOfRequirements}},
                                                   {"design", {addDesign, figuresOfDesign}}};

/*! What is in a file; nothing if there is no such file. */
std::optional<std::string> contentOf(const std::string &path)
{
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    return std::nullopt;
  }
  return std::string(std::istreambuf_iterator<char>(file), {});
}

/*! Data that is there, with the settings that made it. */
RunData readData(const std::string &name, Settings &settings)
{
  const std::string file = dataFileOf(experimentNamed(name, settings));
  const auto csv = contentOf(settings.output + "/" + file);
  if (!csv) {
    throw DataError("there is no \"" + file + "\" in \"" + settings.output + "\"; leave --report-only out to make it");
  }
  settings = settingsFrom(*csv, file, settings);
  return dataFrom(*csv, file, experimentNamed(name, settings), settings);
}

/*! The data that is there, and the frames that are missing. */
RunData makeData(const Experiment &experiment, const Settings &settings)
{
  const std::string file = dataFileOf(experiment);
  const auto csv = contentOf(settings.output + "/" + file);
  RunData data = csv ? dataFrom(*csv, file, experiment, settings) : emptyData(experiment);
  ProgressLine line;
  completeRun(
      experiment, settings, [&line](std::size_t done, std::size_t all) { line.show(done, all); },
      [&](const RunData &soFar) { writeWhole(settings.output, file, csvOf(experiment, settings, soFar)); }, data);
  return data;
}

void append(const std::vector<CaptionedFigure> &more, std::vector<Figure> &figures)
{
  for (const CaptionedFigure &figure : more) {
    figures.push_back(figure.figure);
  }
}

/*! Experiment 1 has a recording in place of frames. */
void evaluateRecording(const Settings &settings, Document &document, std::vector<Figure> &figures)
{
  const Recording recording = recordingIn(settings.recording, settings.recordedId);
  writeWhole(settings.output, "experiment-1.csv", csvOf(recording));
  addRecording(recording, document);
  append(figuresOfRecording(recording), figures);
}

int carryOut(Settings settings)
{
  makeFolder(settings.output); // Before the minutes that the frames take.
  Document document("The experiments of the thesis, done again");
  std::vector<Figure> figures;
  bool areConditionsTold = false;
  const std::vector<std::string> names = settings.experiments; // Data that is read brings settings of its own.
  for (const std::string &name : names) {
    if (name == recordedExperiment) {
      evaluateRecording(settings, document, figures);
      continue;
    }
    const RunData data =
        settings.reportOnly ? readData(name, settings) : makeData(experimentNamed(name, settings), settings);
    const Experiment experiment = experimentNamed(name, settings);
    if (!areConditionsTold) {
      addConditions(settings, document);
      areConditionsTold = true;
    }
    writeWhole(settings.output, experiment.name + ".json", jsonOf(experiment, settings, data));
    reporters.at(name).addSection(experiment, data, document);
    append(reporters.at(name).figures(experiment, data), figures);
  }
  writeWhole(settings.output, "report.html", document.html());
  writeWhole(settings.output, "report.md", document.markdown());
  writeWhole(settings.output, "report.gp", figureScript(figures));
  std::cout << document.markdown() << std::flush;
  drawPlots(settings.output, "report.gp", filesOf(figures));
  return 0;
}
} // namespace

int main(int argc, const char *argv[])
{
  return tutorial::Program("circle-marker-experiments").run(parseCommandLine, argc, argv, carryOut);
}
