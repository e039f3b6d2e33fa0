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
 * A marker that is measured by fits that end as a test says.
 */

#ifndef VP_TEST_SCRIPTED_MEASURE_H
#define VP_TEST_SCRIPTED_MEASURE_H

#include "testMeasureTools.h"
#include "testScriptedFitter.h"

#include <algorithm>
#include <iterator>
#include <functional>
#include <memory>

#include "refine/measure.h"

namespace scripted_test {
using namespace circle_marker;
using namespace room_test;

constexpr unsigned int side = 150;

constexpr double noise = 2.;       // of the scripted fits, grey levels
constexpr double oddsOfTwin = 10.; // log-odds of the true pose against the other one, by the scripted fits

//! What log-odds are as a difference of squared residuals.
inline double squaresOf(double logOdds)
{
  return 2. * noise * noise * logOdds;
}

//! A marker of 80 pixels, or another diameter, on the optical axis, turned about the image's y axis.
inline MarkerScene tilted(const vpCircleMarkerFamily &family, double tilt, double diameter = 80.)
{
  MarkerScene scene;
  scene.family = family;
  scene.principal = Eigen::Vector2d(0.5 * side, 0.5 * side);
  scene.center = Eigen::Vector3d(0., 0., 2. * scene.radius * scene.focal / diameter);
  scene.rotation = turn(tilt, Eigen::Vector3d::UnitY());
  return scene;
}

inline bool isTwinOf(const MarkerPlane &plane, const MarkerScene &scene)
{
  return plane.rotation.col(2).dot(scene.rotation.col(2)) < 0.999;
}

//! Of measure(), and what it asked of its fitter, without fits with a tone curve: as the noise of the image is not told
//! here, every fit leaves more.
struct Outcome
{
  std::optional<Measurement> measurement;
  std::vector<ScriptedFitter::Asked> asked;

  //! Number of fits on all pixels that started.
  long onAllPixels() const
  {
    return std::count_if(asked.begin(), asked.end(), [](const auto &fit) { return fit.settings.exactBends; });
  }
};

//! Log-odds of the other fits against one, where they are judged, beyond what the script gave it.
using OddsAgainst = std::function<double(const FittedPose &)>;

using Alter = std::function<void(FittedPose &, const ScriptedFitter::Asked &)>;

//! A marker whose fits end where they start, the other pose oddsOfTwin behind, and are then altered.
inline Outcome outcomeOf(
    const MarkerScene &scene, const Recognition &marker, bool refine, const Alter &alter,
    const Deadline &deadline = Deadline(), const std::vector<ExplainedPixel> &explains = {},
    const OddsAgainst &oddsAgainst = [](const FittedPose &) { return 0.; })
{
  auto scripted = std::make_unique<ScriptedFitter>([&](const ScriptedFitter::Asked &asked) {
    FittedPose fit = fitAt(asked.start);
    fit.noise = noise;
    fit.squares += isTwinOf(fit.plane, scene) ? squaresOf(oddsOfTwin) : 0.;
    alter(fit, asked);
    return std::optional<FittedPose>(fit);
  });
  scripted->explains = explains;
  scripted->moreSquares = [&](const FittedPose &fit) { return squaresOf(oddsAgainst(fit)); };
  const ScriptedFitter &fitter = *scripted;
  MeasureMemory memory;
  memory.fitter = std::move(scripted);
  const vpImage<unsigned char> I(side, side, 200);
  Outcome outcome;
  outcome.measurement = measure(I, CameraModel(scene.camera()), marker, refine, memory, deadline);
  std::copy_if(fitter.asked.begin(), fitter.asked.end(), std::back_inserter(outcome.asked),
               [](const auto &fit) { return !fit.start.photometry || !fit.start.photometry->toneCurve; });
  return outcome;
}

const vpCircleMarkerFamily coded(vpCircleMarkerFamily::GOLAY23);
const vpCircleMarkerFamily ring(vpCircleMarkerFamily::RING);
} // namespace scripted_test

#endif
