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
 * Runs an experiment: makes the frames that are missing, and keeps them.
 */

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <mutex>
#include <utility>

#include "laboratory.h"
#include "run.h"

namespace experiments {
namespace {
using Clock = std::chrono::steady_clock;
using Item = std::pair<std::size_t, unsigned int>; // Series and frame.

double secondsSince(Clock::time_point start)
{
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/*! The frames that are missing, in turn through the series, which differ in the time they take. */
std::vector<Item> missingItems(const Experiment &experiment, const RunData &data)
{
  std::vector<std::pair<double, Item>> items;
  for (std::size_t i = 0; i < data.size(); ++i) {
    for (unsigned int frame = 0; frame < experiment.series[i].frames; ++frame) {
      if (!data[i][frame]) {
        items.push_back({(frame + 0.5) / experiment.series[i].frames, {i, frame}});
      }
    }
  }
  std::stable_sort(items.begin(), items.end(), [](const auto &a, const auto &b) { return a.first < b.first; });
  std::vector<Item> result;
  for (const auto &item : items) {
    result.push_back(item.second);
  }
  return result;
}

/*! Whether two numbers are the same but for the digits that the table leaves out and other processors' rounding. */
bool areSame(const std::optional<Deviation> &a, const std::optional<Deviation> &b)
{
  constexpr double share = 1e-3;
  constexpr double least = 1e-3; // mm
  return a.has_value() == b.has_value() &&
         (!a || std::fabs(a->position() - b->position()) <= least + share * a->position());
}

/*! Makes one frame of each series again, to see whether the detector is still the one that made the data. */
void checkFrames(const Experiment &experiment, const Settings &settings, const RunData &data)
{
  Laboratory laboratory(settings);
  for (std::size_t i = 0; i < data.size(); ++i) {
    const auto known =
        std::find_if(data[i].begin(), data[i].end(), [](const auto &frame) { return frame.has_value(); });
    if (known == data[i].end()) {
      continue;
    }
    const auto frame = static_cast<unsigned int>(known - data[i].begin());
    const FrameSamples again = laboratory.take(experiment.series[i], frame);
    for (std::size_t method = 0; method < again.size(); ++method) {
      if (!areSame(again[method].first, (**known)[method].first)) {
        throw DataError("frame " + std::to_string(frame) + " of " + experiment.series[i].name + " in " +
                        dataFileOf(experiment) +
                        " comes out differently now: the detector has changed; remove the file to begin anew");
      }
    }
  }
}
} // namespace

void completeRun(const Experiment &experiment, const Settings &settings, const Progress &progress, const Keep &keep,
                 RunData &data)
{
  const std::vector<Item> items = missingItems(experiment, data);
  if (items.empty()) {
    return;
  }
  checkFrames(experiment, settings, data);

  std::mutex mutex; // Of the data, which is kept while other frames are being made.
  Clock::time_point kept = Clock::now();
  double pause = 2.; // Seconds until the data is kept again.
  const auto makeWorker = [&]() {
    const auto laboratory = std::make_shared<Laboratory>(settings);
    return [&, laboratory](std::size_t number) {
      const auto [series, frame] = items[number];
      FrameSamples samples = laboratory->take(experiment.series[series], frame);
      const std::lock_guard<std::mutex> lock(mutex);
      data[series][frame] = std::move(samples);
      if (secondsSince(kept) > pause) {
        constexpr double mostShare = 0.05; // Of the time that may go into keeping.
        const Clock::time_point start = Clock::now();
        keep(data);
        kept = Clock::now();
        pause = std::max(pause, secondsSince(start) / mostShare);
      }
    };
  };
  forEachItem(items.size(), settings.threads, makeWorker, progress);
  keep(data);
}
} // namespace experiments
