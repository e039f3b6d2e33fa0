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
 * What a design of the marker is judged by.
 */

#include <algorithm>
#include <cmath>

#include "design_figures.h"
#include "summary.h"

namespace experiments {
namespace {
double shareOf(std::size_t part, std::size_t whole)
{
  return static_cast<double>(part) / static_cast<double>(whole);
}

double medianOf(const std::vector<Sample> &samples, const SampleValue &value)
{
  std::vector<double> values;
  for (const Sample &sample : samples) {
    if (sample.first) {
      values.push_back(value(sample));
    }
  }
  return statisticsOf(values).median;
}
} // namespace

DesignFigures designFiguresOf(const std::vector<std::optional<FrameSamples>> &series)
{
  std::vector<Sample> seen = samplesOf(series, Method::Circle);
  if (seen.empty()) {
    seen = samplesOf(series, Method::AprilTag);
  }
  const std::vector<Sample> limits = samplesOf(series, Method::Limit);
  const Summary summary = summaryOf(seen, Solutions::First);
  DesignFigures figures;
  figures.frames = seen.size();
  figures.found = shareOf(summary.found - summary.wrong, seen.size());
  // Depths are even over their range, so the share found is the part of the range that is within reach.
  figures.reach = leastDesignDepth + figures.found * (mostDesignDepth - leastDesignDepth);
  figures.depthLimit = medianOf(limits, [](const Sample &sample) { return sample.first->dz; });
  figures.lateralLimit =
      medianOf(limits, [](const Sample &sample) { return std::hypot(sample.first->dx, sample.first->dy); });
  figures.normalLimit = medianOf(limits, [](const Sample &sample) { return sample.first->normal; });
  figures.separation = medianOf(limits, [](const Sample &sample) { return std::sqrt(2. * sample.logOdds); });
  figures.reading = medianOf(limits, [](const Sample &sample) { return sample.reading; });
  constexpr double unsure = 10.; // An error's probability is Phi(-5).
  figures.unread = shareOf(static_cast<std::size_t>(std::count_if(
                               limits.begin(), limits.end(),
                               [](const Sample &sample) { return sample.reading > 0. && sample.reading < unsure; })),
                           limits.size());
  constexpr double weak = 10.; // Log-odds: one in 22000 for the wrong solution.
  figures.weakSeparation =
      shareOf(static_cast<std::size_t>(std::count_if(limits.begin(), limits.end(),
                                                     [](const Sample &sample) { return sample.logOdds < weak; })),
              limits.size());
  constexpr double medianOfNormal = 0.6745; // Of |x| with a standard deviation of 1.
  figures.depthError =
      medianOf(seen, [](const Sample &sample) { return std::fabs(sample.first->dz); }) / medianOfNormal;
  figures.mirrored = shareOf(summary.mirrored, summary.found);
  return figures;
}
} // namespace experiments
