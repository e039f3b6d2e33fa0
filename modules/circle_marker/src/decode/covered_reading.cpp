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
 * Sectors of a code track of which something covers a part.
 */

#include "decode/covered_reading.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>

#include "decode/marker_light.h"
#include "decode/usual_ink.h"
#include "support/bilinear.h"
#include "support/median.h"
#include "support/normal_distribution.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Share of the ring that must be seen: a straight edge that covers 40 % of the disc leaves 55 % of the ring.
constexpr double leastRing = 0.34;
// A direction shows the ring if its step is this share of the usual one, on its outside, and on its inside.
constexpr double leastOuterStep = 0.6;
constexpr double leastInnerStep = 0.4;
// White beside the track differs from the light by this share of it at most, and by more where that differs from its
// plane more, up to a bound.
constexpr double sameWhite = 0.03;
constexpr double sameWhiteOfScatter = 4.;
constexpr double mostSameWhite = 0.15;
// Grey levels of the track lie between black and white to this share of the contrast.
constexpr double beyondBlackAndWhite = 0.35;
// Blur, in radii, from which the three samples across the track see the same.
constexpr double muchBlur = 0.08;
// And the most that they differ by below it, share of the contrast.
constexpr double sameAcross = 0.5;
// Weight of a direction whose ring is covered, or its track seen in its outer part only.
constexpr double notAllSeen = 0.6;
// What covers a part of the ring is as white as paper to this share of the light.
constexpr double whiteCover = 0.25;
// Where the white centre is read, in units of the track's inner radius.
constexpr double whiteOfCenter = 0.75;
// Holds the slope of the light to none where the directions that are seen do not fix it: share of their number.
constexpr double ridge = 0.02;
// Every eighth direction is asked first whether there is a ring at all.
constexpr unsigned int firstStride = 8;
constexpr double leastRingAtFirst = 0.25;

/*! Radii at which each direction is looked at, from the outside. */
enum Place : std::size_t
{
  OUTSIDE,
  RING,
  GAP,
  TRACK_OUTER,
  TRACK_MIDDLE,
  TRACK_INNER,
  CENTER
};
constexpr std::size_t places = 7;

/*! One direction from the marker's centre. */
struct Direction
{
  double c = 0.; // cosine and sine of its angle
  double s = 0.;
  std::array<double, places> grey;  // NaN outside of the image
  std::array<double, places> white; // share of white where the sector is white, as the blur leaves it
  std::array<double, places> black; // and where it is black
  Eigen::Vector2d onTrack;          // pixels
  double blur = 0.;                 // in radii
  bool showsRing = false;
};

class Look
{
public:
  Look(const vpImage<unsigned char> &I, const CameraModel &camera, const MarkerPlane &plane,
       const vpCircleMarkerFamily &family)
      : m_image(I), m_camera(camera), m_plane(plane), m_layout(family.getLayout()),
        m_count(coveredSamplesPerSector * family.getNbSectors())
  {
    const double width = m_layout.codeOuter - m_layout.codeInner;
    m_radii = {radiusOfWhite(m_layout.quietZone),
               0.5 * (1. + m_layout.ringInner),
               0.5 * (m_layout.ringInner + m_layout.codeOuter),
               m_layout.codeInner + 0.7 * width,
               m_layout.codeInner + 0.5 * width,
               m_layout.codeInner + 0.3 * width,
               whiteOfCenter * m_layout.codeInner};
    m_seen.plane = plane;
    m_seen.directions = m_count;
    m_seen.gap = m_radii[GAP];
    m_seen.core = m_radii[TRACK_MIDDLE];
  }

  const SeenParts &getSeen() const { return m_seen; }

  bool findRing() { return findInk(firstStride, leastRingAtFirst) && findInk(1, leastRing); }

  CodeTrack track()
  {
    fitLight();
    CodeTrack track;
    track.samples = m_count;
    for (unsigned int i = 0; i < m_count; ++i) {
      const Direction &direction = m_directions[i];
      const Eigen::Vector2d &before = m_directions[(i + m_count - 1) % m_count].onTrack;
      const Eigen::Vector2d &after = m_directions[(i + 1) % m_count].onTrack;
      track.blur[i] = trackBlur * 4. * M_PI / m_count / (after - before).norm();
      putSample(direction, i, track);
    }
    return track;
  }

private:
  // Samples a direction from the outside down to the gap, or what is left of it.
  void sample(Direction &direction, std::size_t first, std::size_t end)
  {
    for (std::size_t k = first; k < end; ++k) {
      const Eigen::Vector2d pixel = pixelAt(direction, m_radii[k]);
      const auto grey = bilinear(m_image, pixel);
      direction.grey[k] = grey ? *grey : std::numeric_limits<double>::quiet_NaN();
      if (k == TRACK_MIDDLE) {
        direction.onTrack = pixel;
      }
    }
  }

  Eigen::Vector2d pixelAt(const Direction &direction, double radius) const
  {
    return m_camera.toPixel(m_plane.project(Eigen::Vector2d(radius * direction.c, radius * direction.s)));
  }

  // What the print looks like through the blur.
  void predict(Direction &direction) const
  {
    const NormalDistribution &normal = NormalDistribution::instance();
    const auto upTo = [&](double radius, double edge) {
      return normal.at((edge - radius) / direction.blur).cumulative;
    };
    for (std::size_t k = 0; k < places; ++k) {
      const double radius = m_radii[k];
      const double ring = upTo(radius, 1.) - upTo(radius, m_layout.ringInner);
      const double sector = upTo(radius, m_layout.codeOuter) - upTo(radius, m_layout.codeInner);
      direction.white[k] = 1. - ring;
      direction.black[k] = 1. - ring - sector;
    }
  }

  // The share of the light that the ink takes, on which most directions that look like a ring agree.
  bool findInk(unsigned int stride, double least)
  {
    std::array<double, mostSamples> inks;
    std::size_t count = 0;
    for (unsigned int i = 0; i < m_count; i += stride) {
      Direction &direction = m_directions[i];
      const double angle = 2. * M_PI * (i + 0.5) / m_count;
      direction.c = std::cos(angle);
      direction.s = std::sin(angle);
      sample(direction, OUTSIDE, TRACK_OUTER);
      direction.blur = trackBlur * (m_radii[OUTSIDE] - m_radii[GAP]) /
                       (pixelAt(direction, m_radii[OUTSIDE]) - pixelAt(direction, m_radii[GAP])).norm();
      predict(direction);
      const double step = direction.white[OUTSIDE] - direction.white[RING];
      const double ink = (1. - direction.grey[RING] / direction.grey[OUTSIDE]) / std::max(step, leastExpected);
      direction.showsRing = ink >= leastInk; // not if it is outside of the image
      if (direction.showsRing) {
        inks[count++] = ink;
      }
    }
    const double all = std::ceil(static_cast<double>(m_count) / stride);
    const UsualInk usual = usualInk(inks.data(), count);
    if (static_cast<double>(usual.agreeing) < least * all) {
      return false;
    }
    m_ink = usual.ink;
    std::size_t shown = 0;
    for (unsigned int i = 0; i < m_count; i += stride) {
      Direction &direction = m_directions[i];
      const auto stepTo = [&](Place place, const std::array<double, places> &expected) {
        return (1. - direction.grey[RING] / direction.grey[place]) /
               (m_ink * std::max(expected[place] - expected[RING], leastExpected));
      };
      const double outer = stepTo(OUTSIDE, direction.white);
      direction.showsRing =
          outer > leastOuterStep && outer < 1. / leastOuterStep && stepTo(GAP, direction.black) > leastInnerStep;
      shown += direction.showsRing ? 1 : 0;
      m_seen.ring[i] = direction.showsRing;
    }
    return static_cast<double>(shown) >= least * all;
  }

  // Light on the white paper as the outside of the ring shows it in a direction.
  double lightOutside(const Direction &direction) const
  {
    return direction.grey[OUTSIDE] / (1. - m_ink * (1. - direction.white[OUTSIDE]));
  }

  void fitLight()
  {
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    double count = 0.;
    for (unsigned int i = 0; i < m_count; ++i) {
      Direction &direction = m_directions[i];
      sample(direction, TRACK_OUTER, places);
      if (direction.showsRing) {
        const Eigen::Vector3d row(1., m_radii[OUTSIDE] * direction.c, m_radii[OUTSIDE] * direction.s);
        matrix += row * row.transpose();
        right += row * lightOutside(direction);
        count += 1.;
      }
    }
    matrix(1, 1) += ridge * count;
    matrix(2, 2) += ridge * count;
    m_light = matrix.ldlt().solve(right);
    std::array<double, mostSamples> differences;
    std::size_t used = 0;
    for (unsigned int i = 0; i < m_count; ++i) {
      const Direction &direction = m_directions[i];
      if (direction.showsRing) {
        differences[used++] = std::abs(lightOutside(direction) / lightAt(direction, m_radii[OUTSIDE]) - 1.);
      }
    }
    m_sameWhite = std::min(sameWhite + sameWhiteOfScatter * medianOf(differences, used), mostSameWhite);
  }

  double lightAt(const Direction &direction, double radius) const
  {
    return m_light[0] + radius * (m_light[1] * direction.c + m_light[2] * direction.s);
  }

  // One sample of the track, and whether it is seen.
  void putSample(const Direction &direction, unsigned int i, CodeTrack &track)
  {
    track.grey[i] = 0.5;
    track.weight[i] = 0.;
    // Where the ring is seen it tells the light of this direction: that of a shadow, for instance.
    const double usual = lightAt(direction, m_radii[OUTSIDE]);
    const double scale = direction.showsRing ? lightOutside(direction) / usual : 1.;
    const auto reflectance = [&](Place place) {
      return direction.grey[place] / (scale * lightAt(direction, m_radii[place]));
    };
    const auto isPaper = [&](Place place) {
      const double here = reflectance(place);
      return here > 1. - m_ink * (1. - direction.black[place]) - m_sameWhite &&
             here < 1. - m_ink * (1. - direction.white[place]) + m_sameWhite;
    };
    // Where there is paper in place of the ring, something as white as paper covers it, which ends nobody knows where.
    if (!(usual > 0.) || !isPaper(GAP) || (!direction.showsRing && reflectance(RING) > 1. - whiteCover)) {
      return;
    }
    const auto darkness = [&](Place place) { return 1. - (1. - reflectance(place)) / m_ink; };
    const double outer = darkness(TRACK_OUTER);
    const double middle = darkness(TRACK_MIDDLE);
    const double inner = darkness(TRACK_INNER);
    const bool isWhole = isPaper(CENTER);
    const double grey = isWhole ? (outer + middle + inner) / 3. : outer;
    const bool isEven = !isWhole || direction.blur > muchBlur ||
                        std::max({outer, middle, inner}) - std::min({outer, middle, inner}) < sameAcross;
    if (isEven && grey > -beyondBlackAndWhite && grey < 1. + beyondBlackAndWhite) {
      track.grey[i] = grey;
      m_seen.track[i] = true;
      m_seen.center[i] = isWhole;
      track.weight[i] = isWhole && direction.showsRing ? 1. : notAllSeen;
    }
  }

  const vpImage<unsigned char> &m_image;
  const CameraModel &m_camera;
  const MarkerPlane &m_plane;
  const vpCircleMarkerLayout &m_layout;
  const unsigned int m_count;
  std::array<double, places> m_radii;
  std::array<Direction, mostSamples> m_directions;
  SeenParts m_seen;
  double m_sameWhite = 0.;                           // share of the light
  double m_ink = 0.;                                 // share of the light that black takes away
  Eigen::Vector3d m_light = Eigen::Vector3d::Zero(); // grey level on white paper: at the centre, and its slopes
};
} // namespace

std::optional<CoveredReading> readCoveredSectors(const vpImage<unsigned char> &I, const CameraModel &camera,
                                                 const MarkerPlane &plane, const vpCircleMarkerFamily &family)
{
  Look look(I, camera, plane, family);
  if (!look.findRing()) {
    return std::nullopt;
  }
  const auto sectors = solveCoveredTrack(look.track(), family.getNbSectors());
  if (!sectors) {
    return std::nullopt;
  }
  return CoveredReading{*sectors, look.getSeen()};
}
} // namespace circle_marker
END_VISP_NAMESPACE
