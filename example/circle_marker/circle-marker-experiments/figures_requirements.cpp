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
 * The figures of the requirements: the still and the moving sequence.
 */

#include "curves.h"
#include "figures.h"

namespace experiments {
namespace {
/*! A value of each frame's pose against the frame's number. */
Curve sequence(const std::vector<std::optional<FrameSamples>> &frames, const std::string &title, unsigned int style,
               const std::function<double(const Sample &)> &value)
{
  Curve curve = {title, "with lines linestyle " + std::to_string(style) + " linewidth 1", {}};
  for (std::size_t frame = 0; frame < frames.size(); ++frame) {
    if (frames[frame] && frames[frame]->front().first) {
      curve.points.push_back({static_cast<double>(frame), value(frames[frame]->front())});
    }
  }
  return curve;
}
} // namespace

std::vector<CaptionedFigure> figuresOfRequirements(const Experiment &experiment, const RunData &data)
{
  Figure figure = {"requirements-jitter.svg", "Jitter: error of the pose from frame to frame", 3, {}};
  for (std::size_t i = 0; i < experiment.series.size(); ++i) {
    const Series &series = experiment.series[i];
    if (series.name != "still" && series.name != "moving") {
      continue;
    }
    figure.panels.push_back({series.title,
                             "frame",
                             "eC - C [mm]",
                             "",
                             {sequence(data[i], "x", 3, [](const Sample &sample) { return sample.first->dx; }),
                              sequence(data[i], "y", 6, [](const Sample &sample) { return sample.first->dy; }),
                              sequence(data[i], "z", 1, [](const Sample &sample) { return sample.first->dz; })}});
    figure.panels.push_back(
        {series.title,
         "frame",
         "angle between N and eN [°]",
         "set yrange [0:1e-3<*]\n",
         {sequence(data[i], "normal", 2, [](const Sample &sample) { return sample.first->normal; })}});
    figure.panels.push_back({series.title,
                             "frame",
                             "CPU time [ms]",
                             "set yrange [0:1e-3<*]\n",
                             {sequence(data[i], "time", 7, [](const Sample &sample) { return sample.cpuTime; })}});
  }
  return {{figure, "Jitter (thesis, 2.2.1) over a still sequence and over a moving one."}};
}
} // namespace experiments
