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
 * What the thesis left open: the measures of the marker, one after another, on a sheet of the same size.
 */

#include <sstream>

#include <visp3/core/vpMath.h>

#include "common/reference_camera.h"
#include "design_figures.h"
#include "experiment.h"
#include "poses.h"

namespace experiments {
namespace {
constexpr double mostAngle = 60.; // degrees
constexpr unsigned int framesOfDesign = 300;

/*! A design and what is said of it. */
struct Variant
{
  std::string group, title;
  double level;
  Design design;
};

Design defaultDesign()
{
  return {codedFamily, vpCircleMarkerLayout(), std::nullopt};
}

/*! The ring's inner radius; gap and centre keep their widths, so the code track takes what the ring leaves. */
std::vector<Variant> ringRatios()
{
  std::vector<Variant> variants;
  for (const double ratio : {0.65, 0.70, 0.75, 0.80, 0.85, 0.90}) {
    Design design = defaultDesign();
    const double gap = design.layout.ringInner - design.layout.codeOuter;
    design.layout.ringInner = ratio;
    design.layout.codeOuter = ratio - gap;
    variants.push_back({"ring", "inner radius of the ring", ratio, design});
  }
  return variants;
}

/*! The white gap between code and ring, at the code's cost. */
std::vector<Variant> gaps()
{
  std::vector<Variant> variants;
  for (const double gap : {0.04, 0.08, 0.12, 0.16, 0.20}) {
    Design design = defaultDesign();
    design.layout.codeOuter = design.layout.ringInner - gap;
    variants.push_back({"gap", "white gap between code and ring", gap, design});
  }
  return variants;
}

/*! The code's inner radius: length of the sectors against white of the centre. */
std::vector<Variant> tracks()
{
  std::vector<Variant> variants;
  for (const double inner : {0.20, 0.30, 0.40, 0.50, 0.60}) {
    Design design = defaultDesign();
    design.layout.codeInner = inner;
    variants.push_back({"track", "inner radius of the code", inner, design});
  }
  return variants;
}

/*! The quiet zone, at the ring's cost: the sheet stays as it is. */
std::vector<Variant> quietZones()
{
  std::vector<Variant> variants;
  for (const double zone : {1. / 24., 1. / 12., 1. / 6., 1. / 4., 1. / 3.}) {
    Design design = defaultDesign();
    design.layout.quietZone = zone;
    variants.push_back({"quiet", "quiet zone", zone, design});
  }
  return variants;
}

/*! The number of sectors, which the code fixes. */
std::vector<Variant> families()
{
  std::vector<Variant> variants;
  for (const char *name : {"golay23", "bch31", "bch31r"}) {
    Design design = defaultDesign();
    design.family = name;
    const double sectors = vpCircleMarkerFamily::fromName(name).getNbSectors();
    variants.push_back({"family", std::string("family ") + name + ", sectors", sectors, design});
  }
  return variants;
}

/*! A code of the default measures with other numbers of sectors, which no family has. */
std::vector<Variant> sectorCounts()
{
  // Sectors and least distance of the best cyclic codes with a dozen ids and more: the quadratic residue code [17,9,5]
  // (30 ids), the BCH code [21,12,5] (195), the Golay code [23,12,7] (178) and the BCH code [31,16,7] (2114).
  std::vector<Variant> variants;
  for (const auto &[sectors, distance] :
       std::vector<std::pair<unsigned int, unsigned int>>{{17, 5}, {21, 5}, {23, 7}, {31, 7}}) {
    const vpCircleMarkerLayout layout;
    Design design = defaultDesign();
    design.composition = Composition{{{layout.ringInner, 1.}}, {layout.codeInner, layout.codeOuter}, sectors, distance};
    variants.push_back({"sectors", "sectors", static_cast<double>(sectors), design});
  }
  return variants;
}

/*! Markers of another kind, all with the Golay code but for those without any. */
std::vector<Variant> rivals()
{
  constexpr unsigned int n = 23; // Sectors of the Golay code,
  constexpr unsigned int d = 7;  // and its least distance.
  const auto composed = [](const Composition &composition) {
    Design design = defaultDesign();
    design.composition = composition;
    return design;
  };
  const auto named = [](const char *family, double ratio) {
    Design design = defaultDesign();
    design.family = family;
    design.layout.ringInner = ratio;
    return design;
  };
  const std::vector<std::pair<const char *, Design>> list = {
      {"A: ring, code inside (default)", defaultDesign()},
      {"B: code inside touching the ring", composed({{{0.8, 1.}}, {0.4, 0.8}, n, d})},
      {"C: thick ring with white windows", composed({{{0.5, 1.}}, {0.66, 0.86}, n, d, true})},
      {"D: ring, code outside", composed({{{0.4, 0.6}}, {0.72, 1.}, n, d})},
      {"E: disc, code outside", composed({{{0., 0.6}}, {0.72, 1.}, n, d})},
      {"F: two rings, code between", composed({{{0.86, 1.}, {0.26, 0.4}}, {0.5, 0.76}, n, d})},
      {"G: plain ring 0.7 (thesis)", named("ring", thesisRingRatio)},
      {"H: plain ring 0.8", named("ring", 0.8)},
      {"I: two plain rings", composed({{{0.8, 1.}, {0.4, 0.6}}})},
      {"J: AprilTag 36h11", named("36h11", 0.)}};
  std::vector<Variant> variants;
  for (const auto &[title, design] : list) {
    variants.push_back({rivalGroup, title, static_cast<double>(variants.size() + 1), design});
  }
  return variants;
}

Series seriesOf(const Settings &settings, const Variant &variant, std::size_t number)
{
  std::ostringstream name;
  name << variant.group << '-' << number;
  std::ostringstream title;
  title.precision(3);
  title << variant.title;
  if (variant.group != rivalGroup) {
    title << ": " << variant.level;
  }
  Series series;
  series.name = name.str();
  series.title = title.str();
  series.group = variant.group;
  series.level = variant.level;
  series.frames = settings.frames.value_or(framesOfDesign);
  series.methods = {variant.design.family == "36h11" ? Method::AprilTag : Method::Circle, Method::Limit};
  series.stream = 1; // The same poses for all designs.
  const Design design = variant.design;
  series.scene = [settings, design](unsigned int, std::uint64_t seed) {
    Scene scene;
    scene.cam = referenceCamera();
    scene.photometry = photometryOf(settings);
    scene.design = design;
    scene.cMo = randomPose(settings, scene.cam, leastDesignDepth, mostDesignDepth, vpMath::rad(mostAngle), seed);
    return scene;
  };
  return series;
}
} // namespace

Experiment experimentOfDesign(const Settings &settings)
{
  Experiment experiment = {"design", "Marker design: measures of the ring, the code and the quiet zone", {}};
  for (const auto &variants : {ringRatios(), gaps(), tracks(), quietZones(), families(), sectorCounts(), rivals()}) {
    for (std::size_t i = 0; i < variants.size(); ++i) {
      experiment.series.push_back(seriesOf(settings, variants[i], i));
    }
  }
  return experiment;
}
} // namespace experiments
