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
 * The model of refine/image_model.h at one pixel.
 */

#ifndef VP_TEST_DARKNESS_H
#define VP_TEST_DARKNESS_H

#include "refine/image_model.h"
#include "testRoomTools.h"

namespace room_test {
using namespace circle_marker;

/*! Share of black that a pixel sees, and its derivatives. */
struct Darkness
{
  double value = 0.;
  //! By (t, w): the marker's centre moves by t (metres) and the marker turns about it by w (rad), in the camera frame.
  Eigen::Matrix<double, 6, 1> byPose = Eigen::Matrix<double, 6, 1>::Zero();
  double bySigma = 0.;                                    //!< 1 / pixel.
  Eigen::Vector2d byElongation = Eigen::Vector2d::Zero(); //!< By a step of BlurParameters::elongate().
  double bySpread = 0.;                                   //!< 1 / radius.
  Eigen::Vector3d byBend = Eigen::Vector3d::Zero();       //!< By the bow and the saddle of the sheet (SheetBend).
};

/*! Evaluates the model at one pixel: fits take blocks of them. */
inline Darkness darknessAt(const ModelPixel &pixel, const MarkerPlane &plane, const MarkerPattern &pattern,
                           const BlurParameters &blur)
{
  FitPixel single;
  single.meter = pixel.meter.cast<float>();
  single.meterPerPixel = pixel.meterPerPixel.cast<float>();
  Photometry photometry;
  photometry.blur = blur;
  PixelBlocks blocks;
  packPixels({single}, plane, pattern, photometry, 0., 0., mostBorders, blocks);
  const ImageModel model(plane, pattern, blur, blocks, true);
  Darkness darkness;
  for (std::size_t kind = 0; kind < pixelSights; ++kind) {
    if (blocks.count[kind] == 0) {
      continue;
    }
    DarknessLanes lanes;
    model.evaluate(blocks.bySight[kind][0], static_cast<PixelSight>(kind), lanes);
    const Eigen::Vector3d translation(lanes.byTwist[0][0], lanes.byTwist[1][0], lanes.byTwist[2][0]);
    const Eigen::Vector3d turn(lanes.byTwist[3][0], lanes.byTwist[4][0], lanes.byTwist[5][0]);
    darkness.value = lanes.value[0];
    darkness.byPose << plane.rotation * translation / plane.radius, plane.rotation * turn;
    darkness.bySigma = lanes.bySigma[0];
    darkness.byElongation << lanes.byElongation[0][0], lanes.byElongation[1][0];
    darkness.bySpread = lanes.bySpread[0];
    darkness.byBend << lanes.byBend[0][0], lanes.byBend[1][0], lanes.byBend[2][0];
  }
  return darkness;
}
} // namespace room_test

#endif
