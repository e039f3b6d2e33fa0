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
 * Curves of the figures, from samples.
 */

#include <algorithm>
#include <cmath>
#include <sstream>

#include "curves.h"

namespace experiments {
namespace {
// Points of a cloud: enough to fill a panel, few enough for files of some tens of kilobytes.
constexpr std::size_t mostPoints = 100;
// Bins with fewer estimates have no mean that says anything.
constexpr std::size_t leastEstimates = 5;

std::string styleNumber(const View &view)
{
  if (view.method == Method::Ring) {
    return view.solutions == Solutions::Both ? "2" : "7";
  }
  return view.method == Method::AprilTag ? "3" : view.method == Method::Bound ? "5" : "1";
}

/*! Every so manyeth sample. */
std::vector<Sample> thinned(const std::vector<Sample> &samples)
{
  const std::size_t step = (samples.size() + mostPoints - 1) / mostPoints;
  std::vector<Sample> result;
  for (std::size_t i = 0; i < samples.size(); i += step) {
    result.push_back(samples[i]);
  }
  return result;
}
} // namespace

std::string lineStyle(const View &view)
{
  return "with linespoints linestyle " + styleNumber(view);
}

std::string pointStyle(const View &view)
{
  return "with points linestyle 1" + styleNumber(view);
}

std::vector<View> viewsIn(const RunData &data, const std::vector<View> &views)
{
  std::vector<View> result;
  for (const View &view : views) {
    if (std::any_of(data.begin(), data.end(),
                    [&](const auto &series) { return !samplesOf(series, view.method).empty(); })) {
      result.push_back(view);
    }
  }
  return result;
}

Curve trueCentres(const std::vector<Sample> &samples)
{
  Curve curve = {"C, true centres", "with points linestyle 16", {}};
  for (const Sample &sample : thinned(samples)) {
    curve.points.push_back({sample.x, sample.z});
  }
  return curve;
}

Curve estimatedCentres(const std::vector<Sample> &samples, const View &view)
{
  constexpr double metres = 1e-3; // In a millimetre.
  Curve curve = {std::string("eC, ") + view.title, pointStyle(view), {}};
  for (const Sample &sample : thinned(samples)) {
    for (const Deviation &deviation : deviationsOf(sample, view.solutions)) {
      curve.points.push_back({sample.x + metres * deviation.dx, sample.z + metres * deviation.dz});
    }
  }
  return curve;
}

Curve estimates(const std::vector<Sample> &samples, const View &view, const SampleValue &x,
                const std::function<double(const Sample &, const Deviation &)> &y)
{
  Curve curve = {view.title, pointStyle(view), {}};
  for (const Sample &sample : thinned(samples)) {
    for (const Deviation &deviation : deviationsOf(sample, view.solutions)) {
      curve.points.push_back({x(sample), y(sample, deviation)});
    }
  }
  return curve;
}

Curve meanCurve(const std::vector<Sample> &samples, const View &view, const std::vector<double> &edges,
                const SampleValue &x, const std::function<double(const Deviation &)> &y)
{
  Curve curve = {view.title, lineStyle(view), {}};
  const auto bins = inBins(samples, edges, x);
  for (std::size_t bin = 0; bin < bins.size(); ++bin) {
    std::vector<double> values;
    for (const Sample &sample : bins[bin]) {
      for (const Deviation &deviation : deviationsOf(sample, view.solutions)) {
        values.push_back(y(deviation));
      }
    }
    if (values.size() >= leastEstimates) {
      curve.points.push_back({0.5 * (edges[bin] + edges[bin + 1]), statisticsOf(values).mean});
    }
  }
  return curve;
}

Curve rateBars(const std::vector<Sample> &samples, const View &view, const std::vector<double> &edges,
               const SampleValue &x, std::size_t place, std::size_t places)
{
  constexpr double filled = 0.9; // Of the bin's width; the rest parts the bins.
  const double width = filled * (edges[1] - edges[0]) / static_cast<double>(places);
  std::ostringstream style;
  style << "using 1:2:(" << width << ") with boxes fill solid noborder linestyle " << styleNumber(view);
  Curve curve = {view.title, style.str(), {}};
  const auto bins = inBins(samples, edges, x);
  for (std::size_t bin = 0; bin < bins.size(); ++bin) {
    if (!bins[bin].empty()) {
      const double middle = 0.5 * (edges[bin] + edges[bin + 1]);
      const double offset = width * (static_cast<double>(place) - 0.5 * static_cast<double>(places - 1));
      const double found = static_cast<double>(
          std::count_if(bins[bin].begin(), bins[bin].end(), [](const Sample &s) { return s.first.has_value(); }));
      curve.points.push_back({middle + offset, 100. * found / static_cast<double>(bins[bin].size())});
    }
  }
  return curve;
}

void shareDecades(Figure &figure)
{
  constexpr double mostDecades = 6.;
  double least = HUGE_VAL;
  double most = -HUGE_VAL;
  for (const Panel &panel : figure.panels) {
    for (const Curve &curve : panel.curves) {
      for (const auto &point : curve.points) {
        if (point[1] > 0. && std::isfinite(point[1])) {
          least = std::min(least, std::log10(point[1]));
          most = std::max(most, std::log10(point[1]));
        }
      }
    }
  }
  if (least > most) {
    return; // Nothing to be drawn.
  }
  const double top = std::max(std::ceil(most), std::floor(least) + 1.);
  std::ostringstream range;
  range << "set yrange [1e" << std::max(std::floor(least), top - mostDecades) << ":1e" << top << "]\n";
  for (Panel &panel : figure.panels) {
    panel.setup += range.str();
  }
}

Curve level(const std::string &title, double least, double most, double y)
{
  return {title, "with lines linestyle 4", {{least, y}, {most, y}}};
}
} // namespace experiments
