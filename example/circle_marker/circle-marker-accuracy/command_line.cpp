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
 * Command line of circle-marker-accuracy.
 */

#include <algorithm>
#include <thread>
#include <vector>

#include "command_line.h"
#include "common/arguments.h"

namespace accuracy {
Request parseCommandLine(int argc, const char *const argv[])
{
  Settings settings;
  settings.jobs = std::max(1u, std::thread::hardware_concurrency());
  std::vector<std::string> parts(std::begin(partNames), std::end(partNames));
  std::string surround = "unknown";
  CLI::App app(
      "Measures how near the detector's poses are to the information limit, on the simulated camera.\n"
      "limits: random poses of golay23, bch31 and ring, 17 to 400 pixels, tilt 8 to 75 degrees, noise 1 to 5,\n"
      "blur 0.5 to 1.2 pixels, contrast 60 to 190, error against the Cramer-Rao bound of each pose; honesty\n"
      "of covariance and log-odds. model: what the model does not know, one at a time and all at once.\n"
      "cells: the thesis's ranges of poses. apriltag: ViSP's AprilTag on the same sheet at the same poses.\n"
      "Writes accuracy.csv (a row for each marker and method, after lines with # that say of what), accuracy.json\n"
      "(tables and targets), and the tables to the standard output.",
      "circle-marker-accuracy");
  auto *output = app.add_option("--output", settings.output, "Folder for the results; made unless it is there");
  auto *from = app.add_option("--from", settings.from, "Folder with earlier results to be taken instead of new ones")
                   ->check(CLI::ExistingDirectory)
                   ->excludes(output);
  app.add_option("--page", settings.page, "Folder for the report, a page in Markdown and its plots; made if needed");
  app.add_option("--part", parts, "Parts, several with commas: limits, model, cells, apriltag; all unless given")
      ->delimiter(',')
      ->check(CLI::IsMember(parts))
      ->excludes(from);
  app.add_option("--frames", settings.frames,
                 "Images in each octave of diameter and family of limits; the other parts in proportion")
      ->check(CLI::Range(1u, 1000000u))
      ->excludes(from)
      ->capture_default_str();
  app.add_option("--seed", settings.seed, "Seed of poses, ids, light and noise")
      ->check(common::wholeNumber())
      ->excludes(from)
      ->capture_default_str();
  app.add_option("--jobs", settings.jobs, "Threads; the results do not depend on it, but for the CPU times")
      ->check(CLI::Range(1u, 256u))
      ->capture_default_str();
  app.add_option("--surround", surround, "What the bound knows beyond the quiet zone of R/6: nothing, or white paper")
      ->check(CLI::IsMember({"unknown", "white"}))
      ->excludes(from)
      ->capture_default_str();
  app.footer(
      "The bound's unknowns are pose, levels and blur; the rounding to 8 bits counts as noise. Images in which the\n"
      "mirrored pose comes first are counted beside the odds that the bound gives (Phi(-separation / 2), computed\n"
      "for every image with a marker below 100 pixels, beyond which they are nil) and left out of the errors.\n"
      "20 frames take 3 minutes of CPU time.");
  if (!parse(app, argc, argv)) {
    return Request{std::nullopt, app.help()};
  }
  if (settings.output.empty() && settings.from.empty()) {
    throw UsageError("neither results nor where to put them; name a folder with --output, or earlier ones with --from");
  }
  settings.parts = {parts.begin(), parts.end()};
  settings.surround = surround == "white" ? vpMarkerPoseBound::WHITE_SURROUND : vpMarkerPoseBound::UNKNOWN_SURROUND;
  return Request{settings, ""};
}
} // namespace accuracy
