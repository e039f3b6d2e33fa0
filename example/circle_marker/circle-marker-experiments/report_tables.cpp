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
 * Tables that stand methods beside the thesis.
 */

#include "report_tables.h"
#include "common/numbers.h"

namespace experiments {
namespace {
std::string vectorOf(double x, double y, double z)
{
  return "(" + digits(x) + ", " + digits(y) + ", " + digits(z) + ")";
}

std::string thesisText(const std::optional<double> &value)
{
  return value ? digits(*value) : "not measured";
}

/*! A row of the comparison: its name, what the thesis has, and what a view has. */
struct Row
{
  std::string name;
  std::function<std::string(const ThesisFigures &)> thesis;
  std::function<std::string(const View &, const Summary &)> view;
};

const std::string notApplicable = "-";

std::string ofDetector(const View &view, const std::string &text)
{
  return view.method == Method::Bound ? notApplicable : text;
}

std::vector<Row> throughputRows()
{
  return {{"frames n", [](const ThesisFigures &t) { return std::to_string(t.frames); },
           [](const View &, const Summary &s) { return std::to_string(s.frames); }},
          {"throughput, frames a second (pipeline on one core; thesis: with the simulator)",
           [](const ThesisFigures &t) { return digits(t.framesPerSecond); },
           [](const View &v, const Summary &s) { return ofDetector(v, digits(1000. / s.cpuTime.mean)); }},
          {"ellipses before the filter, a frame", [](const ThesisFigures &t) { return digits(t.ellipsesBefore); },
           [](const View &v, const Summary &s) { return ofDetector(v, digits(s.outlines)); }},
          {"ellipses after the filter, a frame (ours: recognised markers)",
           [](const ThesisFigures &t) { return digits(t.ellipsesAfter); },
           [](const View &v, const Summary &s) { return ofDetector(v, digits(s.markers)); }},
          {"detection rate, % (thesis: half of its ellipses after the filter)",
           [](const ThesisFigures &t) { return "about " + digits(100. * t.detectionRate()); },
           [](const View &v, const Summary &s) { return ofDetector(v, percent(s.found, s.frames)); }}};
}

std::vector<Row> errorRows()
{
  return {
      {"least |C - eC|, mm", [](const ThesisFigures &t) { return digits(t.leastError); },
       [](const View &, const Summary &s) { return digits(s.position.least); }},
      {"greatest |C - eC|, mm", [](const ThesisFigures &t) { return digits(t.mostError); },
       [](const View &, const Summary &s) { return digits(s.position.most); }},
      {"mean |C - eC|, mm", [](const ThesisFigures &t) { return digits(t.meanError); },
       [](const View &, const Summary &s) { return digits(s.position.mean); }},
      {"median |C - eC|, mm", [](const ThesisFigures &) { return notApplicable; },
       [](const View &, const Summary &s) { return digits(s.position.median); }},
      {"σ of |C - eC|, mm", [](const ThesisFigures &t) { return digits(t.sigmaError); },
       [](const View &, const Summary &s) { return digits(s.position.sigma); }},
      {"mean C - eC (x, y, z), mm",
       [](const ThesisFigures &t) { return vectorOf(t.meanOffset[0], t.meanOffset[1], t.meanOffset[2]); },
       [](const View &, const Summary &s) { return vectorOf(s.offset[0].mean, s.offset[1].mean, s.offset[2].mean); }},
      {"mean angle N, eN, degrees", [](const ThesisFigures &t) { return thesisText(t.meanAngle); },
       [](const View &, const Summary &s) { return digits(s.angle.mean); }},
      {"median angle N, eN, degrees", [](const ThesisFigures &) { return notApplicable; },
       [](const View &, const Summary &s) { return digits(s.angle.median); }},
      {"σ of the angle N, eN, degrees", [](const ThesisFigures &t) { return thesisText(t.sigmaAngle); },
       [](const View &, const Summary &s) { return digits(s.angle.sigma); }},
      {"mirrored solution first, % of those found", [](const ThesisFigures &) { return notApplicable; },
       [](const View &v, const Summary &s) {
         return v.solutions == Solutions::Both || v.method == Method::Bound ? notApplicable
                                                                            : percent(s.mirrored, s.found);
       }}};
}
} // namespace

void addComparison(const Series &series, const std::vector<std::optional<FrameSamples>> &frames,
                   const std::vector<View> &views, Document &document)
{
  std::vector<std::string> titles = {""};
  if (series.thesis != nullptr) {
    titles.push_back(std::string("thesis, table ") + series.thesis->table);
  }
  std::vector<Summary> summaries;
  for (const View &view : views) {
    titles.push_back(view.title);
    summaries.push_back(summaryOf(samplesOf(frames, view.method), view.solutions));
  }
  std::vector<Row> rows = throughputRows();
  const std::vector<Row> errors = errorRows();
  rows.insert(rows.end(), errors.begin(), errors.end());
  std::vector<std::vector<std::string>> table;
  for (const Row &row : rows) {
    table.push_back({row.name});
    if (series.thesis != nullptr) {
      table.back().push_back(row.thesis(*series.thesis));
    }
    for (std::size_t i = 0; i < views.size(); ++i) {
      table.back().push_back(row.view(views[i], summaries[i]));
    }
  }
  document.addTable(series.title, titles, table);
}

void addOverview(const std::string &caption, const Experiment &experiment, const RunData &data,
                 const std::vector<View> &views, Document &document)
{
  std::vector<std::string> titles = {"", "frames", "thesis: mean |C - eC| mm / angle °"};
  for (const View &view : views) {
    titles.push_back(std::string(view.title) + ": mean |C - eC| mm / angle ° / found %");
  }
  std::vector<std::vector<std::string>> table;
  for (std::size_t i = 0; i < experiment.series.size(); ++i) {
    const Series &series = experiment.series[i];
    const ThesisFigures *thesis = series.thesis;
    std::vector<std::string> row = {series.title, std::to_string(samplesOf(data[i], Method::Circle).size()),
                                    thesis ? digits(thesis->meanError) + " / " + thesisText(thesis->meanAngle)
                                           : notApplicable};
    for (const View &view : views) {
      const Summary summary = summaryOf(samplesOf(data[i], view.method), view.solutions);
      row.push_back(digits(summary.position.mean) + " / " + digits(summary.angle.mean) + " / " +
                    ofDetector(view, percent(summary.found, summary.frames)));
    }
    table.push_back(row);
  }
  document.addTable(caption, titles, table);
}
} // namespace experiments
