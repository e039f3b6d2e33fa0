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
 * A few pixels across the edges of a marker.
 */

#include "refine/few_pixels.h"

#include <algorithm>
#include <cmath>

#include "refine/plane_point.h"
#include "refine/surround.h"
#include "support/normal_distribution.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Rows across each circle of the ring, and across each border between sectors.
constexpr int rowsOfCircle = 24;
constexpr int rowsOfBorder = 2;
// A row's pixels lie up to this many standard deviations of the blur to either side of the edge.
constexpr int pixelsOfRow = 5;
constexpr double reach = 2.6;
// A pixel that may see more than this share of the surround, of which nothing is known here, is left out.
constexpr double mostSurround = 0.02;
// A pixel's centre is off the row by this, pixels, at most.
constexpr double toCentre = 0.71;

// Puts the rows of one hypothesis.
class Rows
{
public:
  Rows(const vpImage<unsigned char> &I, const CameraModel &camera, const ImageFrame &frame, const MarkerPlane &plane,
       const BlurParameters &blur, double outermost, std::vector<FitPixel> &pixels)
      : m_image(I), m_camera(camera), m_frame(frame), m_plane(plane), m_blur(blur.sigma), m_blurShape(blur.shape()),
        m_outermost(outermost), m_pixels(pixels)
  {
  }

  // A row across an edge at the point q of the plane; across: a direction of the plane that leads off the edge.
  void put(const Eigen::Vector2d &q, const Eigen::Vector2d &across)
  {
    const Eigen::Vector2d p = m_camera.toPixel(m_plane.project(q));
    const PlanePoint point = planePoint({m_camera.toMeter(p), m_camera.meterPerPixel(p)}, m_plane);
    const Eigen::Vector2d normal = (point.byPixel.transpose() * across).normalized();
    const double blur = m_blur * (m_blurShape * normal).norm();
    // Along a row the radius changes by no more than this; few rows come near to where the paper may end.
    const double change = (reach * blur + toCentre) * point.byPixel.norm();
    const double gradient = (m_blurShape * point.byPixel.transpose() * q.normalized()).norm();
    const bool mayEnd = q.norm() + change > m_outermost - clearOfSurround * gradient * m_blur;
    for (int k = 0; k < pixelsOfRow; ++k) {
      const double along = reach * blur * (2. * k / (pixelsOfRow - 1.) - 1.);
      const Eigen::Vector2d upper = (p + along * normal).array() + 0.5; // rounded by what is cut off
      const bool isInside =
          upper.x() >= 0. && upper.y() >= 0. && upper.x() < m_image.getWidth() && upper.y() < m_image.getHeight();
      if (!isInside) {
        continue;
      }
      const auto u = static_cast<unsigned int>(upper.x());
      const auto v = static_cast<unsigned int>(upper.y());
      const Eigen::Vector2d where(u, v);
      const Eigen::Vector2d meter = m_camera.toMeter(where);
      const double share = mayEnd ? shareBeyond(meter, gradient) : 0.;
      if (share <= mostSurround) {
        add(where, meter, share).grey = m_image[v][u];
      }
    }
  }

private:
  // Share of what a pixel sees that may lie beyond the paper; gradient: of the radius, 1 / pixel.
  double shareBeyond(const Eigen::Vector2d &meter, double gradient) const
  {
    const double radius = m_plane.intersect(meter).norm();
    return NormalDistribution::instance().at((radius - m_outermost) / (gradient * m_blur)).cumulative;
  }

  // Without its grey level.
  FitPixel &add(const Eigen::Vector2d &where, const Eigen::Vector2d &meter, double share)
  {
    FitPixel &pixel = m_pixels.emplace_back();
    pixel.meter = meter.cast<float>();
    pixel.meterPerPixel = m_camera.meterPerPixel(where).cast<float>();
    pixel.offset = ((where - m_frame.center) / m_frame.size).cast<float>();
    if (share > leastSurround) { // nobody has looked there
      BeyondPaper &beyond = pixel.beyond[static_cast<std::size_t>(PaperShape::ROUND)];
      beyond.share = static_cast<float>(share);
      beyond.spread = HUGE_VALF;
    }
    return pixel;
  }

  const vpImage<unsigned char> &m_image;
  const CameraModel &m_camera;
  const ImageFrame m_frame;
  const MarkerPlane &m_plane;
  const double m_blur; // pixels, where it is round
  const Eigen::Matrix2d m_blurShape;
  const double m_outermost;
  std::vector<FitPixel> &m_pixels;
};
} // namespace

void selectFewPixels(const vpImage<unsigned char> &I, const CameraModel &camera, const ImageFrame &frame,
                     const MarkerPlane *planes, std::size_t count, const MarkerPattern &pattern,
                     const BlurParameters &blur, std::vector<FitPixel> &pixels)
{
  pixels.clear();
  const int hypotheses = static_cast<int>(count);
  for (int h = 0; h < hypotheses; ++h) {
    Rows rows(I, camera, frame, planes[h], blur, pattern.paper[0].extent, pixels);
    for (unsigned int i = 0; i < pattern.ringEdges; ++i) {
      for (int k = h; k < rowsOfCircle; k += hypotheses) {
        // The two circles' rows alternate in angle.
        const double angle = 2. * M_PI * (k + 0.5 * i) / rowsOfCircle;
        const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
        rows.put(pattern.ring[i].radius * direction, direction);
      }
    }
    for (int k = 0; k < static_cast<int>(pattern.sectors); ++k) {
      const Eigen::Vector2d &across = pattern.acrossBorder(k);
      const Eigen::Vector2d along(across.y(), -across.x());
      if (pattern.isBlack(k) != pattern.isBlack(k - 1)) {
        for (int i = h; i < rowsOfBorder; i += hypotheses) {
          const double share = (i + 1.) / (rowsOfBorder + 1.);
          rows.put((pattern.track[1].radius + share * (pattern.track[0].radius - pattern.track[1].radius)) * along,
                   across);
        }
      }
      // A black sector's rims, in turn.
      if (pattern.isBlack(k) && k % hypotheses == h) {
        const double angle = 2. * M_PI * (k + 0.5) / pattern.sectors;
        const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
        rows.put(pattern.track[(k / hypotheses) % 2].radius * direction, direction);
      }
    }
  }
}
} // namespace circle_marker
END_VISP_NAMESPACE
