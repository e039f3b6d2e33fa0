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
 * Options of the detector that several programs take.
 */

#include "detector_options.h"

#include <algorithm>
#include <sstream>

#include <CLI/CLI.hpp>

#include "../arguments.h"

namespace tutorial {
namespace {
std::vector<vpCircleMarkerFamily> familiesOf(const std::string &names, const std::optional<double> &ratio)
{
  std::vector<vpCircleMarkerFamily> families;
  bool ratioUsed = false;
  for (const std::string &name : splitAtCommas(names)) {
    const vpCircleMarkerFamily family = vpCircleMarkerFamily::fromName(name);
    const bool isRing = family.getType() == vpCircleMarkerFamily::RING;
    ratioUsed = ratioUsed || isRing;
    families.push_back(isRing && ratio ? vpCircleMarkerFamily::ring(*ratio) : family);
  }
  if (families.empty()) {
    throw UsageError("--family names no family; use golay23, bch31, bch31r, ring or disc");
  }
  if (ratio && !ratioUsed) {
    throw UsageError("--ratio is for the family ring; leave it out or add --family ring");
  }
  return families;
}

double checkedSize(double size, const std::string &option)
{
  constexpr double most = 1000.; // metres, more than is printed anywhere
  if (!(size > 0. && size <= most)) {
    throw UsageError(option +
                     " is the outer diameter of the ring in metres, positive and no more than 1000, for instance 0.18");
  }
  return size;
}

/*! Sizes as in 3:0.1,4:0.2. */
std::map<int, double> sizesOf(const std::string &text)
{
  std::map<int, double> sizes;
  for (const std::string &part : splitAtCommas(text)) {
    std::istringstream in(part);
    int id = 0;
    char colon = 0;
    double size = 0.;
    if (!(in >> id >> colon >> size) || colon != ':' || id < 0 || in.peek() != std::istringstream::traits_type::eof()) {
      throw UsageError("--sizes takes ids and diameters in metres, as 3:0.1,4:0.2, not \"" + part + "\"");
    }
    if (!sizes.emplace(id, checkedSize(size, "--sizes")).second) {
      throw UsageError("--sizes has the marker " + std::to_string(id) + " twice");
    }
  }
  return sizes;
}

void checkSizesHaveMarkers(const std::map<int, double> &sizes, const std::vector<vpCircleMarkerFamily> &families)
{
  for (const auto &[id, size] : sizes) {
    const bool isThere = std::any_of(families.begin(), families.end(), [id = id](const vpCircleMarkerFamily &family) {
      return id < static_cast<int>(family.getNbIds());
    });
    if (!isThere) {
      throw UsageError("--sizes has a marker " + std::to_string(id) +
                       ", but no family that is looked for has one; check the id and --family");
    }
  }
}
} // namespace

std::vector<std::string> splitAtCommas(const std::string &text)
{
  std::vector<std::string> parts;
  std::istringstream in(text);
  std::string part;
  while (std::getline(in, part, ',')) {
    parts.push_back(part);
  }
  return parts;
}

void DetectorOptions::addTo(CLI::App &app)
{
  app.add_option("--size", size, "Outer diameter of the black ring, metres")->required();
  app.add_option("--sizes", sizes, "Diameters of single markers, as 3:0.1,4:0.2");
  app.add_option(
      "--family", families,
      "golay23, bch31r, bch31, ring, disc, or several with commas; golay23 or those of --config unless told. A "
      "marker of bch31r is one of bch31, too: of the two the one that is named first is taken");
  app.add_option("--ratio", ratio, "Inner over outer radius of the family ring");
  app.add_option("--hamming", hamming, "Most sectors of a code that are corrected")->check(CLI::Range(0U, 5U));
  app.add_option("--config", configFile, "Settings of vpDetectorCircleMarker, JSON; other options go before it");
  app.add_option("--database", databaseFile,
                 "What is known of the markers, JSON of vpCircleMarkerDatabase: their sizes go before --size and "
                 "--sizes, their names and payloads are told with them");
  app.add_option("--nthreads", threads, "Number of threads")->check(CLI::Range(1U, 1024U));
  app.add_option("--tracking", tracking,
                 "Follows markers from image to image: only every N-th is searched whole, or when a marker is lost")
      ->check(CLI::Range(1U, 1000U));
}

DetectorSettings DetectorOptions::settings() const
{
  DetectorSettings result;
  result.size = checkedSize(size, "--size");
  result.sizes = sizesOf(sizes);
  result.configFile = configFile;
  result.databaseFile = databaseFile;
  result.hamming = hamming;
  result.threads = threads;
  result.tracking = tracking;
  if (families || ratio || configFile.empty()) {
    try {
      result.families = familiesOf(families.value_or(ratio ? "ring" : "golay23"), ratio);
    }
    catch (const vpException &e) {
      throw UsageError(e.what());
    }
  }
  return result;
}

//! [Settings]
vpDetectorCircleMarker makeDetector(const DetectorSettings &settings)
{
  vpDetectorCircleMarker detector;
  if (!settings.configFile.empty()) {
    detector.loadConfigFile(settings.configFile);
  }
  if (!settings.families.empty()) {
    detector.setFamilies(settings.families);
  }
  if (!settings.sizes.empty()) {
    checkSizesHaveMarkers(settings.sizes, detector.getFamilies());
    detector.setMarkerSizes(settings.sizes);
  }
  if (!settings.databaseFile.empty()) {
    vpCircleMarkerDatabase database;
    database.load(settings.databaseFile);
    detector.setDatabase(database);
  }
  if (settings.hamming) {
    detector.setMaximumHammingDistance(*settings.hamming);
  }
  if (settings.threads) {
    detector.setNbThreads(*settings.threads);
  }
  if (settings.tracking) {
    detector.setTracking(true, *settings.tracking);
  }
  detector.setTimeout(settings.timeout);
  detector.setZAlignedWithCameraAxis(true);
  return detector;
}
//! [Settings]
} // namespace tutorial
