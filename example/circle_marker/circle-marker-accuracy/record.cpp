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
 * One measurement: its row in a CSV file.
 */

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <map>
#include <sstream>
#include <stdexcept>

#include "common/csv.h"
#include "record.h"

namespace accuracy {
namespace {
struct TextColumn
{
  const char *name;
  std::string Record::*value;
};

struct NumberColumn
{
  const char *name;
  double Record::*value;
};

constexpr TextColumn textColumns[] = {{"part", &Record::part}, {"group", &Record::group}, {"method", &Record::method}};

constexpr NumberColumn numberColumns[] = {
    {"frame", &Record::frame},
    {"id", &Record::id},
    {"distance_m", &Record::distance},
    {"diameter_px", &Record::diameter},
    {"minor_axis_px", &Record::minor},
    {"tilt_deg", &Record::tilt},
    {"noise", &Record::noise},
    {"blur_px", &Record::blur},
    {"contrast", &Record::contrast},
    {"found", &Record::found},
    {"wrong", &Record::wrong},
    {"x_mm", &Record::x},
    {"y_mm", &Record::y},
    {"z_mm", &Record::z},
    {"normal_deg", &Record::normal},
    {"lean_deg", &Record::lean},
    {"rotation_deg", &Record::rotation},
    {"dof", &Record::dof},
    {"mahalanobis2", &Record::mahalanobis},
    {"reported_x_mm", &Record::reportedX},
    {"reported_y_mm", &Record::reportedY},
    {"reported_z_mm", &Record::reportedZ},
    {"reported_normal_deg", &Record::reportedNormal},
    {"bound_x_mm", &Record::boundX},
    {"bound_y_mm", &Record::boundY},
    {"bound_z_mm", &Record::boundZ},
    {"bound_normal_deg", &Record::boundNormal},
    {"bound_rotation_deg", &Record::boundRotation},
    {"log_odds", &Record::logOdds},
    {"separation", &Record::separation},
    {"predicted_wrong", &Record::predicted},
    {"cpu_ms", &Record::milliseconds},
};

std::ifstream opened(const std::string &file)
{
  std::ifstream stream(file);
  if (!stream) {
    throw std::runtime_error("cannot read \"" + file + "\"; name a folder with results of this program (--from)");
  }
  return stream;
}

void set(Record &record, const std::string &name, const std::string &field, const std::string &file)
{
  for (const TextColumn &column : textColumns) {
    if (name == column.name) {
      record.*column.value = field;
      return;
    }
  }
  for (const NumberColumn &column : numberColumns) {
    if (name == column.name) {
      // Not std::stod, which refuses the smallest numbers.
      char *end = nullptr;
      record.*column.value = field.empty() ? none : std::strtod(field.c_str(), &end);
      const std::size_t used = field.empty() ? 0 : static_cast<std::size_t>(end - field.c_str());
      if (used != field.size()) {
        throw std::runtime_error("\"" + file + "\" has \"" + field + "\" for " + name +
                                 ", which is no number; make the results anew");
      }
      return;
    }
  }
}
} // namespace

std::string csvOf(const std::vector<std::string> &comments, const std::vector<Record> &records)
{
  std::ostringstream out;
  for (const std::string &comment : comments) {
    out << "# " << comment << '\n';
  }
  std::string separator;
  for (const TextColumn &column : textColumns) {
    out << separator << column.name;
    separator = ",";
  }
  for (const NumberColumn &column : numberColumns) {
    out << separator << column.name;
  }
  // As many digits as that a page made from the file rounds to the same figures.
  out << '\n' << std::setprecision(12);
  for (const Record &record : records) {
    separator.clear();
    for (const TextColumn &column : textColumns) {
      out << separator << record.*column.value;
      separator = ",";
    }
    for (const NumberColumn &column : numberColumns) {
      out << separator;
      const double value = record.*column.value;
      if (std::isinf(value)) {
        out << (value > 0. ? "inf" : "-inf"); // As std::strtod reads it.
      }
      else if (!std::isnan(value)) {
        out << value;
      }
    }
    out << '\n';
  }
  return out.str();
}

std::vector<Record> readCsv(const std::string &file)
{
  std::ifstream stream = opened(file);
  std::vector<std::string> names;
  std::vector<Record> records;
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind('#', 0) == 0) {
      continue;
    }
    const std::vector<std::string> fields = common::fieldsOf(line);
    if (names.empty()) {
      names = fields;
      continue;
    }
    if (fields.size() != names.size()) {
      throw std::runtime_error("\"" + file + "\" has a row of " + std::to_string(fields.size()) + " fields under " +
                               std::to_string(names.size()) + " names; make the results anew");
    }
    Record record;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      set(record, names[i], fields[i], file);
    }
    records.push_back(record);
  }
  return records;
}

std::vector<std::string> readComments(const std::string &file)
{
  std::ifstream stream = opened(file);
  std::vector<std::string> comments;
  for (std::string line; std::getline(stream, line) && line.rfind("# ", 0) == 0;) {
    comments.push_back(line.substr(2));
  }
  return comments;
}
} // namespace accuracy
