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
 * Benchmarks of the rooms of the detector, each on its own.
 */

#include "register.h"

#if defined(CIRCLE_MARKER_HAVE_INTERNALS)

#include <algorithm>
#include <functional>
#include <memory>
#include <string>

#include <benchmark/benchmark.h>

#include "scenes.h"

#include "decode/recognise.h"
#include "ellipse/outlines.h"
#include "refine/measure.h"

namespace bench {
namespace {
using namespace circle_marker;

// What goes from room to room on one frame.
struct Visit
{
  explicit Visit(const SceneOptions &options) : scene(makeScene(options)), camera(scene.camera)
  {
    outlines = &findOutlines(scene.image, sought, workers, Deadline(), memory);
    for (const EllipseCandidate &outline : *outlines) {
      if (const auto poses = posesFromOutline(outline.points, camera, 0.5 * markerSize)) {
        OutlineInImage seen(scene.image, camera, *poses, outline);
        if (auto marker = recognise(seen, family, settings)) {
          markers.push_back(std::move(*marker));
        }
      }
    }
  }

  Scene scene;
  CameraModel camera;
  vpCircleMarkerFamily family{vpCircleMarkerFamily::GOLAY23};
  DecodeSettings settings;
  OutlineMemory memory;
  SoughtCenters sought{true, false, family.getLayout().ringInner}; // as the detector does
  Workers workers;
  const ReusedList<EllipseCandidate> *outlines = nullptr;
  std::vector<Recognition> markers;
  MeasureMemory measuring;
};

using Room = std::function<void(Visit &)>;

void add(const std::string &name, const std::shared_ptr<std::unique_ptr<Visit>> &visit, const SceneOptions &options,
         const Room &room)
{
  benchmark::RegisterBenchmark(("room/" + name).c_str(), [=](benchmark::State &state) {
    if (!*visit) {
      *visit = std::make_unique<Visit>(options);
    }
    for (auto _ : state) {
      room(**visit);
    }
    state.counters["chains"] = static_cast<double>((*visit)->memory.full.chains.chains.size());
    state.counters["outlines"] = static_cast<double>((*visit)->outlines->size());
    state.counters["markers"] = static_cast<double>((*visit)->markers.size());
  })->Unit(benchmark::kMillisecond);
}

void gradient(Visit &visit)
{
  computeGradient(visit.scene.image, visit.memory.full.gradient);
}

void chains(Visit &visit)
{
  linkEdgeChains(visit.memory.full.gradient, 14, visit.memory.full.chains);
}

void ellipses(Visit &visit)
{
  OutlineMemory::Scale &full = visit.memory.full;
  findEllipses(visit.scene.image, full.gradient, full.chains, visit.sought, OtherScale(), visit.workers, Deadline(),
               full.ellipses);
}

// All rooms up to the outlines, at all scales.
void outlines(Visit &visit)
{
  visit.outlines = &findOutlines(visit.scene.image, visit.sought, visit.workers, Deadline(), visit.memory);
}

void recogniseAll(Visit &visit)
{
  for (const EllipseCandidate &outline : *visit.outlines) {
    if (const auto poses = posesFromOutline(outline.points, visit.camera, 0.5 * markerSize)) {
      OutlineInImage seen(visit.scene.image, visit.camera, *poses, outline);
      auto marker = recognise(seen, visit.family, visit.settings);
      benchmark::DoNotOptimize(marker);
    }
  }
}

void measureAll(Visit &visit)
{
  for (const Recognition &marker : visit.markers) {
    auto measured = measure(visit.scene.image, visit.camera, marker, true, visit.measuring, Deadline(),
                            visit.memory.full.gradient.noise);
    benchmark::DoNotOptimize(measured);
  }
}

// What the refinement takes, of one marker.
struct MarkerToMeasure
{
  vpImage<unsigned char> image;
  CameraModel camera;
  ImageNoise noise;
  Recognition marker;
};

// The refinement of one marker, as the detector does it once the outline is chosen, the largest of those that are read:
// the mean over markers of the same diameter, pixels, tilted by up to 60 degrees. Some take twice as long as others, so
// there are many, each as often as the others.
void addMeasurement(double diameter)
{
  constexpr std::size_t frames = 60;
  constexpr int rounds = 10;
  const std::string name = "room/measure/" + std::to_string(static_cast<int>(diameter)) + "-pixels";
  const auto markers = std::make_shared<std::vector<MarkerToMeasure>>();
  const auto memory = std::make_shared<MeasureMemory>(); // one for all images, as a detector's
  benchmark::RegisterBenchmark(
      name.c_str(),
      [=](benchmark::State &state) {
        SceneOptions options;
        options.leastDiameter = diameter;
        options.greatestDiameter = diameter;
        for (options.seed = 1; options.seed <= frames && markers->size() < frames; ++options.seed) {
          const Visit visit(options);
          if (visit.markers.empty()) {
            return state.SkipWithError("a marker is not read");
          }
          markers->push_back(
              {visit.scene.image, visit.camera, visit.memory.full.gradient.noise, visit.markers.front()});
        }
        std::size_t frame = 0;
        for (auto _ : state) {
          const MarkerToMeasure &next = (*markers)[frame++ % frames];
          auto measured = measure(next.image, next.camera, next.marker, true, *memory, Deadline(), next.noise);
          benchmark::DoNotOptimize(measured);
        }
      })
      ->Unit(benchmark::kMillisecond)
      ->Iterations(rounds * static_cast<benchmark::IterationCount>(frames));
}
} // namespace

void registerRooms()
{
  SceneOptions plain;
  SceneOptions clutter;
  clutter.markers = 5;
  clutter.clutter = true;
  for (const auto &[name, options] : {std::pair<std::string, SceneOptions>("plain", plain), {"clutter", clutter}}) {
    const auto visit = std::make_shared<std::unique_ptr<Visit>>();
    add("gradient/" + name, visit, options, gradient);
    add("chains/" + name, visit, options, chains);
    add("ellipses/" + name, visit, options, ellipses);
    add("outlines/" + name, visit, options, outlines);
    add("recognise/" + name, visit, options, recogniseAll);
    add("measure/" + name, visit, options, measureAll);
  }
  for (const double diameter : {20., 50., 100., 200., 400.}) {
    addMeasurement(diameter);
  }
}
} // namespace bench

#else

namespace bench {
void registerRooms() {}
} // namespace bench

#endif
