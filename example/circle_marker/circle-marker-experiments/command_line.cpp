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
 * The command line of circle-marker-experiments.
 */

#include <algorithm>
#include <thread>
#include <vector>

#include "command_line.h"
#include "common/arguments.h"
#include "experiment.h"

namespace experiments {
namespace {
constexpr const char *allExperiments = "all";

void addOptions(CLI::App &app, Settings &settings)
{
  std::vector<std::string> names = experimentNames();
  names.insert(names.begin(), recordedExperiment);
  names.push_back(allExperiments);
  app.add_option("--output", settings.output, "Folder to write to; made unless it is there")->required();
  app.add_option("--experiment", settings.experiments, "Which; several may be named, one after another")
      ->required()
      ->check(CLI::IsMember(names));
  app.add_option("--frames", settings.frames, "Frames of each series; each experiment's own numbers unless given")
      ->check(CLI::Range(1u, 1000000u));
  app.add_option("--seed", settings.seed, "Seed of poses, ids and noise")
      ->check(common::wholeNumber())
      ->capture_default_str();
  app.add_option("--max-distance", settings.maximumDistance,
                 "Greatest depth, metres. Experiment 2: the far end of the lines (22); 3: of one cell instead of the "
                 "thesis's five; resilience: of the poses (8)")
      ->check(common::numberIn(1., 100.));
  app.add_option("--max-angle", settings.maximumAngle,
                 "Greatest angle between normal and line of sight, degrees. Experiment 3: of one cell instead of the "
                 "thesis's five; resilience: of the poses (60)")
      ->check(common::numberIn(0., 90.));
  app.add_option("--size", settings.size, "Outer diameter of the ring, metres; the sheet is 7/6 of it")
      ->check(common::numberIn(0.01, 1.))
      ->capture_default_str();
  app.add_option("--noise", settings.noise, "Standard deviation of the noise, grey levels")
      ->check(common::numberIn(0.1, 50.)) // without noise there is no bound to compare with
      ->capture_default_str();
  app.add_option("--blur", settings.blur, "Standard deviation of the blur, pixels")
      ->check(common::numberIn(0., 10.))
      ->capture_default_str();
  app.add_option("--threads", settings.threads, "Frames made at once; all cores unless given")
      ->check(CLI::Range(1u, 256u));
  app.add_option("--recording", settings.recording,
                 "Experiment 1: folder with a folder for each place of the marker, such as 1m, 2.5m, slide, each with "
                 "poses.jsonl as tutorial-circle-marker-detector-live --record writes it");
  app.add_option("--id", settings.recordedId, "Experiment 1: id of the marker; the one found most often unless given");
  app.add_flag("--report-only", settings.reportOnly, "Draw the report again from the data in the folder");
}

void checkTogether(Settings &settings)
{
  if (settings.output.empty()) {
    throw common::UsageError("--output is empty; name a folder");
  }
  auto &names = settings.experiments;
  if (std::find(names.begin(), names.end(), allExperiments) != names.end()) {
    names = experimentNames();
    if (!settings.recording.empty()) {
      names.insert(names.begin(), recordedExperiment);
    }
  }
  const auto asksFor = [&names](const char *name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  if (asksFor(recordedExperiment) && settings.recording.empty()) {
    throw common::UsageError("experiment 1 evaluates a recording: name its folder with --recording; "
                             "doc/experiments/experiment-1.md tells how to make it");
  }
  if (settings.maximumAngle && names == std::vector<std::string>{"2"}) {
    throw common::UsageError("the markers of experiment 2 face the camera: leave --max-angle out");
  }
  if ((settings.maximumAngle || settings.maximumDistance) && names == std::vector<std::string>{"requirements"}) {
    throw common::UsageError("the poses of the requirements are given: leave --max-angle and --max-distance out");
  }
  if (asksFor("resilience") && settings.maximumDistance && *settings.maximumDistance < 1.5) {
    throw common::UsageError("the poses of resilience begin at 1 m: make --max-distance 1.5 or more");
  }
}
} // namespace

Request parseCommandLine(int argc, const char *const argv[])
{
  Settings settings;
  settings.threads = std::max(1u, std::thread::hardware_concurrency());
  CLI::App app(
      "Does the experiments of the thesis again: J. Stork, Camera pose estimation with circular markers, University "
      "of\n"
      "Amsterdam, 2012. One marker; a simulated camera but in experiment 1.\n"
      "  1             a recording of a camera: mean and covariance of the pose at each place of the marker\n"
      "  2             lines of poses that face the camera, 0.36 m to 22 m\n"
      "  3             random poses in the thesis's five cells of angle and depth\n"
      "  resilience    occlusion, noise, blur, motion, light, distortion: circular marker, plain ring, AprilTag\n"
      "  requirements  the thesis's section 2.2.1, one row each\n"
      "  design        the marker's measures, one after another: limits of the pose, reach of the detector\n"
      "  all           all of these, experiment 1 if --recording is given\n"
      "Writes the data (CSV), statistics (JSON), figures (SVG, drawn by gnuplot) and a report (report.html, "
      "report.md).",
      "circle-marker-experiments");
  addOptions(app, settings);
  app.footer("Called again with the same folder and settings it makes the frames that are missing: an interrupted run "
             "goes\non, and a greater --frames adds frames. A frame with a method takes about 10 ms of an idle core, "
             "200 ms with\nAprilTag. The same seed gives the same results whatever the number of threads, but for the "
             "CPU times, which are\ngood with one thread only.");
  if (!common::parse(app, argc, argv)) {
    return Request{std::nullopt, app.help()};
  }
  checkTogether(settings);
  return Request{settings, ""};
}
} // namespace experiments
