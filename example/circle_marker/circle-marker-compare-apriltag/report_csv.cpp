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
 * The trials as CSV.
 */

#include <iomanip>
#include <sstream>

#include <visp3/core/vpMath.h>
#include <visp3/core/vpThetaUVector.h>

#include "report.h"

namespace compare {
namespace {
constexpr double millimetres = 1000.; // In a metre.

void addRow(std::ostream &out, const Trial &trial, std::size_t method)
{
  const Measurement &measurement = trial.measurements[method];
  const vpThetaUVector rotation(trial.cMo.getRotationMatrix());
  const bool isCircle = method == indexOf(Method::Circle);
  out << trial.cell + 1 << ',' << cells[trial.cell].maxTilt << ',' << cells[trial.cell].maxDistance << ','
      << trial.frame << ',' << methodNames[method] << ',' << (isCircle ? trial.circleId : trial.tagId) << ','
      << trial.cMo[0][3] << ',' << trial.cMo[1][3] << ',' << trial.cMo[2][3] << ',' << rotation[0] << ',' << rotation[1]
      << ',' << rotation[2] << ',' << distanceOf(trial.cMo) << ',' << vpMath::deg(tiltOf(trial.cMo)) << ','
      << (measurement.error ? 1 : 0) << ',' << measurement.wrongIds << ',';
  if (const auto &error = measurement.error) {
    out << millimetres * error->x << ',' << millimetres * error->y << ',' << millimetres * error->z << ','
        << millimetres * error->position << ',' << vpMath::deg(error->normal) << ',' << vpMath::deg(error->rotation)
        << ',' << (error->wrongSolution ? 1 : 0) << ',';
  }
  else {
    out << ",,,,,,,";
  }
  out << millimetres * measurement.cpuTime << '\n'; // Milliseconds.
}
} // namespace

std::string csvOf(const std::vector<Trial> &trials)
{
  std::ostringstream out;
  out << "cell,max_tilt_deg,max_depth_m,frame,method,id,x_m,y_m,z_m,tux_rad,tuy_rad,tuz_rad,distance_m,tilt_deg,found,"
         "wrong_ids,dx_mm,dy_mm,dz_mm,position_error_mm,normal_error_deg,rotation_error_deg,mirrored,cpu_ms\n";
  out << std::setprecision(9);
  for (const Trial &trial : trials) {
    for (std::size_t method = 0; method < methodCount; ++method) {
      addRow(out, trial, method);
    }
  }
  return out.str();
}
} // namespace compare
