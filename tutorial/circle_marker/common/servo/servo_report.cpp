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
 * What a servo leaves: table and pictures.
 */

#include "servo_report.h"

#include <filesystem>
#include <iomanip>
#include <sstream>

#include <visp3/core/vpImageConvert.h>
#include <visp3/io/vpImageIo.h>

#include "../draw.h"
#include "../whole_file.h"

namespace tutorial {
namespace {
void drawMarkers(vpImage<vpRGBa> &picture, const ServoStep &step, const ServoGoal &goal)
{
  const vpCameraParameters &cam = goal.camera.parameters;
  if (step.sighting.byCircle) {
    const MountedMarker &circle = *goal.object.circle;
    drawRing(picture, *step.sighting.byCircle * circle.oMm, cam, 0.5 * circle.size, vpColor::green, 2);
  }
  if (step.sighting.byAprilTag) {
    const MountedMarker &tag = *goal.object.aprilTag;
    drawSquare(picture, *step.sighting.byAprilTag * tag.oMm, cam, tag.size, vpColor::cyan, 2);
  }
}

std::string statusLine(const ServoStep &step)
{
  std::ostringstream text;
  text << "image " << step.iteration << "  used: " << step.sighting.usedDetector() << std::fixed;
  if (step.measured) {
    text << std::setprecision(2) << "  to go: " << 1e3 * step.measured->distance() << " mm" << std::setprecision(3)
         << "  " << step.measured->angle() * 180. / M_PI << " deg";
  }
  return text.str();
}

void writeElements(std::ostream &out, const vpColVector &v)
{
  for (unsigned int i = 0; i < v.getRows(); ++i) {
    out << ',' << v[i];
  }
}

void writeError(std::ostream &out, const std::optional<ServoError> &error)
{
  if (!error) {
    out << std::string(9, ',');
    return;
  }
  writeElements(out, error->translation);
  writeElements(out, error->rotation);
  out << ',' << error->distance() << ',' << error->angle() * 180. / M_PI << ',' << error->object;
}
} // namespace

vpImage<vpRGBa> servoPicture(const vpImage<unsigned char> &I, const ServoStep &step, const ServoGoal &goal)
{
  vpImage<vpRGBa> picture;
  vpImageConvert::convert(I, picture);
  drawMarkers(picture, step, goal);
  // Pictures this wide are looked at scaled down.
  const unsigned int thickness = I.getWidth() > 1000 ? 2 : 1;
  constexpr double axis = 0.05; // metres: inside the marker at any distance
  drawAxes(picture, goal.cdMo, goal.camera.parameters, axis, vpColor::yellow, thickness);
  if (const auto &cMo = step.sighting.best()) {
    drawAxes(picture, *cMo, goal.camera.parameters, axis, vpColor::none, thickness + 1);
  }
  drawText(picture, statusLine(step), vpImagePoint(I.getHeight() - 30., 10.));
  return picture;
}

std::string servoTable(const std::vector<ServoStep> &steps)
{
  std::ostringstream out;
  // Errors are those of cdMc: where the camera is in the desired camera's frame.
  out << "iteration,time_s,found,detector,circle_covered,apriltag_covered";
  for (const std::string kind : {"measured", "true"}) {
    for (const std::string field :
         {"tx_m", "ty_m", "tz_m", "tux_rad", "tuy_rad", "tuz_rad", "distance_m", "angle_deg", "object_m"}) {
      out << ',' << kind << '_' << field;
    }
  }
  out << ",vx_m_s,vy_m_s,vz_m_s,wx_rad_s,wy_rad_s,wz_rad_s,object_distance_m\n" << std::setprecision(9);
  for (const ServoStep &step : steps) {
    const ObjectSighting &sighting = step.sighting;
    out << step.iteration << ',' << step.time << ',' << sighting.best().has_value() << ',' << sighting.usedDetector()
        << ',' << step.covers.circle << ',' << step.covers.aprilTag;
    writeError(out, step.measured);
    writeError(out, step.trueError);
    writeElements(out, step.velocity);
    out << ',';
    if (const auto &cMo = step.cMo ? step.cMo : sighting.best()) {
      out << cMo->getTranslationVector().frobeniusNorm();
    }
    out << '\n';
  }
  return out.str();
}

void prepareReport(const std::string &folder)
{
  makeFolder(folder, "--output");
}

void writeReport(const std::string &folder, const ServoGoal &goal, const ServoRecord &record)
{
  const std::filesystem::path path(folder);
  writeWholeText((path / "servo.csv").string(), servoTable(record.steps));
  for (const Snapshot &snapshot : record.snapshots) {
    const vpImage<vpRGBa> picture = servoPicture(snapshot.image, snapshot.step, goal);
    writeWhole((path / ("overlay-" + snapshot.name + ".png")).string(),
               [&picture](const std::string &temporary) { vpImageIo::write(picture, temporary); });
  }
  if (!record.steps.empty()) {
    writePlot((path / "servo.svg").string(), record.steps, goal);
  }
}
} // namespace tutorial
