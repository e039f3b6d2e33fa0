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
 * The plot of a servo, by gnuplot.
 */

#include <cstdio>
#include <memory>
#include <sstream>

#include <visp3/core/vpException.h>

#include "../whole_file.h"
#include "servo_report.h"

namespace tutorial {
namespace {
/*! One curve's points; "nan" breaks the curve where there is none. */
std::string points(const std::vector<ServoStep> &steps, const std::function<double(const ServoStep &)> &value)
{
  std::ostringstream out;
  for (const ServoStep &step : steps) {
    out << step.time << ' ' << value(step) << '\n';
  }
  return out.str();
}

std::string block(const std::string &name, const std::string &lines)
{
  return "$" + name + " << EOD\n" + lines + "EOD\n";
}

double valueOr(const std::optional<ServoError> &error, double (ServoError::*value)() const)
{
  return error ? ((*error).*value)() : NAN;
}

std::string dataBlocks(const std::vector<ServoStep> &steps)
{
  std::ostringstream out;
  out << block("distance",
               points(steps, [](const ServoStep &s) { return 1e3 * valueOr(s.trueError, &ServoError::distance); }))
      << block("angle",
               points(steps, [](const ServoStep &s) { return valueOr(s.trueError, &ServoError::angle) * 180. / M_PI; }))
      << block("seenDistance",
               points(steps, [](const ServoStep &s) { return 1e3 * valueOr(s.measured, &ServoError::distance); }))
      << block("seenAngle",
               points(steps, [](const ServoStep &s) { return valueOr(s.measured, &ServoError::angle) * 180. / M_PI; }));
  const auto seen = [](bool isSeen, double height) { return isSeen ? height : NAN; };
  out << block("circle", points(steps, [&](const ServoStep &s) { return seen(s.sighting.byCircle.has_value(), 2.); }))
      << block("tag", points(steps, [&](const ServoStep &s) { return seen(s.sighting.byAprilTag.has_value(), 1.); }));
  for (unsigned int axis = 0; axis < 6; ++axis) {
    out << block("v" + std::to_string(axis), points(steps, [axis](const ServoStep &s) { return s.velocity[axis]; }));
  }
  return out.str();
}

std::string commands(const std::string &path, const std::vector<ServoStep> &steps, const ServoGoal &goal)
{
  std::ostringstream out;
  out << "set terminal svg size 900,1000 enhanced background 'white' font 'sans,13'\n"
      << "set output '" << path << "'\nset datafile missing 'nan'\n"
      << dataBlocks(steps)
      << "set multiplot layout 4,1\nset grid\nset key outside right top\nset lmargin 12\nset rmargin 26\n"
      << "set xrange [0:" << steps.back().time + samplingTime << "]\n"
      << "set logscale y\nset format y '10^{%T}'\nset ylabel 'distance to go [mm]'\n"
      << "plot $seenDistance w p pt 7 ps 0.3 lc rgb '#e69f00' t 'measured', $distance w l lw 2 lc rgb '#0072b2' t "
         "'true', "
      << 1e3 * goal.acceptedDistance << " w l dt 2 lc rgb '#555555' t 'accepted at the end'\n"
      << "set ylabel 'angle to go [deg]'\n"
      << "plot $seenAngle w p pt 7 ps 0.3 lc rgb '#e69f00' t 'measured', $angle w l lw 2 lc rgb '#0072b2' t 'true', "
      << goal.acceptedAngle * 180. / M_PI << " w l dt 2 lc rgb '#555555' t 'accepted at the end'\n"
      << "unset logscale y\nset format y '%g'\nset ylabel 'velocity [m/s, rad/s]'\nplot ";
  const char *names[] = {"v_x", "v_y", "v_z", "{/Symbol w}_x", "{/Symbol w}_y", "{/Symbol w}_z"};
  const char *colors[] = {"#d55e00", "#009e73", "#0072b2", "#d55e00", "#009e73", "#0072b2"};
  for (int axis = 0; axis < 6; ++axis) {
    out << (axis > 0 ? ", " : "") << "$v" << axis << " w l lw 1.5 dt " << (axis < 3 ? 1 : 2) << " lc rgb '"
        << colors[axis] << "' t '" << names[axis] << "'";
  }
  out << "\nset ylabel 'used'\nset xlabel 'time [s]'\nset yrange [0.5:2.5]\nset ytics ('AprilTag' 1, 'circle' 2)\n"
      << "plot $circle w p pt 5 ps 0.5 lc rgb '#009e73' notitle, $tag w p pt 5 ps 0.5 lc rgb '#56b4e9' notitle\n"
      << "unset multiplot\nunset output\n";
  return out.str();
}

/*! \return Whether gnuplot ran these commands without an error. */
bool gnuplot(const std::string &script)
{
  FILE *pipe = popen("gnuplot 2>/dev/null", "w");
  if (pipe == nullptr) {
    return false;
  }
  const bool isWritten = std::fwrite(script.data(), 1, script.size(), pipe) == script.size();
  return pclose(pipe) == 0 && isWritten;
}

bool hasGnuplot()
{
  return std::system("gnuplot --version >/dev/null 2>&1") == 0;
}
} // namespace

void writePlot(const std::string &path, const std::vector<ServoStep> &steps, const ServoGoal &goal)
{
  writeWhole(path, [&steps, &goal](const std::string &temporary) {
    if (temporary.find('\'') != std::string::npos) {
      throw vpException(vpException::ioError, "gnuplot does not take an apostrophe in a path");
    }
    if (!gnuplot(commands(temporary, steps, goal))) {
      throw vpException(vpException::ioError, hasGnuplot() ? "gnuplot failed"
                                                           : "gnuplot, which draws it, cannot be run; install it "
                                                             "(Debian: apt-get install gnuplot-nox)");
    }
  });
}
} // namespace tutorial
