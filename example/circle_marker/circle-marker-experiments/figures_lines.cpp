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
 * The figures of experiment 2.
 */

#include <algorithm>
#include <cmath>

#include "curves.h"
#include "figures_thesis.h"

namespace experiments {
namespace {
const std::vector<View> views = {ringBoth, ringFirst, circle, bound};

double distance(const Sample &sample)
{
  return sample.distance();
}

double farthest(const RunData &data)
{
  double most = 1.;
  for (const auto &series : data) {
    for (const Sample &sample : samplesOf(series, Method::Circle)) {
      most = std::max(most, sample.distance());
    }
  }
  return std::ceil(most);
}

/*! Where the marker is found and where it is not, seen from above. */
CaptionedFigure detections(const Experiment &experiment, const RunData &data)
{
  Figure figure = {"experiment-2-detections.svg", "Where the circular marker is found", 2, {}};
  for (std::size_t i = 0; i < experiment.series.size(); ++i) {
    std::vector<Sample> found, missed;
    for (const Sample &sample : samplesOf(data[i], Method::Circle)) {
      (sample.first ? found : missed).push_back(sample);
    }
    Curve there = trueCentres(found);
    there.title = "found";
    there.style = "with points linestyle 1";
    Curve absent = trueCentres(missed);
    absent.title = "not found";
    absent.style = "with points linestyle 2 pointtype 2 pointsize 0.8";
    figure.panels.push_back({experiment.series[i].title, "x [m]", "z [m]", "", {there, absent}});
  }
  return {figure, "Thesis, figure 5.4: positions C at which the marker is found. There none was found beyond 10 m."};
}

/*! All frames of all series, either those on the optical axis or the others. */
std::vector<Sample> onAxis(const RunData &data, Method method, bool isOnAxis)
{
  std::vector<Sample> samples;
  for (const auto &series : data) {
    for (const Sample &sample : samplesOf(series, method)) {
      if ((sample.x == 0. && sample.y == 0.) == isOnAxis) {
        samples.push_back(sample);
      }
    }
  }
  return samples;
}

CaptionedFigure errors(const RunData &data)
{
  Figure figure = {"experiment-2-error.svg", "Errors against distance, frames of all series", 2, {}};
  const std::vector<double> edges = evenBins(0., farthest(data), 12);
  for (const bool isOnAxis : {true, false}) {
    const std::string title = isOnAxis ? "on the optical axis: θ = 0" : "on the other lines: θ to 22°";
    Panel position = {title, "|C| [m]", "mean |C - eC| [mm]", logarithmicY, {}};
    Panel normal = {title, "|C| [m]", "mean angle between N and eN [°]", logarithmicY, {}};
    for (const View &view : viewsIn(data, views)) {
      const std::vector<Sample> samples = onAxis(data, view.method, isOnAxis);
      position.curves.push_back(
          meanCurve(samples, view, edges, distance, [](const Deviation &deviation) { return deviation.position(); }));
      normal.curves.push_back(
          meanCurve(samples, view, edges, distance, [](const Deviation &deviation) { return deviation.normal; }));
    }
    figure.panels.push_back(position);
    figure.panels.push_back(normal);
  }
  return {figure,
          "Not in the thesis: what is left of the errors. On the optical axis the marker faces the camera and "
          "shows its tilt in the second order only: its normal is known worst of all poses there. The bound is of "
          "first order in the tilt: where it exceeds some degrees the true limit is less."};
}
} // namespace

std::vector<CaptionedFigure> figuresOfLines(const Experiment &experiment, const RunData &data)
{
  constexpr unsigned int columns = 2;
  return {detections(experiment, data),
          {depthFigure(estimatedDepth("experiment-2-depth.svg"), columns, experiment, data),
           "Thesis, figure 5.5: eCz against Cz."},
          {cloudFigure("experiment-2-clouds.svg", columns, experiment, data),
           "Thesis, figure 5.6: point clouds of C and eC. There the estimates lay on other lines, some 200 times too "
           "near; here they lie on the true ones."},
          errors(data)};
}
} // namespace experiments
