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
 * What the tests of fits share: cases, images that the model itself gives, disturbed starts and errors.
 */

#ifndef VP_TEST_FIT_TOOLS_H
#define VP_TEST_FIT_TOOLS_H

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <Eigen/Core>

#include "refine/fit_pixels.h"
#include "refine/maximum_likelihood.h"
#include "testDarkness.h"
#include "testRoomTools.h"

namespace fit_test {
using namespace circle_marker;
using namespace room_test;

constexpr unsigned int side = 120;

struct Light
{
  double level = 200.;
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero(); //!< Of the light, where that is given as the grey level.
  double contrast = 0.85;                             //!< Of the light.
  double gamma = 1.;
};

struct Case
{
  MarkerScene scene;
  MarkerPattern pattern;
  std::vector<FitPixel> pixels;
};

Case makeCase(const MarkerScene &scene, int id, const vpImage<unsigned char> &I);

//! Grey levels that the model itself gives, not rounded.
void fillFromModel(Case &made, const Light &light, const BlurParameters &blur, double noise, Random &random);

//! A start that is off by some hundredths of the radius.
MarkerPlane disturbed(const MarkerPlane &plane, Random &random, double amount);

//! (t, w) from the fit to the truth, as in image_model.h.
Eigen::Matrix<double, 6, 1> errorOf(const MarkerPlane &fitted, const MarkerPlane &truth);

/*!
  Mahalanobis distance squared; without a spin, in the five directions that are left (translation and the two turns
  across the normal).
*/
double mahalanobis(const FittedPose &fit, const MarkerPlane &truth, bool spinIsKnown);

const vpCircleMarkerFamily::vpType families[] = {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31,
                                                 vpCircleMarkerFamily::BCH31R, vpCircleMarkerFamily::RING,
                                                 vpCircleMarkerFamily::DISC};

FitSettings settingsOf(const vpCircleMarkerFamily &family);

//! A fit to all pixels that takes light and contrast from the image.
std::optional<FittedPose> fitAll(const std::vector<FitPixel> &pixels, const MarkerPlane &start,
                                 const MarkerPattern &pattern, const FitSettings &settings);

inline int randomId(Random &random, const vpCircleMarkerFamily &family)
{
  return family.isCoded() ? static_cast<int>(random() % family.getNbIds()) : -1;
}
} // namespace fit_test

#endif
