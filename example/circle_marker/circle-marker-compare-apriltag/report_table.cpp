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
 * The statistics as a table for people.
 */

#include <algorithm>
#include <iomanip>
#include <sstream>

#include "common/numbers.h"
#include "report.h"

namespace compare {
namespace {
constexpr int nameWidth = 22;
constexpr int tripleWidth = 17; // "0.012 0.123 12345"
constexpr int shortWidth = 6;

std::string triple(const Statistics &statistics)
{
  std::ostringstream out;
  out << std::setw(5) << digits(statistics.mean) << ' ' << std::setw(5) << digits(statistics.median) << ' '
      << std::setw(5) << digits(statistics.p95);
  return out.str();
}

/*! One line of columns, after the name. */
class Line
{
public:
  explicit Line(const std::string &name) { m_out << "  " << std::left << std::setw(nameWidth) << name << std::right; }

  Line &add(const std::string &text, int width)
  {
    m_out << "  " << std::setw(width) << text;
    return *this;
  }

  std::string text() const { return m_out.str() + "\n"; }

private:
  std::ostringstream m_out; //!< The line so far.
};

Line &addErrorTitles(Line &line)
{
  return line.add("|C-eC| mm", tripleWidth)
      .add("|dz| mm", tripleWidth)
      .add("normal deg", tripleWidth)
      .add("rotation deg", tripleWidth)
      .add("wrong", shortWidth);
}

Line &addErrors(Line &line, const ErrorSummary &errors)
{
  return line.add(triple(errors.position), tripleWidth)
      .add(triple(errors.z), tripleWidth)
      .add(triple(errors.normal), tripleWidth)
      .add(triple(errors.rotation), tripleWidth)
      .add(percent(errors.wrongSolutions, errors.frames), shortWidth);
}

std::string ownTable(const CellSummary &cell)
{
  Line title("frames each found");
  std::string text = addErrorTitles(title).add("found", shortWidth).text();
  for (std::size_t i = 0; i < methodCount; ++i) {
    const MethodSummary &method = cell.methods[i];
    Line line(methodNames[i]);
    text += addErrors(line, method.own).add(percent(method.found, cell.frames), shortWidth).text();
  }
  return text;
}

std::string commonTable(const CellSummary &cell)
{
  Line title(std::to_string(cell.common) + " frames all found");
  std::string text = addErrorTitles(title).text();
  for (std::size_t i = 0; i < methodCount; ++i) {
    Line line(methodNames[i]);
    text += addErrors(line, cell.methods[i].common).text();
  }
  return text;
}

std::string rootMeanSquareTable(const CellSummary &cell)
{
  constexpr int width = 10;
  Line title("RMS, frames all found");
  std::string text = title.add("x mm", width)
                         .add("y mm", width)
                         .add("z mm", width)
                         .add("rot. deg", width)
                         .add("CPU ms mean", 13)
                         .add("95 %", width)
                         .add("false", width)
                         .text();
  for (std::size_t i = 0; i < methodCount; ++i) {
    const MethodSummary &method = cell.methods[i];
    Line line(methodNames[i]);
    text += line.add(digits(method.common.x.rms), width)
                .add(digits(method.common.y.rms), width)
                .add(digits(method.common.z.rms), width)
                .add(digits(method.common.rotation.rms), width)
                .add(digits(method.cpuTime.mean), 13)
                .add(digits(method.cpuTime.p95), width)
                .add(std::to_string(method.wrongIds), width)
                .text();
  }
  const Ratios ratios = circleOver(Method::AprilTag1HalfPixel, cell);
  Line line("circle / apriltag-1-hp");
  return text + line.add(digits(ratios.x), width)
                    .add(digits(ratios.y), width)
                    .add(digits(ratios.z), width)
                    .add(digits(ratios.rotation), width)
                    .text();
}
} // namespace

std::string tableOf(const Settings &settings, const Summary &summary)
{
  std::ostringstream out;
  out << "Circle (" << circleFamily << ", ring " << 1000. * settings.size << " mm) against AprilTag (" << tagFamily
      << ", black square " << 1000. * settings.tagSize() << " mm), each on a sheet of " << 1000. * settings.sheetSide()
      << " mm.\nSame poses, camera " << imageWidth << " x " << imageHeight << " with f " << focalLength << " px, noise "
      << settings.noise << ", blur " << settings.blur << " px, seed " << settings.seed << ".\nAprilTag by ViSP "
      << vispVersion() << ", decimation 1 and 2, pose by " << settings.tagPose
      << "; half-pixel: with the principal\npoint moved by 0.5 px to AprilTag's image origin.\n"
      << "Errors are mean, median and 95 %; wrong: % of mirrored solutions; found: % of all frames; false: markers\n"
         "reported that are not there, CPU time: over all frames.\n";
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    out << "\nTilt to " << cells[cell].maxTilt << " deg, depth " << minDistance << " to " << cells[cell].maxDistance
        << " m, " << summary[cell].frames << " frames\n"
        << ownTable(summary[cell]) << commonTable(summary[cell]) << rootMeanSquareTable(summary[cell]);
  }
  return out.str();
}
} // namespace compare
