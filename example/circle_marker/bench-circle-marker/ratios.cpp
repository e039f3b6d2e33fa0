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
 * The ratios to other detectors, by CPU time, on the same frames in turn.
 */

#include "tables.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iomanip>
#include <string>
#include <vector>

#include "common/statistics.h"
#include "peers.h"

namespace bench {
namespace {
// Least ratios that the project asks of itself for frames with noise, and for those without; 0: none.
struct Goal
{
  const char *peer;
  double noisy;
  double noiseFree;
};
constexpr Goal goals[] = {
    {"apriltag-decimation-1", 20., 0.}, {"apriltag-decimation-2", 5., 1.}, {"adaptive-threshold-23", 1. / 3., 0.}};

double goalOf(const std::string &peer, double noise)
{
  for (const Goal &goal : goals) {
    if (peer == goal.peer) {
      return noise > 0. ? goal.noisy : goal.noiseFree;
    }
  }
  return 0.;
}

double cpuMilliseconds()
{
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

double timeOf(const Peer &peer, const Scene &scene)
{
  const double start = cpuMilliseconds();
  peer.look(scene);
  return cpuMilliseconds() - start;
}

double medianOf(const std::vector<double> &values)
{
  return common::statisticsOf(values).median;
}

SceneOptions frameWith(bool clutter, double noise)
{
  SceneOptions options;
  options.clutter = clutter;
  options.markers = clutter ? 5 : 1;
  options.noise = noise;
  return options;
}

std::string nameOf(const SceneOptions &options)
{
  return std::string(options.clutter ? "clutter, 5 markers" : "plain, 1 marker") +
         (options.noise > 0. ? ", noise 2" : ", no noise");
}

// Frames differ by what in them looks like a marker and is none.
void tellSpread(std::ostream &out)
{
  constexpr std::uint64_t frames = 40;
  constexpr int looks = 3; // the least time of them: the rest is the machine's
  const Peer ours = circleMarker();
  out << "\n| " << frames << " frames | mean, ms | median | 95 % quantile | greatest |\n|---|---|---|---|---|\n"
      << std::setprecision(2);
  for (const bool clutter : {false, true}) {
    for (const double noise : {2., 0.}) {
      SceneOptions options = frameWith(clutter, noise);
      std::vector<double> times;
      for (options.seed = 1; options.seed <= frames; ++options.seed) {
        const Scene scene = makeScene(options);
        times.push_back(HUGE_VAL);
        for (int look = 0; look < looks; ++look) {
          times.back() = std::min(times.back(), timeOf(ours, scene));
        }
      }
      const common::Statistics spread = common::statisticsOf(times);
      out << "| " << nameOf(options) << " | " << spread.mean << " | " << spread.median << " | " << spread.p95 << " | "
          << spread.most << " |" << std::endl;
    }
  }
}
} // namespace

void tellRatios(std::ostream &out, unsigned int rounds)
{
  const Peer ours = circleMarker();
  const Peer unrefined = circleMarker(1, false);
  const std::vector<Peer> others = peers();
  out << "| frame | peer | peer, ms | circle marker, ms | without refinement, ms | peer / circle marker "
         "| without refinement | asked for | met |\n|---|---|---|---|---|---|---|---|---|\n"
      << std::fixed;
  for (const bool clutter : {false, true}) {
    for (const double noise : {2., 0.}) {
      SceneOptions options = frameWith(clutter, noise);
      std::vector<Scene> scenes;
      for (options.seed = 1; options.seed <= 3; ++options.seed) {
        scenes.push_back(makeScene(options));
        ours.look(scenes.back()); // warms caches up and sizes the working memory
        unrefined.look(scenes.back());
      }
      for (const Peer &peer : others) {
        std::vector<double> theirTimes;
        std::vector<double> ourTimes;
        std::vector<double> unrefinedTimes;
        std::vector<double> ratios;
        std::vector<double> unrefinedRatios;
        for (unsigned int i = 0; i < rounds * scenes.size(); ++i) {
          const Scene &scene = scenes[i % scenes.size()];
          theirTimes.push_back(timeOf(peer, scene));
          ourTimes.push_back(timeOf(ours, scene));
          unrefinedTimes.push_back(timeOf(unrefined, scene));
          ratios.push_back(theirTimes.back() / ourTimes.back());
          unrefinedRatios.push_back(theirTimes.back() / unrefinedTimes.back());
        }
        const double goal = goalOf(peer.name, noise);
        const double ratio = medianOf(ratios);
        out << "| " << nameOf(options) << " | " << peer.name << " | " << std::setprecision(2) << medianOf(theirTimes)
            << " | " << medianOf(ourTimes) << " | " << medianOf(unrefinedTimes) << " | " << ratio << " | "
            << medianOf(unrefinedRatios) << " | ";
        if (goal > 0.) {
          out << goal << " | " << (ratio >= goal ? "yes" : "no") << " |" << std::endl;
        }
        else {
          out << "- | - |" << std::endl;
        }
      }
    }
  }
  tellSpread(out);
}
} // namespace bench
