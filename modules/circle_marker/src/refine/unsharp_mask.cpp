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
 * Sharpening of the camera: told from a marker's ring, and undone.
 */

#include "refine/unsharp_mask.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "refine/mask_fit.h"
#include "refine/plane_point.h"
#include "support/sensor_range.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// The ring is looked at along so many normals of its outer edge, up to so many pixels to either side.
constexpr int normals = 64;
constexpr int pixelsOfNormal = 9;
// As far as this share of the quiet zone, and of the white gap inside of the ring: beyond, something else shows through
// the mask. Inside of a plain ring anything may be printed, but this near to it, outer radii.
constexpr double shareOfWhite = 0.6;
constexpr double insideOfPlainRing = 0.06;
constexpr double insideOfDisc = 0.5;
// Between these limits, pixels and share, a mask is one. A narrower one is a sharper lens, a wider one a veil of light.
constexpr double leastSigma = 0.5;
constexpr double mostSigma = 5.;
constexpr double leastAmount = 0.1;
constexpr double mostAmount = 6.;
// What overshoots an edge by less than this share of the contrast, or is known no better, is none.
constexpr double leastOvershoot = 0.01;
// What is left of the mask after the last step of undoing it, share of its amount.
constexpr double leftOfMask = 0.05;

constexpr double noInnerEdge = 1e3; // pixels: a disc has none

std::vector<RingSample> samplesOf(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane &plane,
                                  const vpCircleMarkerLayout &layout)
{
  const bool isDisc = layout.ringInner == 0.;
  const double innermost = isDisc ? insideOfDisc
                           : layout.codeOuter > 0.
                               ? layout.ringInner - shareOfWhite * (layout.ringInner - layout.codeOuter)
                               : layout.ringInner - insideOfPlainRing;
  const double outermost = 1. + shareOfWhite * layout.quietZone;
  std::vector<RingSample> samples;
  samples.reserve(static_cast<std::size_t>(normals) * (2 * pixelsOfNormal + 1));
  for (int i = 0; i < normals; ++i) {
    const double angle = 2. * M_PI * i / normals;
    const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
    const Eigen::Vector2d rim = camera.toPixel(plane.project(direction));
    const PlanePoint atRim = planePoint({camera.toMeter(rim), camera.meterPerPixel(rim)}, plane);
    const Eigen::Vector2d across = (atRim.byPixel.transpose() * direction).normalized();
    for (int k = -pixelsOfNormal; k <= pixelsOfNormal; ++k) {
      const Eigen::Vector2d place = (rim + k * across).array().round();
      const bool isInside = place.x() >= 0. && place.y() >= 0. && place.x() < I.getWidth() && place.y() < I.getHeight();
      if (!isInside) {
        continue;
      }
      const int grey = I[static_cast<unsigned int>(place.y())][static_cast<unsigned int>(place.x())];
      const PlanePoint point = planePoint({camera.toMeter(place), camera.meterPerPixel(place)}, plane);
      const double radius = point.q.norm();
      if (radius < innermost || radius > outermost) {
        continue;
      }
      const double gradient = (point.byPixel.transpose() * point.q).norm() / radius;
      samples.push_back({static_cast<double>(grey), point.q, (radius - 1.) / gradient,
                         isDisc ? noInnerEdge : (radius - layout.ringInner) / gradient});
    }
  }
  return samples;
}

} // namespace

std::optional<UnsharpMask> unsharpMaskOf(const vpImage<unsigned char> &I, const CameraModel &camera,
                                         const Few<MarkerPlane> &poses, const vpCircleMarkerLayout &layout)
{
  std::optional<MaskFit> best;
  for (const MarkerPlane &plane : poses) {
    MaskFit fit(samplesOf(I, camera, plane, layout));
    if (fit.run() && (!best || fit.variance() < best->variance())) {
      best = fit;
    }
  }
  if (!best) {
    return std::nullopt;
  }
  const UnsharpMask mask = best->mask();
  const bool isMask = mask.amount > leastAmount && mask.amount < mostAmount && mask.sigma > leastSigma &&
                      mask.sigma < mostSigma && mask.halo > leastOvershoot && mask.amount > best->errorOfAmount();
  return isMask ? std::optional<UnsharpMask>(mask) : std::nullopt;
}

bool undo(const UnsharpMask &mask, const vpImage<unsigned char> &I, const cv::Rect &box, const Deadline &deadline,
          vpImage<unsigned char> &restored)
{
  const auto viewOf = [&box](const vpImage<unsigned char> &image) {
    const cv::Mat whole(static_cast<int>(image.getHeight()), static_cast<int>(image.getWidth()), CV_8U, image.bitmap);
    return whole(box);
  };
  if (restored.getHeight() != I.getHeight() || restored.getWidth() != I.getWidth()) {
    restored.resize(I.getHeight(), I.getWidth(), 0); // beyond the box a fit sees what it saw before, or black
  }
  const cv::Mat before = viewOf(I);
  cv::Mat sharpened;
  before.convertTo(sharpened, CV_32F);
  const cv::Mat isTooBright = before >= brightestTold;
  const cv::Mat isTooDark = before <= darkestTold;
  // f = (sharpened + a G f) / (1 + a), again and again: each step leaves a / (1 + a) of what is off, and less. A halo
  // that was cut off lies on plain paper or ink; halfway between that and the least it can be is nearest to it.
  const double share = mask.amount / (1. + mask.amount);
  const int steps = static_cast<int>(std::ceil(std::log(leftOfMask) / std::log(share)));
  cv::Mat image = sharpened.clone();
  cv::Mat blurred;
  for (int step = 0; step < std::max(steps, 1); ++step) {
    if (deadline.hasPassed()) {
      return false;
    }
    cv::GaussianBlur(image, blurred, cv::Size(), mask.sigma);
    cv::addWeighted(sharpened, 1. - share, blurred, share, 0., image);
    cv::Mat half;
    image.convertTo(half, CV_32F, 0.5, 0.5 * std::min(mask.white, 255.));
    half.copyTo(image, isTooBright);
    image.convertTo(half, CV_32F, 0.5, 0.5 * std::max(mask.ink, 0.));
    half.copyTo(image, isTooDark);
  }
  cv::Mat result = viewOf(restored);
  image.convertTo(result, CV_8U);
  return true;
}
} // namespace circle_marker
END_VISP_NAMESPACE
