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
 * Pose of a circle of known radius from its image, an ellipse.
 */

/*!
  \file vpPoseCircle.h
  \brief Pose of a circle of known radius from its image, an ellipse.
*/

#ifndef VP_POSE_CIRCLE_H
#define VP_POSE_CIRCLE_H

// To be completed by its author.

#endif
