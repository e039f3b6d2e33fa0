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
 * Benchmarks of the whole detection: kinds of frames, sizes, numbers of markers, hard images, threads.
 */

#include "register.h"

#include <functional>
#include <map>
#include <string>
#include <tuple>
#include <utility>

#include <benchmark/benchmark.h>

#include "common/processed_picture.h"
#include "common/sharpened_picture.h"
#include "peers.h"

namespace bench {
namespace {
using MakeScene = std::function<Scene()>;

// A frame is drawn when it is first measured, and kept.
const Scene &sceneOf(const std::string &name, const MakeScene &make)
{
  static std::map<std::string, Scene> scenes;
  const auto known = scenes.find(name);
  return known != scenes.end() ? known->second : scenes.emplace(name, make()).first->second;
}

void add(const Peer &peer, const std::string &frame, const MakeScene &make)
{
  benchmark::RegisterBenchmark((peer.name + "/" + frame).c_str(),
                               [peer, frame, make](benchmark::State &state) {
                                 const Scene &scene = sceneOf(frame, make);
                                 peer.look(scene); // working memory is had once: 50 ms of page faults on 12 megapixels
                                 for (auto _ : state) {
                                   peer.look(scene);
                                 }
                                 const double pixels = scene.image.getSize();
                                 state.counters["ns/pixel"] =
                                     benchmark::Counter(1e-9 * pixels, benchmark::Counter::kIsIterationInvariantRate |
                                                                           benchmark::Counter::kInvert);
                               })
      ->Unit(benchmark::kMillisecond)
      ->MeasureProcessCPUTime()
      ->UseRealTime();
}

MakeScene sceneMaker(SceneOptions options)
{
  return [options]() { return makeScene(options); };
}

SceneOptions framed(unsigned int width, unsigned int height, unsigned int markers, bool clutter)
{
  SceneOptions options;
  options.width = width;
  options.height = height;
  options.markers = markers;
  options.clutter = clutter;
  return options;
}
} // namespace

void registerWholeFrames()
{
  std::vector<Peer> all = {circleMarker(1), circleMarker(2)};
  for (const Peer &peer : peers()) {
    all.push_back(peer);
  }
  SceneOptions plain;
  SceneOptions clutter = framed(1280, 960, 5, true);
  SceneOptions clean = plain;
  clean.noise = 0.;
  SceneOptions cleanClutter = clutter;
  cleanClutter.noise = 0.;
  for (const Peer &peer : all) {
    add(peer, "plain", sceneMaker(plain));
    add(peer, "clutter", sceneMaker(clutter));
    add(peer, "plain-noise-free", sceneMaker(clean));
    add(peer, "clutter-noise-free", sceneMaker(cleanClutter));
  }
  for (const double diameter : {30., 100., 200.}) {
    SceneOptions options;
    options.leastDiameter = diameter;
    options.greatestDiameter = diameter;
    options.mostTilt = 0.6;
    for (const bool refine : {false, true}) {
      add(trackingCircleMarker(refine), std::to_string(static_cast<int>(diameter)) + "-pixels", sceneMaker(options));
    }
  }
  struct Size
  {
    unsigned int width, height;
  };
  for (const Size size : {Size{640, 480}, Size{1280, 960}, Size{2048, 1536}, Size{2560, 1920}, Size{4000, 3000}}) {
    const std::string pixels = std::to_string(size.width) + "x" + std::to_string(size.height);
    add(circleMarker(), "size/" + pixels, sceneMaker(framed(size.width, size.height, 5, true)));
  }
  for (const unsigned int markers : {1U, 10U, 50U, 100U, 250U, 500U}) {
    add(circleMarker(), "markers/" + std::to_string(markers), sceneMaker(framed(4000, 3000, markers, false)));
  }
  // Much noise that neighbouring pixels share.
  SceneOptions noisy = framed(640, 480, 1, true);
  noisy.noise = 10.;
  using common::Processing;
  for (const auto &[name, processing] : {std::pair<const char *, Processing>("none", Processing::NONE),
                                         {"demosaiced", Processing::DEMOSAICED},
                                         {"smoothed", Processing::SMOOTHED},
                                         {"enlarged", Processing::ENLARGED}}) {
    add(circleMarker(), std::string("processed/") + name, [noisy, processing = processing]() {
      Scene scene = makeScene(noisy);
      common::process(processing, scene.image);
      scene.camera = common::cameraOf(processing, scene.camera);
      return scene;
    });
  }
  // What leaves more than noise of each marker: a camera that sharpens, and a focal length that is not the camera's.
  const SceneOptions twelve = framed(640, 480, 12, false);
  for (const auto &[name, amount, sigma] : {std::tuple<const char *, double, double>("none", 0., 1.),
                                            {"half-by-1-pixel", 0.5, 1.},
                                            {"once-by-2-pixels", 1., 2.}}) {
    add(circleMarker(), std::string("sharpened/") + name, [twelve, amount = amount, sigma = sigma]() {
      Scene scene = makeScene(twelve);
      common::sharpen(amount, sigma, scene.image);
      return scene;
    });
  }
  for (const auto &[name, factor] :
       {std::pair<const char *, double>("right", 1.), {"less-by-tenth", 0.9}, {"more-by-fifth", 1.2}}) {
    add(circleMarker(), std::string("focal-length/") + name, [twelve, factor = factor]() {
      Scene scene = makeScene(twelve);
      const vpCameraParameters camera = scene.camera;
      scene.camera.initPersProjWithoutDistortion(factor * camera.get_px(), factor * camera.get_py(), camera.get_u0(),
                                                 camera.get_v0());
      return scene;
    });
  }
  for (const std::string &name : timedImages()) {
    for (const Size size : {Size{640, 480}, Size{1280, 960}, Size{2560, 1920}}) {
      const std::string frame = "hard/" + name + "/" + std::to_string(size.width);
      add(circleMarker(), frame, [=]() {
        Scene scene = makeScene(framed(64, 64, 0, false)); // for the camera
        scene.image = makeHardImage(name, size.width, size.height);
        return scene;
      });
    }
  }
}
} // namespace bench
