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
 * What a servo leaves: table, plot and pictures.
 */

#ifndef VP_TUTORIAL_SERVO_REPORT_H
#define VP_TUTORIAL_SERVO_REPORT_H

#include <string>
#include <vector>

#include <visp3/core/vpImage.h>
#include <visp3/core/vpRGBa.h>

#include "../visp_names.h"
#include "servo_loop.h"

namespace tutorial {
/*!
  \return An image of the servo with what was seen in it: outlines of the markers, the measured frame in red, green and
  blue, the desired frame in yellow, and the errors.
*/
vpImage<vpRGBa> servoPicture(const vpImage<unsigned char> &I, const ServoStep &step, const ServoGoal &goal);

/*! \return The table of a servo: a line for each image. Empty fields: no marker was seen, or the
  truth is not known. */
std::string servoTable(const std::vector<ServoStep> &steps);

/*!
  Writes servo.csv, servo.svg and the overlay pictures into a folder.
  \exception vpException::ioError : If a file cannot be written, or gnuplot fails.
*/
void writeReport(const std::string &folder, const ServoGoal &goal, const ServoRecord &record);

/*!
  Plots the errors and velocities of a servo into an SVG file, with gnuplot.
  \exception vpException::ioError : If gnuplot is not installed or fails.
*/
void writePlot(const std::string &path, const std::vector<ServoStep> &steps, const ServoGoal &goal);

/*!
  Makes the folder of a report, before the work that it is about.
  \exception vpException::ioError : If that is not possible.
*/
void prepareReport(const std::string &folder);
} // namespace tutorial

#endif
