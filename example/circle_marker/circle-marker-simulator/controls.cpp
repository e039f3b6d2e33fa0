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
 * What keys and mouse do to the camera and its image.
 */

#include "controls.h"

#include <algorithm>
#include <cmath>

#include <visp3/core/vpThetaUVector.h>

namespace simulator {
namespace {
/*! Moves the camera in its own frame. */
void move(Controls &controls, double x, double y, double z)
{
  controls.wMc = controls.wMc * vpHomogeneousMatrix(vpTranslationVector(x, y, z), vpThetaUVector(0., 0., 0.));
}

/*! Turns the camera about its own axes, radians. */
void turn(Controls &controls, double x, double y, double z)
{
  controls.wMc = controls.wMc * vpHomogeneousMatrix(vpTranslationVector(0., 0., 0.), vpThetaUVector(x, y, z));
}

bool pressMoving(Controls &c, char key)
{
  const double way = c.step, angle = c.step; // 0.1 m and 0.1 rad look alike at a metre
  switch (key) {
  case 'w':
    move(c, 0., 0., way);
    return true;
  case 's':
    move(c, 0., 0., -way);
    return true;
  case 'a':
    move(c, -way, 0., 0.);
    return true;
  case 'd':
    move(c, way, 0., 0.);
    return true;
  case 'e':
    move(c, 0., -way, 0.);
    return true;
  case 'c':
    move(c, 0., way, 0.);
    return true;
  case 'j':
    turn(c, 0., -angle, 0.);
    return true;
  case 'l':
    turn(c, 0., angle, 0.);
    return true;
  case 'i':
    turn(c, angle, 0., 0.);
    return true;
  case 'k':
    turn(c, -angle, 0., 0.);
    return true;
  case 'u':
    turn(c, 0., 0., -angle);
    return true;
  case 'o':
    turn(c, 0., 0., angle);
    return true;
  case '+':
    c.step = std::min(1., 2. * c.step);
    return true;
  case '-':
    c.step = std::max(0.0125, 0.5 * c.step);
    return true;
  case '0':
    c.wMc = c.start;
    return true;
  default:
    return false;
  }
}

bool pressKnob(Knobs &knobs, char key)
{
  const auto change = [](double &value, double by, double least, double most) {
    value = std::min(most, std::max(least, value + by));
    return true;
  };
  switch (key) {
  case 'n':
    return change(knobs.noise, -1., 0., 30.);
  case 'N':
    return change(knobs.noise, 1., 0., 30.);
  case 'b':
    return change(knobs.blur, -0.2, 0.3, 5.);
  case 'B':
    return change(knobs.blur, 0.2, 0.3, 5.);
  case 'g':
    return change(knobs.light, -0.1, 0.1, 1.1);
  case 'G':
    return change(knobs.light, 0.1, 0.1, 1.1);
  case 'x':
    return change(knobs.gradient, -0.2, -1.6, 1.6);
  case 'X':
    return change(knobs.gradient, 0.2, -1.6, 1.6);
  case 'v':
    knobs.cover = std::max(0, knobs.cover - 1);
    return true;
  case 'V':
    knobs.cover = std::min(9, knobs.cover + 1);
    return true;
  default:
    return false;
  }
}
} // namespace

bool pressKey(Controls &controls, char key)
{
  if (pressMoving(controls, key) || pressKnob(controls.knobs, key)) {
    return true;
  }
  switch (key) {
  case 't':
    controls.isServoing = !controls.isServoing;
    return true;
  case 'h':
    controls.showsHelp = !controls.showsHelp;
    return true;
  case 'p':
    ++controls.wantedShots;
    return true;
  case 'q':
  case '\x1b':
    controls.isOver = true;
    return true;
  default:
    return false;
  }
}

void drag(Controls &controls, int button, double du, double dv, double focal)
{
  if (button == 1) {
    turn(controls, std::atan(dv / focal), -std::atan(du / focal), 0.);
  }
  else if (button == 2) {
    constexpr double depth = 1.5; // metres at which the scene follows the pointer
    move(controls, -depth * du / focal, -depth * dv / focal, 0.);
  }
}

const std::vector<std::string> &keyHelp()
{
  static const std::vector<std::string> lines{"w s: forward, back      a d: left, right     e c: up, down",
                                              "j l: turn left, right   i k: up, down        u o: roll",
                                              "+ -: length of steps    0: back to the start",
                                              "mouse: left drag turns, middle drag shifts, right click quits",
                                              "N n: noise   B b: blur   G g: light   X x: gradient   V v: cover",
                                              "t: servo to the nearest marker and stop",
                                              "p: save the picture     h: these lines       q, Escape: quit"};
  return lines;
}
} // namespace simulator
