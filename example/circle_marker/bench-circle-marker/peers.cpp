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
 * What others take for a frame: ViSP's AprilTag, OpenCV's threshold and edges.
 */

#include "peers.h"

#include <memory>

#include <opencv2/imgproc.hpp>

#include <visp3/circle_marker/vpDetectorCircleMarker.h>
#include <visp3/detection/vpDetectorAprilTag.h>

namespace bench {
namespace {
cv::Mat pixelsOf(const Scene &scene)
{
  return cv::Mat(static_cast<int>(scene.image.getHeight()), static_cast<int>(scene.image.getWidth()), CV_8U,
                 const_cast<unsigned char *>(scene.image.bitmap));
}

#if defined(VISP_HAVE_APRILTAG)
Peer aprilTag(float decimation)
{
  const auto detector = std::make_shared<vpDetectorAprilTag>(vpDetectorAprilTag::TAG_36h11);
  detector->setAprilTagQuadDecimate(decimation);
  detector->setAprilTagNbThreads(1);
  return {"apriltag-decimation-" + std::to_string(static_cast<int>(decimation)),
          [detector](const Scene &scene) { detector->detect(scene.image); }};
}
#endif
} // namespace

Peer circleMarker(unsigned int threads, bool refine)
{
  const auto detector = std::make_shared<vpDetectorCircleMarker>(vpCircleMarkerFamily::GOLAY23);
  detector->setNbThreads(threads);
  detector->setRefinePose(refine);
  const auto poses = std::make_shared<std::vector<vpHomogeneousMatrix>>();
  std::string name = threads == 1 ? "circle-marker" : "circle-marker-threads-" + std::to_string(threads);
  if (!refine) {
    name += "-unrefined";
  }
  return {name,
          [detector, poses](const Scene &scene) { detector->detect(scene.image, markerSize, scene.camera, *poses); }};
}

Peer trackingCircleMarker(bool refine)
{
  const auto detector = std::make_shared<vpDetectorCircleMarker>(vpCircleMarkerFamily::GOLAY23);
  constexpr unsigned int longest = 1000000; // frames between searches of the whole: none but the first is measured
  detector->setTracking(true, longest);
  detector->setRefinePose(refine);
  const auto poses = std::make_shared<std::vector<vpHomogeneousMatrix>>();
  return {refine ? "circle-marker-tracking" : "circle-marker-tracking-unrefined",
          [detector, poses](const Scene &scene) { detector->detect(scene.image, markerSize, scene.camera, *poses); }};
}

std::vector<Peer> peers()
{
  std::vector<Peer> all;
#if defined(VISP_HAVE_APRILTAG)
  all.push_back(aprilTag(1.F));
  all.push_back(aprilTag(2.F));
#endif
  const auto result = std::make_shared<cv::Mat>();
  all.push_back({"adaptive-threshold-23", [result](const Scene &scene) {
                   cv::adaptiveThreshold(pixelsOf(scene), *result, 255, cv::ADAPTIVE_THRESH_MEAN_C, cv::THRESH_BINARY,
                                         23, 7.);
                 }});
  all.push_back({"canny", [result](const Scene &scene) { cv::Canny(pixelsOf(scene), *result, 50., 100.); }});
  return all;
}
} // namespace bench
