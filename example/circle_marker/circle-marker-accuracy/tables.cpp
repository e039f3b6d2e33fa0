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
 * The tables of circle-marker-accuracy: for the standard output and for the page.
 */

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "common/numbers.h"
#include "parts.h"
#include "ranges.h"
#include "tables.h"

namespace accuracy {
using common::digits;

namespace {
std::string format(const char *pattern, double value)
{
  if (!std::isfinite(value)) {
    return "-";
  }
  char text[64];
  std::snprintf(text, sizeof(text), pattern, value);
  return text;
}

std::string ratio(double value)
{
  return format(value < 10. ? "%.2f" : "%.0f", value);
}
std::string bias(double value)
{
  return format(std::fabs(value) < 10. ? "%+.2f" : "%+.0f", value);
}
std::string count(double value)
{
  return format(std::floor(value) == value ? "%.0f" : "%.1f", value);
}

std::vector<std::string> joined(std::vector<std::string> first, const std::vector<std::string> &second)
{
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

const std::vector<std::string> limitTitles = {"images", "found %", "wrong",     "predicted", "x",
                                              "y",      "z",       "normal",    "worst",     "bias x",
                                              "bias y", "bias z",  "bias tilt", "Maha²/dof", "95 %"};

std::vector<std::string> limitCells(const Summary &s)
{
  return {std::to_string(s.frames),
          common::percent(s.found, s.frames),
          std::to_string(s.wrong),
          count(s.predicted),
          ratio(s.ratio[X]),
          ratio(s.ratio[Y]),
          ratio(s.ratio[Z]),
          ratio(s.ratio[NORMAL]),
          ratio(*std::max_element(s.worst.begin(), s.worst.end())),
          bias(s.bias[X]),
          bias(s.bias[Y]),
          bias(s.bias[Z]),
          bias(s.bias[NORMAL]),
          ratio(s.mahalanobis),
          ratio(s.mahalanobis95)};
}

void addRow(const std::string &name, const Records &records, Table &table)
{
  if (!records.empty()) {
    table.rows.push_back(joined({name}, limitCells(summaryOf(records))));
  }
}

Table limitTable(const Records &limits, const std::string &group)
{
  Table table = {group + ": root mean square of error / bound", joined({"range"}, limitTitles), {}};
  const Records all = chosen(limits, inGroup(group));
  for (const Range &octave : octaveRanges()) {
    for (const Range &minor : minorRanges()) {
      addRow(octave.name + ", " + minor.name, chosen(chosen(all, octave.filter), minor.filter), table);
    }
  }
  for (const Range &tilt : tiltRanges()) {
    addRow(tilt.name, chosen(all, tilt.filter), table);
  }
  addRow("all", all, table);
  return table;
}

Table wholeTable(const Records &limits)
{
  Table table = {
      "golay23: windows of 640 x 480 and whole images of 1280 x 960", joined({"images of"}, limitTitles), {}};
  addRow("640 x 480", chosen(limits, inGroup("golay23")), table);
  addRow("1280 x 960", chosen(limits, inGroup("1280 x 960")), table);
  return table;
}

Table distanceTable(const Records &limits)
{
  Table table = {"golay23 of 200 mm, f = 1600 px, noise 2, blur 0.7 px, contrast 190: at a distance",
                 joined({"cell"}, joined(limitTitles, {"normal RMS °"})),
                 {}};
  for (const DistanceCell &cell : distanceCells) {
    const Records records = chosen(limits, inGroup(cell.name));
    if (!records.empty()) {
      // Facing the camera there is no mirrored pose to be told from: which normal is nearer is a matter of rounding.
      const Summary all = summaryOf(withoutMirror(records));
      const Summary shown = cell.mostTilt == 0. ? all : summaryOf(records);
      table.rows.push_back(joined(joined({cell.name}, limitCells(shown)), {digits(all.rms[NORMAL])}));
    }
  }
  return table;
}

Table calibrationTable(const Records &limits)
{
  Table table = {"Log-odds: of those reported to be right with this probability so many are",
                 {"reported", "images", "mean reported %", "right %"},
                 {}};
  for (const Calibration &bin : calibrationOf(limits)) {
    table.rows.push_back({format("%.0f", 100. * bin.from) + " - " + format("%.0f", 100. * bin.to) + " %",
                          std::to_string(bin.frames), format("%.2f", 100. * bin.reported),
                          bin.frames > 0
                              ? format("%.2f", 100. * static_cast<double>(bin.right) / static_cast<double>(bin.frames))
                              : "-"});
  }
  return table;
}

Table modelTable(const Records &model)
{
  Table table = {
      "Outside of the model (golay23, 32-200 px, noise 2, blur 0.7 px, contrast 150): error / bound, bias of z, "
      "error / reported standard deviation",
      {"factor", "images", "found %", "wrong", "x", "y", "z", "normal", "bias z %", "bias z", "bias tilt", "x / rep.",
       "y / rep.", "z / rep.", "normal / rep.", "Maha²/dof"},
      {}};
  for (const Factor &factor : factors()) {
    const Records records = chosen(model, inGroup(factor.name));
    if (records.empty()) {
      continue;
    }
    const Summary s = summaryOf(records);
    table.rows.push_back({factor.name, std::to_string(s.frames), common::percent(s.found, s.frames),
                          std::to_string(s.wrong), ratio(s.ratio[X]), ratio(s.ratio[Y]), ratio(s.ratio[Z]),
                          ratio(s.ratio[NORMAL]), format("%+.3f", s.depthBias), bias(s.bias[Z]), bias(s.bias[NORMAL]),
                          ratio(s.optimism[X]), ratio(s.optimism[Y]), ratio(s.optimism[Z]), ratio(s.optimism[NORMAL]),
                          ratio(s.mahalanobis)});
  }
  return table;
}

Table cellTable(const Records &cells)
{
  Table table = {"The thesis's cells: ring of 180 mm, noise 2, blur 0.7 px, contrast 190; wrong solutions included",
                 {"cell", "images", "found %", "wrong", "wrong by the bound", "mean |C-eC| mm", "by the bound",
                  "median", "aim", "mean normal °", "by the bound", "median", "aim", "CPU ms"},
                 {}};
  for (const char *family : thesisFamilies) {
    for (const ThesisCell &cell : thesisCells) {
      const std::string name = std::string(family) + " " + nameOf(cell);
      const Records records = chosen(cells, inGroup(name));
      if (!records.empty()) {
        const Summary s = summaryOf(records);
        table.rows.push_back({name, std::to_string(s.frames), common::percent(s.found, s.frames),
                              std::to_string(s.wrong), format("%.1f", s.predicted), digits(s.position),
                              digits(s.positionBound), digits(s.positionMedian), format("%g", cell.meanError),
                              format("%.4f", s.normal), format("%.4f", s.normalBound), format("%.4f", s.normalMedian),
                              format("%g", cell.meanNormal), digits(s.milliseconds)});
      }
    }
  }
  return table;
}

Table tagTable(const Records &tags)
{
  Table table = {"AprilTag 36h11 on the same sheet at the same poses (half pixel corrected): images in which all found "
                 "their marker and none took the mirrored pose",
                 {"range", "method", "found %", "wrong", "images", "x mm", "y mm", "z mm", "rotation °", "x / bound",
                  "y / bound", "z / bound", "normal / bound"},
                 {}};
  for (std::size_t octave = 1; octave < octaves.size(); ++octave) {
    const Records here = chosen(tags, inGroup("octave " + std::to_string(octave)));
    if (here.empty()) {
      continue;
    }
    for (const std::string &method : methodsOf(here)) {
      const Summary own = summaryOf(chosen(here, byMethod(method)));
      const Summary s = summaryOf(chosen(commonImages(here), byMethod(method)));
      table.rows.push_back({octaveRanges()[octave - 1].name, method, common::percent(own.found, own.frames),
                            std::to_string(own.wrong), std::to_string(s.frames), digits(s.rms[X]), digits(s.rms[Y]),
                            digits(s.rms[Z]), digits(s.rotation), ratio(s.ratio[X]), ratio(s.ratio[Y]),
                            ratio(s.ratio[Z]), ratio(s.ratio[NORMAL])});
    }
  }
  return table;
}

/*! Columns on a terminal: a character of more than one byte takes one place. */
std::size_t width(const std::string &text)
{
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char letter) { return (letter & 0xC0) != 0x80; }));
}
} // namespace

std::vector<Table> tablesOf(const Records &records)
{
  std::vector<Table> tables;
  const Records limits = chosen(records, inPart("limits"));
  if (!limits.empty()) {
    for (const char *family : families) {
      tables.push_back(limitTable(limits, family));
    }
    tables.push_back(wholeTable(limits));
    tables.push_back(distanceTable(limits));
    tables.push_back(calibrationTable(limits));
  }
  const Records model = chosen(records, inPart("model"));
  if (!model.empty()) {
    tables.push_back(modelTable(model));
  }
  const Records cells = chosen(records, inPart("cells"));
  if (!cells.empty()) {
    tables.push_back(cellTable(cells));
  }
  const Records tags = chosen(records, inPart("apriltag"));
  if (!tags.empty()) {
    tables.push_back(tagTable(tags));
  }
  return tables;
}

Table missesOf(const std::vector<Check> &checks)
{
  const auto met = std::count_if(checks.begin(), checks.end(), [](const Check &check) { return check.isMet(); });
  Table table = {"Targets: " + std::to_string(met) + " of " + std::to_string(checks.size()) + " are met; these are not",
                 {"target", "where", "measured", "+-", "asked for", "images", "beyond chance"},
                 {}};
  for (const Check &check : checks) {
    if (!check.isMet()) {
      std::ostringstream asked;
      if (!std::isfinite(check.most)) {
        asked << "at least " << check.least;
      }
      else if (std::isfinite(check.least)) {
        asked << check.least << " to " << check.most;
      }
      else {
        asked << "at most " << check.most;
      }
      table.rows.push_back({check.target, check.where, format("%.3g", check.value), format("%.2g", check.error),
                            asked.str(), std::to_string(check.frames), check.isClear() ? "yes" : ""});
    }
  }
  return table;
}

std::string textOf(const Table &table)
{
  std::vector<std::size_t> widths;
  for (const std::string &title : table.titles) {
    widths.push_back(width(title));
  }
  for (const auto &row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], width(row[i]));
    }
  }
  std::string text = table.caption + "\n";
  const auto addLine = [&](const std::vector<std::string> &cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::string space(widths[i] - width(cells[i]) + (i == 0 ? 0 : 2), ' ');
      text += i == 0 ? cells[i] + space : space + cells[i];
    }
    text += "\n";
  };
  addLine(table.titles);
  for (const auto &row : table.rows) {
    addLine(row);
  }
  return text;
}
} // namespace accuracy
