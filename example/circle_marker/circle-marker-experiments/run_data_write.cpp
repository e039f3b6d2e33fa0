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
 * The table of an experiment's samples: writing.
 */

#include <iomanip>
#include <sstream>

#include "common/reference_camera.h"
#include "run_data.h"
#include "run_header.h"

namespace experiments {
namespace {
constexpr int digitsOfTruth = 9; // Micrometres at 20 m and less.
constexpr int digitsOfErrors = 6;

void addDeviation(std::ostream &out, const std::optional<Deviation> &deviation)
{
  if (deviation) {
    out << deviation->dx << ',' << deviation->dy << ',' << deviation->dz << ',' << deviation->normal << ',';
  }
  else {
    out << ",,,,";
  }
}

void addRow(std::ostream &out, const Series &series, std::size_t frame, const Sample &sample)
{
  out << series.name << ',' << frame << ',' << nameOf(sample.method) << ',' << std::setprecision(digitsOfTruth)
      << sample.x << ',' << sample.y << ',' << sample.z << ',' << sample.angle << ','
      << std::setprecision(digitsOfErrors) << sample.outlines << ',' << sample.markers << ',';
  addDeviation(out, sample.first);
  addDeviation(out, sample.second);
  if (sample.first) {
    out << sample.rotation << ',' << (sample.isMirrored ? 1 : 0) << ',';
  }
  else {
    out << ",,";
  }
  if (sample.second) {
    out << sample.logOdds;
  }
  out << ',';
  if (sample.reading > 0.) {
    out << sample.reading;
  }
  out << ',' << sample.cpuTime << '\n';
}
} // namespace

std::string dataFileOf(const Experiment &experiment)
{
  return experiment.name + ".csv";
}

RunData emptyData(const Experiment &experiment)
{
  RunData data;
  for (const Series &series : experiment.series) {
    data.emplace_back(series.frames);
  }
  return data;
}

std::size_t framesDone(const RunData &data)
{
  std::size_t count = 0;
  for (const auto &series : data) {
    for (const auto &frame : series) {
      count += frame ? 1 : 0;
    }
  }
  return count;
}

std::string csvOf(const Experiment &experiment, const Settings &settings, const RunData &data)
{
  std::ostringstream out;
  out << "# circle-marker-experiments: " << experiment.title << ", one row for each frame and method\n";
  for (const HeaderLine &line : headerOf(settings)) {
    out << "# " << line.key << ": " << line.value << "\n";
  }
  const vpCameraParameters cam = referenceCamera();
  out << "# camera: " << imageWidth << " x " << imageHeight << ", px " << cam.get_px() << ", py " << cam.get_py()
      << ", u0 " << cam.get_u0() << ", v0 " << cam.get_v0() << "; paper 220, ink 30, ground 110\n"
      << "# x_m, y_m, z_m: true centre in the camera frame; angle_deg: between normal and line of sight\n"
      << "# outlines: ellipses looked at; markers: reported, of any id\n"
      << "# d: estimated minus true centre; 2: the other solution; mirrored: nearer to the true normal's mirror image\n"
      << "# reading_sigma: distance of the image from that of the marker most like it, in deviations of the noise\n"
      << "series,frame,method,x_m,y_m,z_m,angle_deg,outlines,markers,dx_mm,dy_mm,dz_mm,normal_deg,dx2_mm,dy2_mm,dz2_mm,"
         "normal2_deg,rotation_deg,mirrored,log_odds,reading_sigma,cpu_ms\n";
  for (std::size_t i = 0; i < experiment.series.size(); ++i) {
    for (std::size_t frame = 0; frame < data[i].size(); ++frame) {
      if (data[i][frame]) {
        for (const Sample &sample : *data[i][frame]) {
          addRow(out, experiment.series[i], frame, sample);
        }
      }
    }
  }
  return out.str();
}
} // namespace experiments
