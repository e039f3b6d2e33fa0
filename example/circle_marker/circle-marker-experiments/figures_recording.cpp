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
 * Figures of a recording: the thesis's figures 5.2 and 5.3.
 */

#include <functional>
#include <sstream>

#include "report_recording.h"
#include "station_figures.h"

namespace experiments {
namespace {
constexpr std::size_t mostPoints = 200; // Of a panel: enough to show its shape.
constexpr double ellipseSize = 2.;      // Standard deviations.
constexpr double micrometres = 1e3;     // In a millimetre.
constexpr double metres = 1e-3;         // In a millimetre.

/*! Points of every so manyeth image with the marker. */
Curve cloudOf(const Station &station, const std::string &title,
              const std::function<std::array<double, 2>(const Sight &)> &point)
{
  Curve curve = {title, "with points linestyle 11", {}};
  const std::size_t step = (station.pictures.size() + mostPoints - 1) / mostPoints;
  for (std::size_t i = 0; i < station.pictures.size(); i += step) {
    if (station.pictures[i].sight) {
      curve.points.push_back(point(*station.pictures[i].sight));
    }
  }
  return curve;
}

Curve ellipse(const std::string &title, const std::string &style, const Square &covariance, std::size_t across)
{
  Curve curve = {title, style, {}};
  for (const auto &point : ellipseOf(covariance, across, 2, ellipseSize)) {
    curve.points.push_back({micrometres * point[0], micrometres * point[1]});
  }
  return curve;
}

Panel stationPanel(const Station &station)
{
  const StationFigures f = figuresOf(station);
  std::ostringstream title;
  title << *station.distance << " m";
  Panel panel = {title.str(), "x - mean [µm]", "z - mean [µm]", "", {}};
  panel.curves.push_back(cloudOf(station, "estimates eC", [&f](const Sight &sight) {
    return std::array<double, 2>{micrometres * (sight.centre[0] - f.mean[0]),
                                 micrometres * (sight.centre[2] - f.mean[2])};
  }));
  if (f.found > 1) {
    panel.curves.push_back(ellipse("their covariance, 2σ", "with lines linestyle 1", f.covariance, 0));
    panel.curves.push_back(
        ellipse("covariance that the detector states, 2σ", "with lines linestyle 2 dashtype 2", f.stated, 0));
  }
  return panel;
}

Panel slidePanel(const Station &station)
{
  const SlideLine line = lineOf(station);
  Panel panel = {station.name, "z [m]", "distance from the straight line [µm]", "set yrange [0:*]\n", {}};
  panel.curves.push_back(cloudOf(station, "estimates eC", [&line](const Sight &sight) {
    return std::array<double, 2>{metres * sight.centre[2], micrometres * line.distanceOf(sight.centre)};
  }));
  return panel;
}
} // namespace

std::vector<CaptionedFigure> figuresOfRecording(const Recording &recording)
{
  Figure figure = {"experiment-1-clouds.svg", "Estimates of the centre at each place, seen from above", 3, {}};
  for (const Station &station : recording.stations) {
    if (station.distance) {
      figure.panels.push_back(stationPanel(station));
    }
    else if (figuresOf(station).found > 1) {
      figure.panels.push_back(slidePanel(station));
    }
  }
  return {{figure, "Thesis, figures 5.2 and 5.3: estimates at fixed places, and along the slide. There each place had "
                   "two clusters or four, metres apart. x and z have scales of their own."}};
}
} // namespace experiments
