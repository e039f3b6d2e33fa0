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
 * Benchmarks of the detector of circular markers, beside others in the same run.
 */

/*!
  \example bench-circle-marker/main.cpp
  Benchmarks of the whole detection and of its rooms, with AprilTag and OpenCV's adaptive threshold in the same run;
  tables of the ratios, of the reach, of hardships, of phantoms, of other families, of photographs and of timeouts.
*/

#include <iostream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <benchmark/benchmark.h>

#include <opencv2/core.hpp>

#include "common/arguments.h"
#include "register.h"
#include "tables.h"

int main(int argc, char *argv[])
{
  const std::string name = "bench-circle-marker";
  CLI::App app("Benchmarks of the detector of circular markers. Without a table: Google Benchmark, whose options "
               "(--benchmark_filter=REGEX, --benchmark_list_tests, --benchmark_format=json ...) are passed on.",
               name);
  unsigned int ratios = 0;
  unsigned int reach = 0;
  unsigned int phantoms = 0;
  app.add_option("--ratios", ratios,
                 "Table of CPU times beside the others', each looking N times at each frame, and of their spread")
      ->expected(0, 1)
      ->default_str("10")
      ->check(CLI::Range(1, 1000));
  app.add_option("--reach", reach,
                 "Table of the share of markers that are found, on N frames of 20, and half as many in any light")
      ->check(CLI::Range(1, 1000000));
  app.add_option("--phantoms", phantoms, "Table of the markers found in N images that have none")
      ->check(CLI::Range(1, 1000000));
  unsigned int others = 0;
  app.add_option("--other-families", others,
                 "Table of the markers that are found as those of another family, on N frames of 20")
      ->check(CLI::Range(1, 1000000));
  unsigned int timeouts = 0;
  app.add_option("--timeouts", timeouts, "Table of how long after its timeout the detector comes back, N rounds")
      ->check(CLI::Range(1, 1000));
  unsigned int hardships = 0;
  app.add_option("--hardships", hardships,
                 "Table of the share of markers that are found where they are covered or the picture is bad, N frames "
                 "of each kind")
      ->check(CLI::Range(1, 1000000));
  bool areSmall = false;
  app.add_flag("--small", areSmall, "With --hardships markers of 12 to 45 pixels, in any light, not of 40 to 160");
  bool isUnrefined = false;
  app.add_flag("--unrefined", isUnrefined, "With --hardships poses as the closed form gives them, and codes unproven");
  std::uint64_t seed = 1;
  app.add_option("--seed", seed, "Seed of the frames for --reach, --hardships, --phantoms and --other-families")
      ->check(common::wholeNumber())
      ->capture_default_str();
  std::string only;
  app.add_option("--only", only, "With --hardships the kind of this name, with --phantoms those with this in it");
  std::string family = "golay23";
  app.add_option("--family", family, "Family of the markers for --reach and --hardships")
      ->check(CLI::IsMember({"golay23", "bch31", "bch31r", "ring", "disc"}))
      ->capture_default_str();
  std::string photographs;
  std::string overlays;
  app.add_option("--photographs", photographs, "Markers found in the pictures of a folder that has none")
      ->check(CLI::ExistingDirectory);
  app.add_option("--overlays", overlays,
                 "With --photographs: folder to write pictures of the rings found to; with --phantoms: of the coded "
                 "markers found; with --reach: of the frames with a wrong id; with --hardships: of the frames whose "
                 "marker was not found, or which have another (*-other.png)")
      ->check(CLI::ExistingDirectory);
  app.allow_extras();
  try {
    app.parse(argc, argv);
  }
  catch (const CLI::CallForHelp &help) {
    return app.exit(help);
  }
  catch (const CLI::ParseError &e) {
    std::cerr << name << ": " << e.what() << "; see --help" << std::endl;
    return 2;
  }
  const bool isTable = ratios + timeouts + reach + hardships + phantoms + others > 0 || !photographs.empty();
  if (isTable && app.remaining_size() > 0) {
    std::cerr << name << ": unknown argument \"" << app.remaining().front() << "\"; see --help" << std::endl;
    return 2;
  }
  try {
    cv::setNumThreads(1); // one thread for all; the detector's own threads are its own setting
    if (ratios > 0) {
      bench::tellRatios(std::cout, ratios);
    }
    if (timeouts > 0) {
      bench::tellTimeouts(std::cout, timeouts);
    }
    if (reach > 0) {
      bench::tellReach(std::cout, family, reach, seed, overlays);
    }
    if (hardships > 0) {
      const auto markers = areSmall ? bench::HardMarkers::SMALL : bench::HardMarkers::USUAL;
      bench::tellHardships(std::cout, {family, hardships, seed, markers, !isUnrefined, only, overlays});
    }
    if (phantoms > 0) {
      bench::tellPhantoms(std::cout, phantoms, seed, only, overlays);
    }
    if (others > 0) {
      bench::tellOtherFamilies(std::cout, others, seed);
    }
    if (!photographs.empty()) {
      bench::tellPhotographs(std::cout, photographs, overlays);
    }
    if (isTable) {
      return 0;
    }
    std::vector<std::string> left = {name};
    for (const std::string &argument : app.remaining()) {
      if (argument.rfind("--benchmark_", 0) != 0 && argument.rfind("--v=", 0) != 0) {
        std::cerr << name << ": unknown argument \"" << argument << "\"; see --help" << std::endl;
        return 2;
      }
      left.push_back(argument);
    }
    std::vector<char *> arguments;
    for (std::string &argument : left) {
      arguments.push_back(argument.data());
    }
    int count = static_cast<int>(arguments.size());
    arguments.push_back(nullptr);
    bench::registerWholeFrames();
    bench::registerRooms();
    benchmark::Initialize(&count, arguments.data());
    benchmark::RunSpecifiedBenchmarks();
    return 0;
  }
  catch (const std::exception &e) {
    std::cerr << name << ": " << e.what() << std::endl;
    return 1;
  }
}
