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
 * The figures of experiment 3.
 */

#include <algorithm>
#include <cmath>

#include "curves.h"
#include "figures_thesis.h"

namespace experiments {
namespace {
const std::vector<View> meanViews = {ringBoth, ringFirst, circle, bound};

double distance(const Sample &sample)
{
  return sample.distance();
}
double angle(const Sample &sample)
{
  return sample.angle;
}

/*! What a panel is drawn against: bins that fit the cell. */
struct Axis
{
  const char *label;
  SampleValue value;
  std::size_t bins;
};

const Axis distanceAxis = {"|C| [m]", distance, 12};
const Axis angleAxis = {"angle θ between N and the line of sight [°]", angle, 12};

std::vector<double> edgesOf(const Axis &axis, const std::vector<Sample> &samples)
{
  double most = 1.;
  for (const Sample &sample : samples) {
    most = std::max(most, axis.value(sample));
  }
  return evenBins(0., std::ceil(most + 1e-9), axis.bins);
}

/*! The thesis's mean of the whole cell, where the cell is one of the thesis's. */
std::vector<Curve> thesisLevel(const Series &series, double most, const std::function<double(const ThesisFigures &)> &y)
{
  std::vector<Curve> curves;
  if (series.thesis != nullptr) {
    curves.push_back(level("thesis, mean of the cell", 0., most, y(*series.thesis)));
  }
  return curves;
}

Figure meanFigure(const std::string &file, const std::string &title, const Axis &axis, const std::string &yLabel,
                  const std::function<double(const Deviation &)> &y,
                  const std::function<double(const ThesisFigures &)> &thesis, const Experiment &experiment,
                  const RunData &data)
{
  Figure figure = {file, title, 3, {}};
  for (std::size_t i = 0; i < experiment.series.size(); ++i) {
    const std::vector<double> edges = edgesOf(axis, samplesOf(data[i], Method::Circle));
    Panel panel = {experiment.series[i].title, axis.label, yLabel, logarithmicY, {}};
    for (const View &view : viewsIn(data, meanViews)) {
      panel.curves.push_back(meanCurve(samplesOf(data[i], view.method), view, edges, axis.value, y));
    }
    for (const Curve &curve : thesisLevel(experiment.series[i], edges.back(), thesis)) {
      panel.curves.push_back(curve);
    }
    figure.panels.push_back(panel);
  }
  shareDecades(figure);
  return figure;
}

Figure rateFigure(const std::string &file, const std::string &title, const Axis &axis, const Experiment &experiment,
                  const RunData &data)
{
  Figure figure = {file, title, 3, {}};
  for (std::size_t i = 0; i < experiment.series.size(); ++i) {
    const std::vector<double> edges = edgesOf(axis, samplesOf(data[i], Method::Circle));
    figure.panels.push_back({experiment.series[i].title,
                             axis.label,
                             "found [%]",
                             "set yrange [0:105]\n",
                             {rateBars(samplesOf(data[i], Method::Ring), ringFirst, edges, axis.value, 0, 2),
                              rateBars(samplesOf(data[i], Method::Circle), circle, edges, axis.value, 1, 2)}});
  }
  return figure;
}

} // namespace

std::vector<CaptionedFigure> figuresOfCells(const Experiment &experiment, const RunData &data)
{
  const auto position = [](const Deviation &deviation) { return deviation.position(); };
  const auto normal = [](const Deviation &deviation) { return deviation.normal; };
  const auto thesisPosition = [](const ThesisFigures &figures) { return figures.meanError; };
  const auto thesisAngle = [](const ThesisFigures &figures) { return figures.meanAngle.value_or(NAN); };
  constexpr unsigned int columns = 3;
  const auto depthError = [](const Sample &, const Deviation &d) { return std::fabs(d.dz); };
  return {
      {cloudFigure("experiment-3-clouds.svg", columns, experiment, data),
       "Thesis, figure 5.7: point clouds of C and eC."},
      {depthFigure(estimatedDepth("experiment-3-depth.svg"), columns, experiment, data),
       "Thesis, figure 5.8: eCz against Cz. There the estimates leave the diagonal from 10 m or 60° on."},
      {depthFigure({"experiment-3-depth-error.svg", "Error of the depth", "|eCz - Cz| [mm]", logarithmicY, depthError},
                   columns, experiment, data),
       "Not in the thesis: the same, as the difference from the diagonal."},
      {meanFigure("experiment-3-error-distance.svg", "Mean error of the centre against distance", distanceAxis,
                  "mean |C - eC| [mm]", position, thesisPosition, experiment, data),
       "Thesis, figure 5.9: mean |C - eC| against |C|."},
      {meanFigure("experiment-3-error-angle.svg", "Mean error of the centre against the viewing angle", angleAxis,
                  "mean |C - eC| [mm]", position, thesisPosition, experiment, data),
       "Thesis, figure 5.10: mean |C - eC| against θ."},
      {meanFigure("experiment-3-normal-angle.svg", "Mean error of the normal against the viewing angle", angleAxis,
                  "mean angle between N and eN [°]", normal, thesisAngle, experiment, data),
       "Not in the thesis: the error of the normal against θ. With both solutions counted, half of the estimates are "
       "2θ off, whatever the estimator."},
      {rateFigure("experiment-3-found-distance.svg", "Frames with the marker found, against distance", distanceAxis,
                  experiment, data),
       "Thesis, figure 5.11: detection rate against |C|."},
      {rateFigure("experiment-3-found-angle.svg", "Frames with the marker found, against the viewing angle", angleAxis,
                  experiment, data),
       "Thesis, figure 5.12: detection rate against θ."}};
}
} // namespace experiments
