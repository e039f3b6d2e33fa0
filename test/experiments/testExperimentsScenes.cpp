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
 * Tests of the experiments' scenes: what they claim to vary is what varies.
 */

#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>
#include <visp3/circle_marker_simulator/vpMarkerPoseBound.h>
#include <visp3/core/vpMath.h>

#include "common/pose_error.h"
#include "common/reference_camera.h"
#include "cover.h"
#include "design_figures.h"
#include "ideal_estimate.h"
#include "laboratory.h"
#include "poses.h"
#include "reading.h"
#include "report.h"

using namespace experiments;

namespace {
constexpr unsigned int frames = 40;

Scene sceneOf(const Settings &settings, const Series &series, unsigned int frame)
{
  return series.scene(frame, frameSeed(settings, series, frame));
}

vpSimulatedMarker markerAt(const Settings &settings, const vpHomogeneousMatrix &cMo)
{
  vpSimulatedMarker marker = vpSimulatedMarker::circle(codedFamily, 5, settings.size);
  return marker.setSheetSide(settings.sheetSide()).setPose(cMo);
}

vpMarkerTruth truthOf(const Settings &settings, const Scene &scene)
{
  vpMarkerSceneSimulator camera(scene.cam, imageWidth, imageHeight);
  camera.addMarker(markerAt(settings, *scene.cMo));
  if (scene.cover) {
    camera.addOccluder(occluderOf(*scene.cover, camera, *scene.cMo, 0.5 * settings.size));
  }
  return camera.getTruth().front();
}
} // namespace

TEST(ExperimentsScenes, NamesAreUniqueAndMarkersInTheImage)
{
  const Settings settings;
  for (const std::string &name : experimentNames()) {
    std::set<std::string> names;
    for (const Series &series : experimentNamed(name, settings).series) {
      EXPECT_TRUE(names.insert(series.name).second) << series.name;
      EXPECT_EQ(series.name.find_first_of(", "), std::string::npos) << series.name;
      for (unsigned int frame = 0; frame < 5; ++frame) {
        Scene scene = sceneOf(settings, series, frame);
        scene.cover.reset();
        if (scene.cMo) {
          EXPECT_EQ(truthOf(settings, scene).visibleEdge, 1.) << series.name << " frame " << frame;
        }
      }
    }
  }
  EXPECT_THROW(experimentNamed("4", settings), std::invalid_argument);
}

TEST(ExperimentsScenes, LinesFaceTheCamera)
{
  Settings settings;
  settings.maximumDistance = 9.;
  double farthest = 0.;
  for (const Series &series : experimentOfLines(settings).series) {
    for (unsigned int frame = 0; frame < frames; ++frame) {
      const vpHomogeneousMatrix cMo = *sceneOf(settings, series, frame).cMo;
      EXPECT_NEAR(cMo[2][2], 1., 1e-12); // The normal is parallel to the optical axis.
      EXPECT_GE(cMo[2][3], nearestDepth);
      EXPECT_LE(cMo[2][3], 9.);
      farthest = std::max(farthest, cMo[2][3]);
    }
  }
  EXPECT_GT(farthest, 8.);
}

TEST(ExperimentsScenes, BoundIsThereForEveryLine)
{
  for (const Series &series : experimentOfLines(Settings()).series) {
    std::set<unsigned int> lines;
    std::size_t bounds = 0;
    constexpr unsigned int count = 100;
    for (unsigned int frame = 0; frame < count; ++frame) {
      const std::vector<Method> methods = methodsOf(series, frame);
      if (std::find(methods.begin(), methods.end(), Method::Bound) != methods.end()) {
        ++bounds;
        lines.insert(frame % series.kinds);
      }
    }
    EXPECT_EQ(bounds, count / 5) << series.name;
    EXPECT_EQ(lines.size(), series.name == "single-line-200" ? 1u : 5u) << series.name;
  }
}

TEST(ExperimentsScenes, CellsKeepTheirRanges)
{
  Settings settings;
  settings.maximumAngle = 40.;
  settings.maximumDistance = 5.;
  const Experiment experiment = experimentOfCells(settings);
  ASSERT_EQ(experiment.series.size(), 1u);
  double farthest = 0.;
  double most = 0.;
  for (unsigned int frame = 0; frame < frames; ++frame) {
    const vpHomogeneousMatrix cMo = *sceneOf(settings, experiment.series.front(), frame).cMo;
    farthest = std::max(farthest, cMo[2][3]);
    most = std::max(most, vpMath::deg(tiltOf(cMo)));
  }
  EXPECT_LE(farthest, 5.);
  EXPECT_GT(farthest, 4.);
  EXPECT_LE(most, 40.);
  EXPECT_GT(most, 32.);
  EXPECT_EQ(experimentOfCells(Settings()).series.size(), 5u);
}

TEST(ExperimentsScenes, PosesAtOnePlaceHaveItsDepthAndAngle)
{
  const Settings settings;
  for (unsigned int frame = 0; frame < frames; ++frame) {
    const vpHomogeneousMatrix cMo = poseAt(settings, referenceCamera(), 7., vpMath::rad(35.), frame);
    EXPECT_NEAR(cMo[2][3], 7., 1e-12);
    EXPECT_NEAR(vpMath::deg(tiltOf(cMo)), 35., 1e-9);
  }
}

TEST(ExperimentsScenes, LevelsOfADisturbanceHaveTheSamePoses)
{
  const Settings settings;
  const Experiment experiment = experimentOfResilience(settings);
  for (const Series &series : experiment.series) {
    if (series.group != "distortion") {
      const PoseError error =
          errorOf(*sceneOf(settings, series, 3).cMo, *sceneOf(settings, experiment.series.front(), 3).cMo);
      EXPECT_EQ(error.position, 0.) << series.name;
      EXPECT_NEAR(error.rotation, 0., 1e-9) << series.name;
    }
  }
}

TEST(ExperimentsScenes, ChordCutsOffItsShare)
{
  EXPECT_NEAR(chordDistance(0.5), 0., 1e-12);
  EXPECT_NEAR(chordDistance(0.), 1., 1e-9);
  for (double share = 0.05; share < 1.; share += 0.05) {
    // By counting: the share of the disc beyond the line, in strips across it.
    const double line = chordDistance(share);
    double area = 0.;
    constexpr int strips = 100000;
    for (int i = 0; i < strips; ++i) {
      const double at = line + (1. - line) * (i + 0.5) / strips;
      area += 2. * std::sqrt(1. - at * at) * (1. - line) / strips;
    }
    EXPECT_NEAR(area / M_PI, share, 1e-5);
  }
}

TEST(ExperimentsScenes, OccluderCoversItsShareOfTheMarker)
{
  // The simulator's own measure of what is covered, which knows nothing of how the occluder was made.
  const Settings settings;
  for (const Series &series : experimentOfResilience(settings).series) {
    if (series.group == "occlusion") {
      for (unsigned int frame = 0; frame < 5; ++frame) {
        const Scene scene = sceneOf(settings, series, frame);
        // Perspective makes the nearer half larger, by about as much as its rim is nearer.
        const double nearer = 0.5 * settings.size * std::sin(tiltOf(*scene.cMo)) / (*scene.cMo)[2][3];
        EXPECT_NEAR(truthOf(settings, scene).coveredArea, series.level, 0.002 + nearer)
            << series.name << " frame " << frame;
      }
    }
  }
}

TEST(ExperimentsScenes, IdealEstimatesScatterAsTheBoundSays)
{
  Settings settings;
  Scene scene;
  scene.cam = referenceCamera();
  scene.photometry = photometryOf(settings);
  scene.cMo = poseAt(settings, scene.cam, 8., vpMath::rad(40.), 1);
  const vpSimulatedMarker marker = markerAt(settings, *scene.cMo);
  vpMarkerPoseBound limit(scene.cam, scene.photometry);
  limit.setSurround(vpMarkerPoseBound::UNKNOWN_SURROUND);
  const vpPoseBound bound = limit.bound(marker);
  constexpr unsigned int draws = 2000;
  double squaresOfZ = 0.;
  double squaresOfNormal = 0.;
  for (unsigned int i = 0; i < draws; ++i) {
    const PoseError error = errorOf(drawnEstimate(*scene.cMo, bound.covariance, i), *scene.cMo);
    squaresOfZ += error.z * error.z;
    squaresOfNormal += error.normal * error.normal;
  }
  // Their spread is that of chi-square over its degrees of freedom: sqrt(2 / draws) is 3 %.
  EXPECT_NEAR(squaresOfZ / draws / (bound.z * bound.z), 1., 0.13);
  EXPECT_NEAR(squaresOfNormal / draws / (bound.normal * bound.normal), 1., 0.13);
  // What a frame gets is such a draw.
  EXPECT_EQ(errorOf(idealEstimate(marker, scene, 3), *scene.cMo).z,
            errorOf(drawnEstimate(*scene.cMo, bound.covariance, 3), *scene.cMo).z);
}

TEST(ExperimentsScenes, UndisturbedMarkersAreFoundByAllMethods)
{
  const Settings settings;
  Laboratory laboratory(settings);
  for (const Series &series : experimentOfResilience(settings).series) {
    if (series.name == "distortion-0" || series.name == "distortion-0.2") {
      for (const Sample &sample : laboratory.take(series, 2)) {
        ASSERT_TRUE(sample.first.has_value()) << series.name << " " << nameOf(sample.method);
        EXPECT_LT(sample.first->position(), 0.01 * 1000. * sample.distance()) << nameOf(sample.method);
      }
    }
  }
}

TEST(ExperimentsScenes, DesignsAreReadAndLimited)
{
  // The simulator's and the detector's ideas of a design come from two places: a pose comes out only if they agree.
  const Settings settings;
  Laboratory laboratory(settings);
  for (Series series : experimentOfDesign(settings).series) {
    if (series.name == "ring-0" || series.name == "track-4" || series.name == "quiet-4" || series.name == "family-1") {
      const auto makeScene = series.scene;
      series.scene = [&](unsigned int frame, std::uint64_t seed) {
        Scene scene = makeScene(frame, seed);
        scene.cMo = poseAt(settings, scene.cam, 4., vpMath::rad(35.), seed);
        return scene;
      };
      const FrameSamples samples = laboratory.take(series, 0);
      ASSERT_EQ(samples.size(), 2u);
      ASSERT_TRUE(samples[0].first.has_value()) << series.name;
      const Deviation limit = *samples[1].first;
      EXPECT_GT(limit.dz, 0.05) << series.name; // mm
      EXPECT_LT(limit.dz, 1.) << series.name;
      EXPECT_GT(samples[1].logOdds, 100.) << series.name;
      EXPECT_LT(std::fabs(samples[0].first->dz), 10. * limit.dz) << series.name;
    }
  }
}

TEST(ExperimentsScenes, ReadingIsTheContrastOverTheSectors)
{
  // Of a sharp image the distance is contrast times the root of the flipped area in pixels, over the noise.
  Scene scene;
  scene.cam = referenceCamera();
  scene.photometry.blurSigma = 0.2;
  scene.photometry.noiseSigma = 2.;
  const double depth = 1.;
  const double radius = 0.09 * focalLength / depth; // Pixels.
  const vpHomogeneousMatrix cMo(vpTranslationVector(0.1, -0.05, depth), vpRotationMatrix());
  vpSimulatedMarker marker = vpSimulatedMarker::circle("golay23", 5, 0.18);
  marker.setPose(cMo);
  const double sector = M_PI * (0.68 * 0.68 - 0.4 * 0.4) / 23. * radius * radius;
  const double one = (220. - 30.) * std::sqrt(sector) / 2.;
  EXPECT_NEAR(readingDistance(marker, 1, scene), one, 0.03 * one);
  EXPECT_NEAR(readingDistance(marker, 7, scene), std::sqrt(7.) * one, 0.03 * std::sqrt(7.) * one);
  // Windows change the image as much as sectors of the same size; a tag's cells are squares.
  vpSimulatedMarker windows = vpSimulatedMarker::rings({{0.2, 1.}}, 0.18);
  windows.setTrack(0.4, 0.68, 23, 0b10101010101010101010101, true).setPose(cMo);
  EXPECT_NEAR(readingDistance(windows, 1, scene), one, 0.03 * one);
  vpSimulatedMarker tag = vpSimulatedMarker::aprilTag36h11(3, 0.16);
  tag.setPose(cMo);
  const double cell = 0.02 * focalLength / depth;
  EXPECT_NEAR(readingDistance(tag, 1, scene), 190. * cell / 2., 0.03 * 190. * cell / 2.);
}

TEST(ExperimentsScenes, RivalsFillTheSameSheet)
{
  const Settings settings;
  std::size_t rivals = 0;
  for (const Series &series : experimentOfDesign(settings).series) {
    if (series.group != rivalGroup && series.group != "sectors") {
      continue;
    }
    ++rivals;
    const Scene scene = series.scene(0, 1);
    const vpSimulatedMarker marker = markerOf(*scene.design, settings, 1);
    const bool isTag = scene.design->family == "36h11";
    EXPECT_NEAR(marker.getSize(), isTag ? tagOnSheet(settings.sheetSide()) : settings.size, 1e-12) << series.title;
    // What the detector looks for is a ring of the print, of the same ratio.
    if (!isTag) {
      const Wanted wanted = wantedOf(*scene.design, settings);
      EXPECT_LE(wanted.size, settings.size + 1e-12) << series.title;
      if (const auto &parts = scene.design->composition) {
        const bool isThere = std::any_of(parts->rings.begin(), parts->rings.end(), [&](const auto &ring) {
          return std::fabs(ring[1] * settings.size - wanted.size) < 1e-12 &&
                 std::fabs(ring[0] - ring[1] * wanted.family.getLayout().ringInner) < 1e-12;
        });
        EXPECT_TRUE(isThere) << series.title;
      }
    }
  }
  EXPECT_EQ(rivals, 14u);
}

TEST(ExperimentsScenes, DesignFiguresAreMediansAndShares)
{
  std::vector<std::optional<FrameSamples>> series;
  for (const double z : {1., 3., 8.}) {
    Sample seen;
    seen.z = 10.; // Metres.
    seen.first = z < 5. ? std::optional<Deviation>(Deviation{0., 0., -z, 0.}) : std::nullopt;
    Sample limit;
    limit.method = Method::Limit;
    limit.first = Deviation{3., 4., z, 2. * z};
    limit.logOdds = z;
    limit.reading = 4. * z;
    series.push_back(FrameSamples{seen, limit});
  }
  const DesignFigures figures = designFiguresOf(series);
  EXPECT_EQ(figures.frames, 3u);
  EXPECT_DOUBLE_EQ(figures.found, 2. / 3.);
  EXPECT_DOUBLE_EQ(figures.reach, leastDesignDepth + 2. / 3. * (mostDesignDepth - leastDesignDepth));
  EXPECT_DOUBLE_EQ(figures.depthLimit, 3.);
  EXPECT_DOUBLE_EQ(figures.lateralLimit, 5.);
  EXPECT_DOUBLE_EQ(figures.normalLimit, 6.);
  EXPECT_NEAR(figures.depthError, 2. / 0.6745, 1e-9); // The median of 1 and 3.
  EXPECT_DOUBLE_EQ(figures.weakSeparation, 1.);
  EXPECT_DOUBLE_EQ(figures.reading, 12.);
  EXPECT_DOUBLE_EQ(figures.unread, 1. / 3.); // 4 is below 10.
}

TEST(ExperimentsScenes, ResilienceIsReported)
{
  // Every level once, seen by nobody: the report has to stand that, and every disturbance has its figure.
  const Settings settings;
  const Experiment experiment = experimentOfResilience(settings);
  RunData data = emptyData(experiment);
  for (std::size_t i = 0; i < data.size(); ++i) {
    data[i][0].emplace();
    for (const Method method : experiment.series[i].methods) {
      Sample sample;
      sample.method = method;
      data[i][0]->push_back(sample);
    }
  }
  Document document("test");
  addResilience(experiment, data, document);
  for (const std::string name : {"occlusion", "noise", "blur", "motion", "light", "distortion"}) {
    EXPECT_NE(document.html().find("resilience-" + name + ".svg"), std::string::npos) << name;
  }
}

TEST(ExperimentsScenes, FrameComesOutTheSameWhateverWasBefore)
{
  const Settings settings;
  const Experiment experiment = experimentOfCells(settings);
  Laboratory used(settings);
  used.take(experiment.series[4], 1);
  Laboratory fresh(settings);
  const FrameSamples a = used.take(experiment.series[0], 2);
  const FrameSamples b = fresh.take(experiment.series[0], 2);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].first.has_value(), b[i].first.has_value());
    EXPECT_EQ(a[i].first->dz, b[i].first->dz);
    EXPECT_EQ(a[i].first->normal, b[i].first->normal);
  }
}
