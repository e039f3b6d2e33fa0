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
 * Finds the target in a picture.
 */

#ifndef VP_CALIBRATE_FIND_H
#define VP_CALIBRATE_FIND_H

#include <optional>
#include <string>

#include <visp3/circle_marker/vpDetectorCircleMarker.h>
#include <visp3/core/vpImage.h>

#include "lens.h"
#include "target.h"
#include "view.h"

namespace calibrate {
/*! What became of a picture. */
struct Search
{
  std::optional<View> view;
  std::string problem; //!< Why there is none.
};

/*!
  Finds a target. Corners of chessboards by OpenCV; circles by this project's detector, which fits the whole outline to
  the grey levels, put in order by OpenCV; circles that the detector does not see whole in a grid by OpenCV's blobs.
*/
class Finder
{
public:
  explicit Finder(const Target &target);

  /*!
    \param I : The image.
    \param name : Of the image, for the view.
    \param lens : The camera as far as it is known; a nominal one for the first time. It only helps to draw outlines.
  */
  Search find(const vpImage<unsigned char> &I, const std::string &name, const std::optional<Lens> &lens);

private:
  Search findChessboard(const vpImage<unsigned char> &I) const;
  Search findGrid(const vpImage<unsigned char> &I, const Lens &lens);
  Search findMarkers(const vpImage<unsigned char> &I, const Lens &lens);

  Target m_target;                   //!< What is looked for.
  vpDetectorCircleMarker m_detector; //!< Of its circles.
};

/*! \return Centres of a grid's discs as OpenCV's blob detector has them, in the target's order; as ViSP's own
  calibration example takes them. Empty: not found. */
std::vector<Eigen::Vector2d> blobCenters(const Target &target, const vpImage<unsigned char> &I);
} // namespace calibrate

#endif
