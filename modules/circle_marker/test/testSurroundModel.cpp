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
 * Tests of what pixels see beyond the paper, as a function of the pose.
 */

#include "testFitTools.h"

#include "refine/fit_step.h"
#include "refine/surround_model.h"

using namespace fit_test;

namespace {
//! The pixels of a small marker on dark ground, sorted.
struct SmallOnDark
{
  SmallOnDark(Random &random, double tilt)
      : scene(markerScene(random, vpCircleMarkerFamily(vpCircleMarkerFamily::GOLAY23), 3, uniform(random, 18., 30.),
                          tilt, side)),
        pattern(patternOf(scene.family, 3))
  {
    photometry.white = 200.;
    photometry.paper = {{uniform(random, -0.03, 0.03), uniform(random, -0.03, 0.03)},
                        uniform(random, -0.05, 0.05),
                        uniform(random, -0.03, 0.03)};
    photometry.surround = {{uniform(random, 0., 1.), uniform(random, 0., 1.)}};
    photometry.blur.sigma = uniform(random, 0.7, 1.2);
    photometry.blur.elongate(Eigen::Vector2d(uniform(random, -0.15, 0.15), uniform(random, -0.15, 0.15)));
    const vpImage<unsigned char> I = photograph(side, side, photometry.blur.sigma, scene);
    const MarkerPlane plane = scene.plane();
    selectPixels(I, CameraModel(scene.camera()), scene.frame(), &plane, 1, pattern, {photometry.blur, 0.3, 3000.},
                 pixels);
    packPixels(pixels, plane, pattern, photometry, 2., 1., mostBorders, blocks);
  }

  //! Grey levels that the surround takes off or adds, block by block, after a step of the fit.
  std::vector<Lanes> changesAfter(int parameter, double step) const
  {
    ParameterVector steps = ParameterVector::Zero();
    steps[parameter] = step;
    MarkerPlane plane = scene.plane();
    Photometry changed = photometry;
    applyStep(steps, plane, changed);
    SurroundModel model(plane, pattern.paper, changed, blocks);
    std::vector<Lanes> changes;
    forEachBlock(blocks, [&](const PixelBlock &block, PixelSight) {
      if (const SurroundLanes *seen = model.at(block)) {
        Lanes change = Lanes::Zero();
        for (std::size_t shape = 0; shape < paperShapes; ++shape) {
          change += static_cast<float>(photometry.surround[shape]) * seen->share[shape] *
                    (seen->beyond[shape] - static_cast<float>(photometry.white));
        }
        changes.push_back(change * holdsPixel(block));
      }
    });
    return changes;
  }

  MarkerScene scene;
  MarkerPattern pattern;
  Photometry photometry;
  std::vector<FitPixel> pixels;
  PixelBlocks blocks;
};
} // namespace

TEST(SurroundModel, DerivativesAgreeWithDifferences)
{
  Random random = randomOfTest();
  for (int i = 0; i < 30; ++i) {
    const SmallOnDark marker(random, uniform(random, 0., 1.25));
    SurroundModel model(marker.scene.plane(), marker.pattern.paper, marker.photometry, marker.blocks, true);
    std::vector<RowLanes> rows;
    std::vector<Lanes> holds;
    forEachBlock(marker.blocks, [&](const PixelBlock &block, PixelSight) {
      if (model.at(block) != nullptr) {
        GreyLanes grey;
        grey.white.setConstant(static_cast<float>(marker.photometry.white));
        RowLanes row;
        for (Lanes &lanes : row) {
          lanes.setZero();
        }
        model.addTo(grey, row);
        rows.push_back(row);
        holds.push_back(holdsPixel(block));
      }
    });
    ASSERT_FALSE(rows.empty());
    for (const int parameter : {0, 1, 2, 3, 4, 5, sigmaAt, paperAt, paperAt + 1, paperAt + 2, paperAt + 3, elongationAt,
                                elongationAt + 1, bendAt, bendAt + 1, bendAt + 2}) {
      constexpr double step = 3e-3;
      const std::vector<Lanes> more = marker.changesAfter(parameter, step);
      const std::vector<Lanes> less = marker.changesAfter(parameter, -step);
      double worst = 0., largest = 0.;
      for (std::size_t k = 0; k < rows.size(); ++k) {
        const Lanes numeric = (more[k] - less[k]) * static_cast<float>(0.5 / step);
        const Lanes error = holds[k] * rows[k][static_cast<std::size_t>(parameter)] - numeric;
        worst = std::max(worst, static_cast<double>(error.abs().maxCoeff()));
        largest = std::max(largest, static_cast<double>(numeric.abs().maxCoeff()));
      }
      // How blur and bend turn the corners' edges is not in it.
      const bool isOfPose = parameter < 6 || parameter == sigmaAt || (parameter >= paperAt && parameter < bendAt);
      EXPECT_LT(worst, (isOfPose ? 0.03 : 0.15) * largest + (isOfPose ? 0.5 : 3.)) << "parameter " << parameter;
    }
  }
}
