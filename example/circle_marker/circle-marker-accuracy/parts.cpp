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
 * The parts of the measurement: which scenes are made, and by which methods they are looked at.
 */

#include <cstdio>
#include <functional>
#include <iterator>
#include <memory>

#include <visp3/circle_marker_simulator/vpRandomMarkerPose.h>
#include <visp3/core/vpMath.h>

#include "laboratory.h"
#include "parts.h"

namespace accuracy {
namespace {
/*! Some of the images of one group: all that is needed to make the records of image `frame`. */
struct Batch
{
  std::uint64_t key; //!< Of its own, whatever parts are asked for.
  unsigned int frames;
  std::function<std::vector<Record>(Laboratory &laboratory, std::uint64_t seed)> make;
};

// Keys of batches: one of these and the number of the batch in its part.
enum Stream : std::uint64_t
{
  LIMITS = 100,
  WHOLE_IMAGES = 200,
  DISTANCES = 300,
  MODEL = 400,
  CELLS = 500,
  TAGS = 600
};

Record named(Record record, const std::string &part, const std::string &group)
{
  record.part = part;
  record.group = group;
  return record;
}

void addLimits(const Settings &settings, std::vector<Batch> &batches)
{
  for (std::size_t octave = 0; octave + 1 < octaves.size(); ++octave) {
    Ranges ranges;
    ranges.leastDiameter = octaves[octave];
    ranges.mostDiameter = octaves[octave + 1];
    for (std::size_t i = 0; i < std::size(families); ++i) {
      const char *family = families[i];
      batches.push_back(
          {LIMITS + octave * std::size(families) + i, settings.frames, [=](Laboratory &laboratory, std::uint64_t seed) {
             const Scene scene = draw(ranges, family, seed);
             const Limit limit = laboratory.limitOf(scene, true);
             return std::vector<Record>{named(laboratory.measure(scene, limit), "limits", family)};
           }});
    }
    // Whether a window of the image gives what the whole image gives.
    ranges.wholeImage = true;
    batches.push_back(
        {WHOLE_IMAGES + octave, (settings.frames + 1) / 2, [=](Laboratory &laboratory, std::uint64_t seed) {
           const Scene scene = draw(ranges, "golay23", seed);
           const Limit limit = laboratory.limitOf(scene, false);
           return std::vector<Record>{named(laboratory.measure(scene, limit), "limits", "1280 x 960")};
         }});
  }
  for (std::size_t i = 0; i < std::size(distanceCells); ++i) {
    const DistanceCell &cell = distanceCells[i];
    Ranges ranges = withReferenceLight(Ranges());
    ranges.distance = cell.distance;
    ranges.leastTilt = cell.leastTilt;
    ranges.mostTilt = cell.mostTilt;
    ranges.size = distanceCellSize;
    batches.push_back({DISTANCES + i, 4 * settings.frames, [=](Laboratory &laboratory, std::uint64_t seed) {
                         const Scene scene = draw(ranges, "golay23", seed);
                         const Limit limit = laboratory.limitOf(scene, cell.mostTilt > 0.);
                         return std::vector<Record>{named(laboratory.measure(scene, limit), "limits", cell.name)};
                       }});
  }
}

/*! One image without, and with each factor alone, of the same marker at the same pose with the same noise. */
std::vector<Record> withAndWithout(Laboratory &laboratory, std::uint64_t seed)
{
  Ranges ranges = withReferenceLight(Ranges());
  ranges.leastDiameter = 32.; // So that the minor axis has 8 pixels at any tilt.
  ranges.mostDiameter = 200.;
  ranges.leastContrast = ranges.mostContrast = 150.;
  ranges.mostPaper = 180.; // Light 40 % brighter at one side of a marker does not saturate.
  const Scene base = draw(ranges, "golay23", seed);
  const Limit limit = laboratory.limitOf(base, false);
  std::vector<Record> records;
  for (std::size_t i = 0; i < factors().size(); ++i) {
    const Factor &factor = factors()[i];
    Scene scene = base;
    if (factor.camera) {
      ranges.camera = *factor.camera;
      scene = draw(ranges, "golay23", seed);
    }
    Draws draws(mixed(seed, i));
    if (factor.apply != nullptr) {
      factor.apply(scene, draws);
    }
    const bool isChanged = factor.camera || factor.isModelled;
    records.push_back(
        named(laboratory.measure(scene, isChanged ? laboratory.limitOf(scene, false) : limit), "model", factor.name));
  }
  return records;
}

Record inThesisCell(Laboratory &laboratory, const ThesisCell &cell, const std::string &family, std::uint64_t seed)
{
  Ranges ranges = withReferenceLight(Ranges());
  ranges.wholeImage = true;
  Scene scene = draw(ranges, family, seed); // For all but the pose.
  vpRandomPoseRange range;
  range.maxDepth = cell.maxDepth;
  range.maxTilt = vpMath::rad(cell.maxTilt);
  scene.cMo = vpRandomMarkerPose(scene.marker(), scene.camera, scene.width, scene.height, range, mixed(seed, CELLS));
  return named(laboratory.measure(scene, laboratory.limitOf(scene, true)), "cells", family + " " + nameOf(cell));
}

void addCells(const Settings &settings, std::vector<Batch> &batches)
{
  for (std::size_t i = 0; i < std::size(thesisCells); ++i) {
    const ThesisCell &cell = thesisCells[i];
    for (std::size_t k = 0; k < std::size(thesisFamilies); ++k) {
      const char *family = thesisFamilies[k];
      batches.push_back({CELLS + i * std::size(thesisFamilies) + k, 2 * settings.frames,
                         [=](Laboratory &laboratory, std::uint64_t seed) {
                           return std::vector<Record>{inThesisCell(laboratory, cell, family, seed)};
                         }});
    }
  }
}

void addTags(const Settings &settings, std::vector<Batch> &batches)
{
  constexpr std::size_t octavesOfTags = 4; // A tag's sheet of 400 pixels does not fit into a window.
  for (std::size_t octave = 0; octave < octavesOfTags; ++octave) {
    Ranges ranges;
    ranges.leastDiameter = octaves[octave];
    ranges.mostDiameter = octaves[octave + 1];
    ranges.extent = 1.65; // Diagonal of the sheet, 7/6 of the ring's diameter wide.
    batches.push_back({TAGS + octave, settings.frames, [=](Laboratory &laboratory, std::uint64_t seed) {
                         const Scene scene = draw(ranges, "golay23", seed);
                         const Limit tag = laboratory.limitOfTag(scene);
                         std::vector<Record> records = {laboratory.measure(scene, laboratory.limitOf(scene, false)),
                                                        laboratory.measureTag(scene, tag, 1),
                                                        laboratory.measureTag(scene, tag, 2)};
                         for (Record &record : records) {
                           record = named(record, "apriltag", "octave " + std::to_string(octave + 1));
                         }
                         return records;
                       }});
  }
}

std::vector<Batch> batchesOf(const Settings &settings)
{
  std::vector<Batch> batches;
  if (settings.parts.count("limits") > 0) {
    addLimits(settings, batches);
  }
  if (settings.parts.count("model") > 0) {
    batches.push_back({MODEL, 2 * settings.frames, withAndWithout});
  }
  if (settings.parts.count("cells") > 0) {
    addCells(settings, batches);
  }
  if (settings.parts.count("apriltag") > 0) {
    addTags(settings, batches);
  }
  return batches;
}
} // namespace

std::string nameOf(const ThesisCell &cell)
{
  char name[64];
  std::snprintf(name, sizeof(name), "%g deg %g m", cell.maxTilt, cell.maxDepth);
  return name;
}

std::vector<Record> makeRecords(const Settings &settings, const Progress &progress)
{
  const std::vector<Batch> batches = batchesOf(settings);
  struct Item
  {
    std::size_t batch;
    unsigned int frame;
  };
  // Image by image through the batches, which differ in the time they take: so the time left can be told.
  std::vector<Item> items;
  for (unsigned int frame = 0, left = 1; left > 0; ++frame) {
    left = 0;
    for (std::size_t batch = 0; batch < batches.size(); ++batch) {
      if (frame < batches[batch].frames) {
        items.push_back({batch, frame});
        ++left;
      }
    }
  }
  std::vector<std::vector<Record>> made(items.size());
  forEachItem(
      items.size(), settings.jobs,
      [&]() {
        const auto laboratory = std::make_shared<Laboratory>(settings);
        return [&, laboratory](std::size_t i) {
          const Batch &batch = batches[items[i].batch];
          const std::uint64_t seed = mixed(mixed(mixed(settings.seed, 0), batch.key), items[i].frame);
          made[i] = batch.make(*laboratory, seed);
          for (Record &record : made[i]) {
            record.frame = items[i].frame;
          }
        };
      },
      progress);
  std::vector<Record> records;
  for (const auto &some : made) {
    records.insert(records.end(), some.begin(), some.end());
  }
  return records;
}
} // namespace accuracy
