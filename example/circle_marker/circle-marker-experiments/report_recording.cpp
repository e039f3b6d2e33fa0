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
 * The part of the report that is of a recording: the thesis's experiment 1.
 */

#include <cmath>
#include <cstdio>
#include <functional>
#include <sstream>

#include "common/numbers.h"
#include "report.h"
#include "report_recording.h"
#include "station_figures.h"

namespace experiments {
namespace {
/*! Table 5.3 of the thesis: distance in metres, markers in an image, mean in mm, covariance in mm^2. */
struct ThesisStation
{
  double distance, markers;
  Triple mean;
  Square covariance;
};

constexpr std::array<ThesisStation, 5> thesisStations = {
    {{1., 1.0, {-368, -280, 4}, {{{0.4, 0.2, 0.}, {0.2, 0.2, 0.}, {0., 0., 0.5}}}},
     {2., 1.0, {-743, -603, 8}, {{{627, 509.2, -6}, {509.2, 413.6, -4.9}, {-6, -4.9, 0.1}}}},
     {3., 1.2, {-1123, -913, 11}, {{{20560, 16820, -200}, {16820, 13760, -164}, {-200, -164, 2}}}},
     {4., 1.4, {-1557, -1073, 14}, {{{19500, 20110, -214}, {20110, 175700, -1075}, {-214, -1075, 7.1}}}},
     {5., 0.9, {-1923, -1554, 19}, {{{21710, 17540, -211}, {17540, 14170, -170}, {-211, -170, 2.1}}}}}};

/*! Two digits, with an exponent where it is shorter: variances reach over ten powers of ten. */
std::string shortNumber(double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.2g", value);
  return text;
}

std::string fixedNumber(double value, int decimals)
{
  char text[64];
  const double half = 0.5 * std::pow(10., -decimals);
  std::snprintf(text, sizeof(text), "%.*f", decimals, std::fabs(value) < half ? 0. : value); // No "-0.000".
  return text;
}

std::string vectorOf(const Triple &v, int decimals)
{
  return "(" + fixedNumber(v[0], decimals) + ", " + fixedNumber(v[1], decimals) + ", " + fixedNumber(v[2], decimals) +
         ")";
}

std::string textOf(const Square &m, const std::function<std::string(double)> &numberText)
{
  std::string text = "[";
  for (std::size_t i = 0; i < 3; ++i) {
    text += i == 0 ? "" : "; ";
    for (std::size_t j = 0; j < 3; ++j) {
      text += (j == 0 ? "" : " ") + numberText(m[i][j]);
    }
  }
  return text + "]";
}

std::string titleOf(const Station &station)
{
  if (!station.distance) {
    return station.name;
  }
  std::ostringstream title;
  title << "(0, 0, " << 1000. * *station.distance << ")";
  return title.str();
}

const ThesisStation *thesisOf(const Station &station)
{
  for (const ThesisStation &thesis : thesisStations) {
    if (station.distance && std::fabs(*station.distance - thesis.distance) < 1e-9) {
      return &thesis;
    }
  }
  return nullptr;
}

/*! As the thesis writes them. */
std::string thesisNumber(double value)
{
  return fixedNumber(value, std::fabs(value) < 1000. && value != std::round(value) ? 1 : 0);
}

std::string sigmasOf(const Square &covariance)
{
  std::string text;
  for (std::size_t i = 0; i < 3; ++i) {
    text += (i == 0 ? "" : ", ") + shortNumber(std::sqrt(covariance[i][i]));
  }
  return text;
}

// What too few images, or none, tell.
const std::string unknown = "-";

double distanceBetween(const Triple &a, const Triple &b)
{
  return std::hypot(std::hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

void addMeans(const Recording &recording, Document &document)
{
  std::vector<std::vector<std::string>> rows;
  for (const Station &station : recording.stations) {
    const StationFigures f = figuresOf(station);
    const ThesisStation *thesis = thesisOf(station);
    rows.push_back({titleOf(station), std::to_string(f.frames), percent(f.found, f.frames), digits(f.markers),
                    !station.distance ? ""
                    : f.found > 0     ? vectorOf(f.mean, 3)
                                      : unknown,
                    !station.distance ? ""
                    : f.found > 1     ? textOf(f.covariance, shortNumber)
                                      : unknown,
                    thesis ? digits(thesis->markers) : "", thesis ? vectorOf(thesis->mean, 0) : "",
                    thesis ? textOf(thesis->covariance, thesisNumber) : ""});
  }
  document.addTable("Estimates of the centre, as table 5.3 of the thesis",
                    {"C, mm", "frames", "found, %", "markers a frame", "mean of eC, mm", "covariance of eC, mm²",
                     "thesis: ellipses a frame", "thesis: mean of eC, mm", "thesis: covariance of eC, mm²"},
                    rows);
}

void addSpreads(const Recording &recording, Document &document)
{
  std::vector<std::vector<std::string>> rows;
  std::optional<Triple> before;
  for (const Station &station : recording.stations) {
    const StationFigures f = figuresOf(station);
    if (!station.distance) {
      continue;
    }
    const bool isSeen = f.found > 0;
    const bool hasSpread = f.found > 1;
    rows.push_back({titleOf(station), hasSpread ? sigmasOf(f.covariance) : unknown,
                    isSeen ? sigmasOf(f.stated) : unknown, hasSpread ? digits(f.consistency) : unknown,
                    before && isSeen ? fixedNumber(distanceBetween(*before, f.mean), 3) : "",
                    isSeen ? digits(f.tilt) : unknown, hasSpread ? shortNumber(f.normalSpread) : unknown,
                    digits(f.cpuTime.mean) + ", " + digits(f.cpuTime.sigma), digits(1000. / f.cpuTime.mean)});
    before = isSeen ? std::make_optional(f.mean) : std::nullopt;
  }
  document.addTable("Spread, and whether the detector states it rightly",
                    {"C, mm", "σ of eC in x, y, z, mm", "stated by the detector, mm", "spread² over stated",
                     "from the station before, mm", "tilt, °", "spread of the normal, °", "CPU mean, σ, ms",
                     "frames a second of one core"},
                    rows);
}

void addSlides(const Recording &recording, Document &document)
{
  std::vector<std::vector<std::string>> rows;
  for (const Station &station : recording.stations) {
    const StationFigures f = figuresOf(station);
    if (station.distance || f.found < 2) {
      continue;
    }
    const SlideLine line = lineOf(station);
    rows.push_back({station.name, std::to_string(f.frames), percent(f.found, f.frames), digits(f.markers),
                    digits(line.nearest) + " to " + digits(line.farthest), digits(line.angle),
                    digits(line.distances.rms), digits(line.distances.most)});
  }
  if (!rows.empty()) {
    document.addTable("Slides: the straight line through the estimates",
                      {"", "frames", "found, %", "markers a frame", "depths, mm", "angle to the optical axis, °",
                       "distance from the line: root-mean-square, mm", "greatest, mm"},
                      rows);
  }
}
} // namespace

void addRecording(const Recording &recording, Document &document)
{
  std::ostringstream text;
  text << "Images of a camera that stands still, the marker at places along its optical axis and slid along it by "
       << "hand: " << recording.family;
  if (recording.id >= 0) {
    text << ", id " << recording.id;
  }
  text << ", " << 1000. * recording.size << " mm outer diameter. C is what the tape says, so the means tell how "
       << "marker, tape and optical axis were aligned; the covariance tells what the measurement adds. "
       << "The detector states a covariance with every pose: spread² over stated is the mean square Mahalanobis "
       << "distance of the estimates from their mean over its expectation, 1 where it is right. "
       << "The distance from the station before does not depend on where the tape begins.";
  document.addHeading("Experiment 1: a camera and a marker at 1 m to 5 m");
  document.addParagraph(text.str());
  addMeans(recording, document);
  addSpreads(recording, document);
  addSlides(recording, document);
  addFigures(figuresOfRecording(recording), document);
}

std::string csvOf(const Recording &recording)
{
  std::ostringstream out;
  out.precision(9);
  out << "# circle-marker-experiments: experiment 1, one row for each image\n# family: " << recording.family
      << "\n# id: " << recording.id << "\n# size_m: " << recording.size
      << "\n# x, y, z: estimated centre in the camera frame; n: estimated normal, toward the camera\n"
      << "station,frame,markers,x_mm,y_mm,z_mm,n_x,n_y,n_z,cpu_ms\n";
  for (const Station &station : recording.stations) {
    for (std::size_t frame = 0; frame < station.pictures.size(); ++frame) {
      const Picture &picture = station.pictures[frame];
      out << station.name << ',' << frame << ',' << picture.markers;
      for (std::size_t i = 0; i < 6; ++i) {
        out << ',';
        if (picture.sight) {
          out << (i < 3 ? picture.sight->centre[i] : picture.sight->normal[i - 3]);
        }
      }
      out << ',' << picture.cpuTime << '\n';
    }
  }
  return out.str();
}
} // namespace experiments
