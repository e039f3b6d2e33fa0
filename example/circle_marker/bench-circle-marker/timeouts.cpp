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
 * How long after its timeout the detector comes back.
 */

#include "tables.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <iomanip>

#include <visp3/circle_marker/vpDetectorCircleMarker.h>

#include "scenes.h"

namespace bench {
namespace {
double cpuMilliseconds()
{
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

double wallMilliseconds()
{
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}
} // namespace

void tellTimeouts(std::ostream &out, unsigned int rounds)
{
  std::vector<std::pair<std::string, vpImage<unsigned char>>> images;
  for (const std::string &name : timedImages()) {
    images.emplace_back(name, makeHardImage(name, 1280, 960));
  }
  SceneOptions crowd;
  crowd.markers = 40;
  crowd.clutter = true;
  images.emplace_back("40 markers", makeScene(crowd).image);
  vpDetectorCircleMarker detector;
  out << "| image | without timeout, ms CPU | greatest overrun, ms wall | ms CPU |\n|---|---|---|---|\n"
      << std::fixed << std::setprecision(2);
  for (const auto &[name, image] : images) {
    detector.setTimeout(0);
    const double start = cpuMilliseconds();
    detector.detect(image);
    const double whole = cpuMilliseconds() - start;
    double wall = 0.;
    double cpu = 0.;
    for (unsigned int i = 0; i < rounds; ++i) {
      for (const unsigned long timeout : {1UL, 2UL, 4UL, 7UL, 12UL, 20UL, 30UL, 45UL, 70UL, 100UL, 150UL, 220UL}) {
        detector.setTimeout(timeout);
        const double wallStart = wallMilliseconds();
        const double cpuStart = cpuMilliseconds();
        detector.detect(image);
        wall = std::max(wall, wallMilliseconds() - wallStart - static_cast<double>(timeout));
        cpu = std::max(cpu, cpuMilliseconds() - cpuStart - static_cast<double>(timeout));
      }
    }
    out << "| " << name << " | " << whole << " | " << wall << " | " << cpu << " |" << std::endl;
  }
}
} // namespace bench
