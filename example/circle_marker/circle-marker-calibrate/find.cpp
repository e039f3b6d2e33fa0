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
 * Finds the target in a picture.
 */

#include "find.h"

#include <algorithm>
#include <cmath>

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "solve.h"

namespace calibrate {
namespace {
/*! The image's own memory; must not outlive it, nor be written to. */
cv::Mat matOf(const vpImage<unsigned char> &I)
{
  return cv::Mat(static_cast<int>(I.getHeight()), static_cast<int>(I.getWidth()), CV_8UC1,
                 const_cast<unsigned char *>(I.bitmap));
}

cv::Size sizeOf(const Target &target)
{
  return cv::Size(target.columns, target.rows);
}

Lens nominalLens(const vpImage<unsigned char> &I)
{
  const double focal = std::max(I.getWidth(), I.getHeight()); // ordinary lenses have about that
  return Lens::of(LensModel::Plain, focal, focal, 0.5 * (I.getWidth() - 1.), 0.5 * (I.getHeight() - 1.));
}

/*! Centre of the outline that the detector has fitted: the outline hardly depends on the camera it was told. */
std::optional<Eigen::Vector2d> outlineCenter(const vpCircleMarkerDetection &detection, const Lens &lens)
{
  TargetPose pose;
  for (unsigned int i = 0; i < 3; ++i) {
    pose.translation[i] = detection.cMo[i][3];
    for (unsigned int j = 0; j < 3; ++j) {
      pose.rotation(i, j) = detection.cMo[i][j];
    }
  }
  TargetPoint circle;
  circle.place.setZero();
  circle.radius = 0.5 * detection.size;
  const auto center = lens.project(pose.translation);
  return center ? std::optional<Eigen::Vector2d>(*center + centerOffset(lens, pose, circle)) : std::nullopt;
}

Search missing(const std::string &problem)
{
  return Search{std::nullopt, problem};
}

/*! Points in the target's order as a view. */
View viewOf(const std::vector<Eigen::Vector2d> &points)
{
  View view;
  for (std::size_t i = 0; i < points.size(); ++i) {
    view.observations.push_back(Observation{i, points[i]});
  }
  return view;
}

/*! Discs in the order of the grid; empty if OpenCV sees none in them. */
std::vector<Eigen::Vector2d> inOrder(const Target &target, const std::vector<Eigen::Vector2d> &centers)
{
  std::vector<cv::Point2f> candidates, ordered;
  for (const Eigen::Vector2d &c : centers) {
    candidates.emplace_back(static_cast<float>(c.x()), static_cast<float>(c.y()));
  }
  const int kind = target.kind == TargetKind::Grid ? cv::CALIB_CB_SYMMETRIC_GRID : cv::CALIB_CB_ASYMMETRIC_GRID;
  bool isFound = false;
  // Without a detector the "image" is the list of candidates.
  for (const int flags : {kind, kind | cv::CALIB_CB_CLUSTERING}) {
    isFound =
        isFound || cv::findCirclesGrid(candidates, sizeOf(target), ordered, flags, cv::Ptr<cv::FeatureDetector>());
  }
  std::vector<Eigen::Vector2d> result;
  for (const cv::Point2f &p : isFound ? ordered : std::vector<cv::Point2f>()) {
    // The measured centre itself, not the float.
    const Eigen::Vector2d rough(p.x, p.y);
    result.push_back(*std::min_element(centers.begin(), centers.end(), [&](const auto &a, const auto &b) {
      return (a - rough).squaredNorm() < (b - rough).squaredNorm();
    }));
  }
  return result;
}
} // namespace

std::vector<Eigen::Vector2d> blobCenters(const Target &target, const vpImage<unsigned char> &I)
{
  std::vector<cv::Point2f> centers;
  const int kind = target.kind == TargetKind::Grid ? cv::CALIB_CB_SYMMETRIC_GRID : cv::CALIB_CB_ASYMMETRIC_GRID;
  std::vector<Eigen::Vector2d> result;
  if (cv::findCirclesGrid(matOf(I), sizeOf(target), centers, kind)) {
    for (const cv::Point2f &p : centers) {
      result.emplace_back(p.x, p.y);
    }
  }
  return result;
}

Finder::Finder(const Target &target) : m_target(target), m_detector(target.family)
{
  m_detector.setZAlignedWithCameraAxis(true);
}

Search Finder::find(const vpImage<unsigned char> &I, const std::string &name, const std::optional<Lens> &lens)
{
  const Lens known = lens.value_or(nominalLens(I));
  Search search = m_target.kind == TargetKind::Chessboard
                      ? findChessboard(I)
                      : (m_target.kind == TargetKind::Markers ? findMarkers(I, known) : findGrid(I, known));
  if (search.view) {
    search.view->name = name;
    search.view->width = I.getWidth();
    search.view->height = I.getHeight();
  }
  return search;
}

Search Finder::findChessboard(const vpImage<unsigned char> &I) const
{
  const cv::Mat image = matOf(I);
  std::vector<cv::Point2f> corners;
  const int flags = cv::CALIB_CB_EXHAUSTIVE | cv::CALIB_CB_ACCURACY;
  if (!cv::findChessboardCornersSB(image, sizeOf(m_target), corners, flags)) {
    return missing("no chessboard of " + std::to_string(m_target.columns) + " x " + std::to_string(m_target.rows) +
                   " inner corners is seen whole; --columns and --rows count inner corners");
  }
  std::vector<Eigen::Vector2d> points;
  for (const cv::Point2f &p : corners) {
    points.emplace_back(p.x, p.y);
  }
  return Search{viewOf(points), ""};
}

Search Finder::findGrid(const vpImage<unsigned char> &I, const Lens &lens)
{
  std::vector<vpHomogeneousMatrix> cMo;
  const double diameter = 2. * m_target.points.front().radius;
  vpImage<unsigned char> inverted(I.getHeight(), I.getWidth());
  std::transform(I.bitmap, I.bitmap + I.getSize(), inverted.bitmap,
                 [](unsigned char grey) { return static_cast<unsigned char>(255 - grey); });
  // Black discs on white; then white ones on black.
  for (const vpImage<unsigned char> *image : {&I, const_cast<const vpImage<unsigned char> *>(&inverted)}) {
    m_detector.detect(*image, diameter, lens.parameters(I.getWidth(), I.getHeight()), cMo);
    std::vector<Eigen::Vector2d> centers;
    for (const vpCircleMarkerDetection &detection : m_detector.getDetections()) {
      if (const auto center = outlineCenter(detection, lens)) {
        centers.push_back(*center);
      }
    }
    if (centers.size() >= m_target.points.size()) {
      const auto points = inOrder(m_target, centers);
      if (points.size() == m_target.points.size()) {
        return Search{viewOf(points), ""};
      }
    }
  }
  const auto points = blobCenters(m_target, I);
  if (points.size() != m_target.points.size()) {
    return missing("no grid of " + std::to_string(m_target.columns) + " x " + std::to_string(m_target.rows) +
                   " discs is seen whole; check --columns and --rows, and that no disc is hidden");
  }
  return Search{viewOf(points), ""};
}

Search Finder::findMarkers(const vpImage<unsigned char> &I, const Lens &lens)
{
  std::vector<vpHomogeneousMatrix> cMo;
  const double diameter = 2. * m_target.points.front().radius;
  m_detector.detect(I, diameter, lens.parameters(I.getWidth(), I.getHeight()), cMo);
  View view;
  for (const vpCircleMarkerDetection &detection : m_detector.getDetections()) {
    for (std::size_t i = 0; i < m_target.points.size(); ++i) {
      const auto center = m_target.points[i].id == detection.id ? outlineCenter(detection, lens) : std::nullopt;
      const bool isNew = std::none_of(view.observations.begin(), view.observations.end(),
                                      [i](const Observation &o) { return o.point == i; });
      if (center && isNew) {
        view.observations.push_back(Observation{i, *center});
      }
    }
  }
  if (view.observations.size() < 4) {
    return missing(std::to_string(view.observations.size()) + " of the sheet's " +
                   std::to_string(m_target.points.size()) + " markers are seen; at least 4 are needed");
  }
  return Search{view, ""};
}
} // namespace calibrate
