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
 * Markers that are printed otherwise than by default, and rivals of another kind.
 */

#ifndef VP_EXPERIMENTS_DESIGN_H
#define VP_EXPERIMENTS_DESIGN_H

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <visp3/circle_marker/vpCircleMarkerFamily.h>
#include <visp3/circle_marker_simulator/vpSimulatedMarker.h>

#include "common/visp_names.h"
#include "settings.h"

namespace experiments {
/*! Rings and a code that no family has; radii over the outermost one. */
struct Composition
{
  std::vector<std::array<double, 2>> rings; //!< Inner and outer radius of each black ring.
  std::array<double, 2> track = {0., 0.};   //!< Of the code; none: 0.
  unsigned int sectors = 0;                 //!< Of the code; 0: none.
  unsigned int distance = 0;                //!< Least number of sectors in which two words of its code differ.
  bool isWindows = false;                   //!< Ones of the code are white windows in a black ring.
};

/*! A marker that is printed otherwise than by default, on a sheet of the settings' side. */
struct Design
{
  std::string family;                     //!< Of the circular markers, or 36h11; of no account with a composition.
  vpCircleMarkerLayout layout;            //!< Its quiet zone fills the sheet, whatever the kind of marker.
  std::optional<Composition> composition; //!< A rival that the detector cannot read.
};

/*! The same for the same design. */
std::string nameOf(const Design &design);

/*! Size of the marker that with the design's quiet zone fills the sheet, metres. */
double sizeOf(const Design &design, const Settings &settings);

/*! The id of a frame, -1 without. */
int idOf(const Design &design, std::uint64_t frameSeed);

/*! The marker of a frame; a composition's word is drawn from the frame's seed. */
vpSimulatedMarker markerOf(const Design &design, const Settings &settings, std::uint64_t frameSeed);

/*! Least number of sectors or cells in which two markers differ; 0 without a code. */
unsigned int codeDistanceOf(const Design &design);

/*! What the detector of this project is told to look for, and its size in metres: of a composition its widest ring. */
struct Wanted
{
  vpCircleMarkerFamily family;
  double size;
};
Wanted wantedOf(const Design &design, const Settings &settings);
} // namespace experiments

#endif
