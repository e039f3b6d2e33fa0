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
 * How well the image of a marker tells it from the others of its code.
 */

#include <algorithm>
#include <cmath>
#include <numeric>

#include <visp3/circle_marker_simulator/vpMarkerSceneSimulator.h>

#include "reading.h"

namespace experiments {
namespace {
/*! The same marker with one sector or cell the other way round. */
vpSimulatedMarker flipped(const vpSimulatedMarker &marker, unsigned int place)
{
  vpSimulatedMarker other = marker;
  if (marker.getCodeword()) {
    std::vector<std::array<double, 2>> rings = marker.getRings();
    if (rings.empty()) {
      rings.push_back({marker.getRingRatio(), 1.});
    }
    other = vpSimulatedMarker::rings(rings, marker.getSize());
    other.setTrack(marker.getTrackInner(), marker.getTrackOuter(), marker.getNbSectors(),
                   *marker.getCodeword() ^ (1u << place), marker.hasWindows());
  }
  else {
    vpImage<unsigned char> picture = marker.getPicture();
    const unsigned int side = picture.getWidth() - 2; // Within the black border.
    unsigned char &cell = picture[1 + place / side][1 + place % side];
    cell = static_cast<unsigned char>(255 - cell);
    other = vpSimulatedMarker::bitmap(picture, marker.getSize(), marker.getHeight());
  }
  other.setSheetSide(marker.getSheetWidth());
  return other.setPose(marker.getPose());
}

/*! Sees the marker and little else: the principal point counts from the first pixel of the part. */
vpMarkerSceneSimulator cameraAround(const vpSimulatedMarker &marker, const Scene &scene)
{
  constexpr double room = 8.; // Pixels on either side: blur and pixels.
  const vpHomogeneousMatrix &cMo = marker.getPose();
  const double px = scene.cam.get_px();
  const double u = scene.cam.get_u0() + px * cMo[0][3] / cMo[2][3];
  const double v = scene.cam.get_v0() + px * cMo[1][3] / cMo[2][3];
  // Twice the sheet's half side holds its diagonal, and the nearer edge of a tilted sheet.
  const double half = px * marker.getSheetWidth() / cMo[2][3] + room;
  const auto side = static_cast<unsigned int>(2. * std::ceil(half));
  vpCameraParameters cam(px, scene.cam.get_py(), scene.cam.get_u0() - std::round(u - half),
                         scene.cam.get_v0() - std::round(v - half));
  vpMarkerSceneSimulator camera(cam, side, side);
  vpScenePhotometry photometry = scene.photometry;
  photometry.noiseSigma = 0.;
  camera.setPhotometry(photometry);
  return camera;
}

vpImage<float> imageOf(vpMarkerSceneSimulator &camera, const vpSimulatedMarker &marker)
{
  camera.clearMarkers();
  camera.addMarker(marker);
  vpImage<float> image;
  camera.renderNoiseFree(image);
  return image;
}
} // namespace

double readingDistance(const vpSimulatedMarker &marker, unsigned int distance, const Scene &scene)
{
  const unsigned int cells = marker.getPicture().getWidth() > 2 ? marker.getPicture().getWidth() - 2 : 0;
  const unsigned int places = marker.getCodeword() ? marker.getNbSectors() : cells * cells;
  vpMarkerSceneSimulator camera = cameraAround(marker, scene);
  const vpImage<float> image = imageOf(camera, marker);
  std::vector<double> squares;
  for (unsigned int place = 0; place < places; ++place) {
    const vpImage<float> other = imageOf(camera, flipped(marker, place));
    double square = 0.;
    for (unsigned int i = 0; i < image.getSize(); ++i) {
      const double difference = static_cast<double>(image.bitmap[i]) - static_cast<double>(other.bitmap[i]);
      square += difference * difference;
    }
    squares.push_back(square);
  }
  std::sort(squares.begin(), squares.end());
  squares.resize(std::min<std::size_t>(squares.size(), distance));
  return std::sqrt(std::accumulate(squares.begin(), squares.end(), 0.)) / scene.photometry.noiseSigma;
}
} // namespace experiments
