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

#ifndef VP_SIMULATOR_CONTROLS_H
#define VP_SIMULATOR_CONTROLS_H

#include <string>
#include <vector>

#include <visp3/core/vpHomogeneousMatrix.h>

#include "common/visp_names.h"
#include "world.h"

namespace simulator {
/*! Everything that the user can change. */
struct Controls
{
  vpHomogeneousMatrix wMc;   //!< Pose of the camera in the room.
  vpHomogeneousMatrix start; //!< Where it was at first.
  Knobs knobs;
  double step = 0.1; //!< Of a key: metres; degrees are a hundred times as many.
  bool isServoing = false;
  bool showsHelp = false;
  bool isOver = false;
  unsigned int wantedShots = 0; //!< Pictures to be saved.
};

/*! \return Whether the key means something. */
bool pressKey(Controls &controls, char key);

/*!
  The mouse was dragged with a button held.
  \param controls : The camera that it moves.
  \param button : 1: turns the camera, so that what is under the pointer stays there; 2: shifts it to the sides.
  \param du : To the right, pixels.
  \param dv : Down, pixels.
  \param focal : Focal length, pixels.
*/
void drag(Controls &controls, int button, double du, double dv, double focal);

/*! The keys, one on each line. */
const std::vector<std::string> &keyHelp();
} // namespace simulator

#endif
