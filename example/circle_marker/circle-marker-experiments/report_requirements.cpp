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
 * The section of the report on the thesis's requirements: one row each, with what was measured.
 */

#include <algorithm>
#include <cmath>

#include <visp3/circle_marker/vpCircleMarkerFamily.h>

#include "common/numbers.h"
#include "report.h"
#include "summary.h"

namespace experiments {
namespace {
/*! The circular marker's summaries, by the names of the series. */
class Measured
{
public:
  Measured(const Experiment &experiment, const RunData &data) : m_experiment(experiment), m_data(data) {}

  Summary of(const std::string &series, Method method = Method::Circle) const
  {
    for (std::size_t i = 0; i < m_data.size(); ++i) {
      if (m_experiment.series[i].name == series) {
        return summaryOf(samplesOf(m_data[i], method), Solutions::First);
      }
    }
    return Summary();
  }

  std::string rate(const std::string &series, Method method = Method::Circle) const
  {
    const Summary summary = of(series, method);
    return percent(summary.found, summary.frames) + " %";
  }

private:
  const Experiment &m_experiment; //!< Names of the series.
  const RunData &m_data;          //!< Their samples.
};

std::string ratesAt(const Measured &measured, const std::string &depth, Method method)
{
  std::string text;
  for (const std::string degrees : {"0", "30", "45", "60"}) {
    text += (text.empty() ? "" : ", ") + measured.rate(depth + "-" + degrees, method) + " at " + degrees + "°";
  }
  return text;
}

std::string errorsAt(const Measured &measured, const std::string &depth)
{
  std::string text;
  for (const std::string degrees : {"0", "30", "45", "60"}) {
    const Summary summary = measured.of(depth + "-" + degrees);
    text += (text.empty() ? "" : "; ") + digits(summary.position.median) + " mm, " + digits(summary.angle.median) +
            "° at " + degrees + "°";
  }
  return text;
}

std::string foundAndErrors(const Summary &s)
{
  return percent(s.found, s.frames) + " % found (" + std::to_string(s.found) + " of " + std::to_string(s.frames) +
         "), median errors " + digits(s.position.median) + " mm and " + digits(s.angle.median) + "°, " +
         std::to_string(s.wrong) + " misleading";
}

/*! Markers that are not there, reported in images with a marker. */
std::size_t falseMarkersBeside(const Experiment &experiment, const RunData &data)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < experiment.series.size(); ++i) {
    if (experiment.series[i].name != "clutter") {
      count += summaryOf(samplesOf(data[i], Method::Circle), Solutions::First).falseMarkers;
    }
  }
  return count;
}

std::string sigmasOf(const Summary &s)
{
  return "σ x " + digits(s.offset[0].sigma) + ", y " + digits(s.offset[1].sigma) + ", z " + digits(s.offset[2].sigma) +
         " mm; angle " + digits(s.angle.rms) + "° root-mean-square";
}

std::string timesOf(const Summary &s)
{
  return "mean " + digits(s.cpuTime.mean) + " ms, σ " + digits(s.cpuTime.sigma) + ", 95 % below " +
         digits(s.cpuTime.p95) + ", greatest " + digits(s.cpuTime.most) + " ms";
}
} // namespace

void addRequirements(const Experiment &experiment, const RunData &data, Document &document)
{
  const Measured measured(experiment, data);
  const vpCircleMarkerFamily family = vpCircleMarkerFamily::fromName(codedFamily);
  const Summary still = measured.of("still");
  const Summary moving = measured.of("moving");
  const Summary clutter = measured.of("clutter");
  const Summary shutter = measured.of("shutter");
  std::vector<std::vector<std::string>> rows = {
      {"Pose", "centre, then normal, in the camera frame", "both, with the spin about the normal and a covariance"},
      {"Number of markers", "one for a pose", "one"},
      {"Detection range", "1 m to 20 m: image of the marker (sheet) 17 pixels",
       "found and identified at 20 m: " + ratesAt(measured, "20m", Method::Circle) +
           "; a plain ring found: " + ratesAt(measured, "20m", Method::Ring)},
      {"Registration and pose range", "1 m to 10 m: image of the marker (sheet) 34 pixels",
       "found and identified at 10 m: " + ratesAt(measured, "10m", Method::Circle) +
           "; median errors: " + errorsAt(measured, "10m")},
      {"Viewing angle", "to 60°", measured.rate("10m-60") + " at 10 m, " + measured.rate("20m-60") + " at 20 m"},
      {"Occlusion", "some resilience against partial occlusion",
       "a tenth of the ring's disc covered: " + foundAndErrors(measured.of("covered")) +
           "; more in the experiment on resilience"},
      {"Light and colour", "black and white print; changes of light borne",
       "black and white; a quarter of the light: " + foundAndErrors(measured.of("dim")) +
           "; the edge of a shadow of half the light across the marker: " + foundAndErrors(measured.of("shadow"))},
      {"False positives", "negligible",
       std::to_string(clutter.falseMarkers) + " in " + std::to_string(clutter.frames) +
           " pictures of clutter; with a marker in the image: " + std::to_string(falseMarkersBeside(experiment, data))},
      {"False negatives", "negligible",
       "found in the range asked for, 1 m to 10 m and to 60°: " + foundAndErrors(measured.of("range"))},
      {"Payload", "fewer than a hundred ids and error correction",
       std::to_string(family.getNbIds()) + " ids, minimum distance " + std::to_string(family.getMinimumDistance()) +
           " of " + std::to_string(family.getNbSectors()) + " sectors"},
      {"Marker", "flat, prints on A4: a square of 210 mm", "a ring of 180 mm on a square of 210 mm"},
      {"Shutter time", "1 ms or less on a moving vehicle",
       percent(shutter.found, shutter.frames) + " % found at 5 m/s and 1 rad/s, 3 m to 10 m, to 60°; median errors " +
           digits(shutter.position.median) + " mm, " + digits(shutter.angle.median) + "°"},
      {"Speed", "reasonably responsive (thesis: 2.2 frames a second)",
       timesOf(moving) + " of one core: " + digits(1000. / moving.cpuTime.mean) + " frames a second"},
      {"Jitter, still", "consistent", sigmasOf(still) + "; time: " + timesOf(still)},
      {"Jitter, moving", "consistent", sigmasOf(moving) + "; time: " + timesOf(moving)}};
  document.addHeading(experiment.title);
  document.addParagraph("Each requirement of the thesis's section 2.2.1 with what was measured of the circular marker "
                        "(golay23) in " +
                        std::to_string(still.frames) +
                        " frames each. In the jitter of the moving sequence the error "
                        "of each frame counts, whose size changes with the distance.");
  document.addTable("Requirements", {"requirement", "thesis", "measured"}, rows);
  addFigures(figuresOfRequirements(experiment, data), document);
}
} // namespace experiments
