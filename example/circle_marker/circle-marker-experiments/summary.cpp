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
 * Statistics of a method's samples.
 */

#include <algorithm>

#include "summary.h"

namespace experiments {
namespace {
bool isFoundBy(Method method, const FrameSamples &frame)
{
  return std::any_of(frame.begin(), frame.end(),
                     [method](const Sample &sample) { return sample.method == method && sample.first; });
}
} // namespace

std::vector<Sample> samplesOf(const std::vector<std::optional<FrameSamples>> &series, Method method)
{
  std::vector<Sample> samples;
  for (const auto &frame : series) {
    if (frame && (method != Method::Bound || isFoundBy(Method::Circle, *frame))) {
      std::copy_if(frame->begin(), frame->end(), std::back_inserter(samples),
                   [method](const Sample &sample) { return sample.method == method; });
    }
  }
  return samples;
}

std::vector<Deviation> deviationsOf(const Sample &sample, Solutions solutions)
{
  std::vector<Deviation> deviations;
  if (sample.first) {
    deviations.push_back(*sample.first);
  }
  if (sample.second && solutions == Solutions::Both) {
    deviations.push_back(*sample.second);
  }
  return deviations;
}

Summary summaryOf(const std::vector<Sample> &samples, Solutions solutions)
{
  Summary summary;
  summary.frames = samples.size();
  std::vector<double> positions, angles, times;
  std::array<std::vector<double>, 3> offsets;
  std::size_t outlines = 0;
  std::size_t markers = 0;
  for (const Sample &sample : samples) {
    const std::size_t found = sample.first ? 1 : 0;
    summary.found += found;
    summary.falseMarkers += sample.markers - found;
    summary.mirrored += sample.first && sample.isMirrored ? 1 : 0;
    summary.wrong += isWrong(sample) ? 1 : 0;
    outlines += sample.outlines;
    markers += sample.markers;
    times.push_back(sample.cpuTime);
    for (const Deviation &deviation : deviationsOf(sample, solutions)) {
      positions.push_back(deviation.position());
      angles.push_back(deviation.normal);
      offsets[0].push_back(-deviation.dx);
      offsets[1].push_back(-deviation.dy);
      offsets[2].push_back(-deviation.dz);
    }
  }
  const double frames = static_cast<double>(samples.size());
  summary.outlines = static_cast<double>(outlines) / frames;
  summary.markers = static_cast<double>(markers) / frames;
  summary.position = statisticsOf(positions);
  summary.angle = statisticsOf(angles);
  for (std::size_t axis = 0; axis < offsets.size(); ++axis) {
    summary.offset[axis] = statisticsOf(offsets[axis]);
  }
  summary.cpuTime = statisticsOf(times);
  return summary;
}

std::vector<std::vector<Sample>> inBins(const std::vector<Sample> &samples, const std::vector<double> &edges,
                                        const SampleValue &value)
{
  std::vector<std::vector<Sample>> bins(edges.size() - 1);
  for (const Sample &sample : samples) {
    const auto above = std::upper_bound(edges.begin(), edges.end(), value(sample));
    if (above != edges.begin() && above != edges.end()) {
      bins[static_cast<std::size_t>(above - edges.begin()) - 1].push_back(sample);
    }
  }
  return bins;
}

std::vector<double> evenBins(double least, double most, std::size_t count)
{
  std::vector<double> edges;
  for (std::size_t i = 0; i <= count; ++i) {
    edges.push_back(least + (most - least) * static_cast<double>(i) / static_cast<double>(count));
  }
  return edges;
}
} // namespace experiments
