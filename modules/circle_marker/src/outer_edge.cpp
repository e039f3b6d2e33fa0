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
 * The outer edge of a measured marker: how much of it is seen, and whether it has a halo.
 */

#include "outer_edge.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Geometry>

#include "support/bilinear.h"
#include "support/median.h"
#include "support/normal_distribution.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// The outer edge is looked at in so many directions, on either side of it by this part of the blur, where a tenth of
// the other side is left, and by no more than this share of the radius: ring and quiet zone are twice as wide.
constexpr int directionsOfEdge = 180;
constexpr double besideEdge = 1.25;
constexpr double mostBesideEdge = 0.08;
// The grey levels there may be off by this share of the contrast, and by so many standard deviations of the noise.
constexpr double sameLevel = 0.2;
constexpr double sameLevelOfNoise = 3.;

// A halo is looked for in so many directions, on either side of the edge at such distances, pixels, inside of the quiet
// zone to this share of the radius, and inside of half the ring. A fit may take the halo for the paper's grey: then it
// is the paper beyond that is off. Nearer to the edge interpolation between pixels leaves as much.
constexpr int directionsOfHalo = 36;
constexpr std::array<double, 6> distancesOfHalo = {-3.75, -2.25, -1.5, 1.5, 2.25, 3.75};
constexpr double mostBesideHalo = 0.12;
// Medians are off by 1.25 standard deviations of their numbers' mean; by twice that with one of six, by chance.
constexpr double deviationsOfMedian = 2.5;
// Interpolation between pixels blurs, too: its variance is 1/6 in the mean, pixels^2.
constexpr double blurOfInterpolation = 0.41;
// It moves the edges by so many pixels, times the halo and by the radius in pixels: the halos of the ring's two edges
// overlap, and the code's. (Unsharp masks of 1 to 2 times the detail and 1 to 2 pixels moved those of 20 to 250 pixels
// by 0.004 to 0.045 pixels, 3 to 21 in these units.)
constexpr double shiftOfHalo = 14.;
constexpr double leastCosine = 0.2; // of the tilt: at 80 degrees, beyond which the ring is seldom as wide as a halo
// In a blur that is wider than this, standard deviation, pixels, it is the blur's shape that is seen
// (refine/blur_shape.h).
constexpr double widestBlur = 1.2;
// White and black of a marker in uneven light are known to this share of the contrast, standard deviation, as Gaussians
// are not the light's shape; and are off alike over so many outer radii, as far as the Gaussians are apart.
constexpr double errorOfLight = 0.005;
constexpr double lengthOfLight = 0.5;
// From this halo on less than half of the odds is believed: of one of 0.2 mirrored poses came first with e^11 and e^32.
constexpr double halvingHalo = 0.06;

// Where the outer edge is crossed in a direction from the centre.
struct Crossing
{
  Eigen::Vector2d rim;    // pixels
  Eigen::Vector2d across; // unit normal of the edge, outward
  double reach = 0.;      // along it, to a share of the radius, pixels
  double blur = 0.;       // along it, standard deviation, pixels
};

Crossing crossingAt(const MeasuredRing &ring, const CameraModel &camera, double angle, double share)
{
  const Eigen::Vector2d toRim(std::cos(angle), std::sin(angle));
  const auto pixelAt = [&](const Eigen::Vector2d &q) { return camera.toPixel(ring.plane.project(q)); };
  // Across the edge: from afar it is slanted to the direction from the centre.
  const double outer = 1. + ring.photometry.blur.spread;
  Crossing crossing;
  crossing.rim = pixelAt(outer * toRim);
  const Eigen::Vector2d along = pixelAt(outer * toRim + 0.01 * Eigen::Vector2d(-toRim.y(), toRim.x())) - crossing.rim;
  const Eigen::Vector2d beyond = pixelAt((outer + share) * toRim) - crossing.rim;
  crossing.across = Eigen::Vector2d(along.y(), -along.x()).normalized();
  crossing.across *= crossing.across.dot(beyond) < 0. ? -1. : 1.;
  crossing.reach = crossing.across.dot(beyond);
  crossing.blur = ring.photometry.blur.along(crossing.across);
  return crossing;
}

// Share of what lies inside of a straight edge that is seen at a distance outside of it, pixels.
double insideAt(const Crossing &crossing, double distance)
{
  return NormalDistribution::instance().at(-distance / crossing.blur).cumulative;
}

// Semi-major axis of a marker's image, pixels: whatever its spin, the greatest stretch of the plane's unit vectors.
double radiusOf(const MarkerPlane &plane, const CameraModel &camera)
{
  const auto halfAlong = [&](const Eigen::Vector2d &q) -> Eigen::Vector2d {
    return 0.5 * (camera.toPixel(plane.project(q)) - camera.toPixel(plane.project(-q)));
  };
  Eigen::Matrix2d byPlane;
  byPlane << halfAlong(Eigen::Vector2d::UnitX()), halfAlong(Eigen::Vector2d::UnitY());
  const double sum = byPlane.squaredNorm(); // of the squares of both stretches, and their product
  const double product = byPlane.determinant();
  return std::sqrt(0.5 * (sum + std::sqrt(std::max(sum * sum - 4. * product * product, 0.))));
}

// What moves the edges outward or inward moves the depth, by the same share; and the tilt, as in the short direction of
// the ellipse, where the ring is narrower, they are moved more.
// shift: pixels; radius: of the marker's image.
void addShiftDoubt(double shift, double radius, FittedPose &fit)
{
  const MarkerPlane &plane = fit.plane;
  const double share = shift / radius;
  const Eigen::Vector3d moved = share * plane.center;
  fit.covariance.topLeftCorner<3, 3>() += moved * moved.transpose();
  const Eigen::Vector3d sight = plane.center.normalized();
  const Eigen::Vector3d axis = plane.rotation.col(2).cross(sight); // as long as the sine of the tilt
  const double cosine = std::max(plane.rotation.col(2).dot(sight), leastCosine);
  const Eigen::Vector3d turned = share / cosine * axis;
  fit.covariance.bottomRightCorner<3, 3>() += turned * turned.transpose();
}
} // namespace

MeasuredRing ringOf(const Measurement &measurement, const MarkerPlane &start, const CameraModel &camera, bool isFirst)
{
  const FittedPose &fit = isFirst ? measurement.first : *measurement.second;
  return {fit.plane, frameOf(start, camera), fit.photometry, fit.noise, measurement.uneven};
}

double visibleEdgeOf(const vpImage<unsigned char> &I, const CameraModel &camera, const Recognition &marker,
                     const Measurement &measurement)
{
  const MeasuredRing ring = ringOf(measurement, marker.poses[0], camera);
  const double slack = sameLevel + sameLevelOfNoise * ring.noiseOfLevel();
  int visible = 0;
  for (int i = 0; i < directionsOfEdge; ++i) {
    const Crossing crossing = crossingAt(ring, camera, 2. * M_PI * i / directionsOfEdge, mostBesideEdge);
    const double beside = std::min(besideEdge * crossing.blur, crossing.reach); // pixels
    const auto isLevel = [&](double distance) {
      const Eigen::Vector2d place = crossing.rim + distance * crossing.across;
      const auto grey = bilinear(I, place);
      if (!grey) {
        return false;
      }
      const double below = 1. - insideAt(crossing, distance) - ring.levelAt(place, *grey);
      return std::abs(below) < slack || (ring.isCutOff(place, *grey) && below > 0.);
    };
    visible += isLevel(beside) && isLevel(-beside) ? 1 : 0;
  }
  return static_cast<double>(visible) / directionsOfEdge;
}

std::optional<double> haloOf(const vpImage<unsigned char> &I, const CameraModel &camera, const Recognition &marker,
                             const Measurement &measurement)
{
  const MeasuredRing ring = ringOf(measurement, marker.poses[0], camera);
  const double width = 1. - marker.family.getLayout().ringInner; // of the ring, outer radii
  std::array<std::array<double, directionsOfHalo>, distancesOfHalo.size()> off;
  std::array<std::size_t, distancesOfHalo.size()> counts{};
  for (int i = 0; i < directionsOfHalo; ++i) {
    Crossing crossing = crossingAt(ring, camera, 2. * M_PI * i / directionsOfHalo, width);
    crossing.blur = std::hypot(crossing.blur, blurOfInterpolation);
    const double toInner = crossing.reach; // the ring's other edge, pixels
    for (std::size_t k = 0; k < distancesOfHalo.size(); ++k) {
      const double distance = distancesOfHalo[k];
      const Eigen::Vector2d place = crossing.rim + distance * crossing.across;
      if (distance > mostBesideHalo / width * toInner || distance < -0.5 * toInner) {
        continue;
      }
      const auto grey = bilinear(I, place);
      if (grey && !ring.isCutOff(place, *grey)) {
        const double ink = insideAt(crossing, distance) - insideAt(crossing, distance + toInner);
        off[k][counts[k]++] = ring.levelAt(place, *grey) - (1. - ink);
      }
    }
  }
  std::optional<double> halo;
  for (std::size_t k = 0; k < distancesOfHalo.size(); ++k) {
    if (counts[k] >= directionsOfHalo / 4) {
      const double byChance = deviationsOfMedian * ring.noiseOfLevel() / std::sqrt(static_cast<double>(counts[k]));
      halo = std::clamp(std::abs(medianOf(off[k], counts[k])) - byChance, halo.value_or(0.), 1.);
    }
  }
  return halo;
}

void addHaloDoubt(double halo, const CameraModel &camera, Measurement &measurement)
{
  if (halo == 0. || measurement.first.photometry.blur.widest() > widestBlur) {
    return;
  }
  const double radius = radiusOf(measurement.first.plane, camera);
  forEachPose(measurement, [&](FittedPose &fit) { addShiftDoubt(shiftOfHalo * halo / radius, radius, fit); });
  const double believed = 1. / (1. + halo * halo / (halvingHalo * halvingHalo));
  measurement.cost2 = measurement.cost + believed * (measurement.cost2 - measurement.cost);
}

void addLightDoubt(const CameraModel &camera, Measurement &measurement)
{
  if (!measurement.uneven) {
    return;
  }
  const FittedPose &fit = measurement.first;
  // Pixels of an edge along which white and black are off alike.
  const double widthOfEdge = std::sqrt(2. * M_PI) * fit.photometry.blur.widest();
  const double alike = std::max(widthOfEdge * lengthOfLight * radiusOf(fit.plane, camera), 1.);
  const double off = errorOfLight * fit.photometry.tellableContrast();
  const double sharing = 1. + alike * off * off / (fit.noise * fit.noise);
  forEachPose(measurement, [sharing](FittedPose &pose) { pose.covariance *= sharing; });
  measurement.cost2 = measurement.cost + (measurement.cost2 - measurement.cost) / sharing;
}
} // namespace circle_marker
END_VISP_NAMESPACE
