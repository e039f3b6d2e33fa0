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
 * Statistics of the trials, for each cell and method.
 */

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

#include <visp3/core/vpMath.h>

#include "summary.h"

namespace compare {
namespace {
using Errors = std::vector<PoseError>;

Statistics over(const Errors &errors, const std::function<double(const PoseError &)> &value)
{
  std::vector<double> values;
  for (const PoseError &error : errors) {
    values.push_back(value(error));
  }
  return statisticsOf(values);
}

ErrorSummary errorSummaryOf(const Errors &errors)
{
  constexpr double millimetres = 1000.;
  ErrorSummary summary;
  summary.frames = errors.size();
  summary.position = over(errors, [](const PoseError &error) { return millimetres * error.position; });
  summary.x = over(errors, [](const PoseError &error) { return millimetres * std::fabs(error.x); });
  summary.y = over(errors, [](const PoseError &error) { return millimetres * std::fabs(error.y); });
  summary.z = over(errors, [](const PoseError &error) { return millimetres * std::fabs(error.z); });
  summary.normal = over(errors, [](const PoseError &error) { return vpMath::deg(error.normal); });
  summary.rotation = over(errors, [](const PoseError &error) { return vpMath::deg(error.rotation); });
  summary.wrongSolutions = static_cast<std::size_t>(
      std::count_if(errors.begin(), errors.end(), [](const PoseError &error) { return error.wrongSolution; }));
  return summary;
}

MethodSummary methodSummaryOf(const std::vector<Trial> &trials, std::size_t method)
{
  constexpr double milliseconds = 1000.;
  MethodSummary summary;
  Errors own;
  Errors common;
  std::vector<double> times;
  for (const Trial &trial : trials) {
    const Measurement &measurement = trial.measurements[method];
    summary.wrongIds += measurement.wrongIds;
    times.push_back(milliseconds * measurement.cpuTime);
    if (measurement.error) {
      own.push_back(*measurement.error);
      if (trial.foundByAll()) {
        common.push_back(*measurement.error);
      }
    }
  }
  summary.found = own.size();
  summary.cpuTime = statisticsOf(times);
  summary.own = errorSummaryOf(own);
  summary.common = errorSummaryOf(common);
  return summary;
}
} // namespace

Summary summaryOf(const std::vector<Trial> &trials)
{
  Summary summary;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    std::vector<Trial> ofCell;
    std::copy_if(trials.begin(), trials.end(), std::back_inserter(ofCell),
                 [cell](const Trial &trial) { return trial.cell == cell; });
    summary[cell].frames = ofCell.size();
    summary[cell].common = static_cast<std::size_t>(
        std::count_if(ofCell.begin(), ofCell.end(), [](const Trial &trial) { return trial.foundByAll(); }));
    for (std::size_t method = 0; method < methodCount; ++method) {
      summary[cell].methods[method] = methodSummaryOf(ofCell, method);
    }
  }
  return summary;
}

Ratios circleOver(Method method, const CellSummary &cell)
{
  const ErrorSummary &circle = cell[Method::Circle].common;
  const ErrorSummary &other = cell[method].common;
  return {circle.x.rms / other.x.rms, circle.y.rms / other.y.rms, circle.z.rms / other.z.rms,
          circle.rotation.rms / other.rotation.rms};
}
} // namespace compare
