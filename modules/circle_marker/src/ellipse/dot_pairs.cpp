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
 * The ring whose two ends are two dark dots.
 */

#include "ellipse/dot_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ellipse/ellipse_walk.h"
#include "support/bilinear.h"
#include "support/normal_distribution.h"
#include "support/parabola.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Distance of the nearest dots, pixels: of a shorter marker no code is left.
constexpr double nearestDots = 9.;
// Differences are told in parts of the depth of the shallower dot. Both ends of a ring are as dark but for the light's
// gradient: 0.15 is the most of 484 true ones.
constexpr double mostUneven = 0.25;
// The middle is the code's white centre, and so it is a tenth of the distance to either side. Beyond the dots lies the
// quiet zone.
constexpr double leastMiddle = 0.5;
constexpr double leastNearMiddle = 0.4;
constexpr double leastBeyond = 0.4;
// Where that is looked for, pixels and parts of the distance from a dot.
constexpr double beyond = 1.5;
constexpr double beyondOfDistance = 0.05;
// Two pixels beside a dot it is brighter by this, even on ground as dark as ink.
constexpr double beside = 2.;
constexpr double leastBeside = 0.25;
// Across: the darkest on either side of the line from dot to dot, up to so many pixels from it, is darker than that
// line by this, and no less than this part of what the other side is.
constexpr double firstAcross = 1.;
constexpr double lastAcross = 4.5;
constexpr double stepAcross = 0.25;
constexpr double leastDarkSide = 0.2;
constexpr double leastOfOtherSide = 0.6;
// Means over so many places to either side of the middle.
constexpr int placesToSide = 4;
// The blur moves the darkest point of an end inward by so much, pixels.
constexpr double inwardByBlur = 0.5;
// Less narrow rings have no dots.
constexpr double mostAxisRatio = 0.6;

// Semi-minor axes that are tried, pixels: of narrower rings no code is left, wider ones have edges.
constexpr double narrowest = 1.6;
constexpr double stepOfWidth = 0.25;
constexpr std::size_t widths = 14;
// Of what is no ring, a line from dot to dot, the narrowest is the best.
constexpr double leastSemiMinor = 1.85;
// A ring correlates by this with what the blur, pixels, leaves of one. Of 738 true ones of 3.5 to 8 pixels at 70 to 87
// degrees 97 in 100 do, and are wide enough, of 908 pairs of dots in clutter that had come so far three in 100.
constexpr double leastCorrelation = 0.66;
constexpr double usualBlur = 0.7;
// And by this where its dark sides say that it is.
constexpr double leastAtStart = 0.15;

// Means of grey levels along the line from dot to dot and parallel to it, between them.
class Across
{
public:
  Across(const vpImage<unsigned char> &I, const Eigen::Vector2d &middle, const Eigen::Vector2d &way, double ringInner)
      : m_I(I), m_middle(middle), m_way(way), m_across(Eigen::Vector2d(-way.y(), way.x()).normalized()),
        m_narrower(narrowerAlong(1. + ringInner))
  {
  }

  // Of the white centre.
  double center() const
  {
    constexpr double strideOfCenter = 0.04;
    return mean([&](int k) -> Eigen::Vector2d { return m_middle + strideOfCenter * k * m_way; });
  }

  // At a distance from the middle, pixels, and elsewhere nearer as the ring is.
  double side(double distance) const
  {
    return mean([&](int k) -> Eigen::Vector2d {
      return m_middle + stride * k * m_way + distance * m_narrower[static_cast<std::size_t>(std::abs(k))] * m_across;
    });
  }

private:
  static constexpr double stride = 0.1; // of the places along the sides, distances of the dots
  using Narrower = std::array<double, placesToSide + 1>;

  // How much nearer the ring is than in the middle, at the places to either side. ofRing: the distance of the dots by
  // the ring's semi-major axis.
  static Narrower narrowerAlong(double ofRing)
  {
    Narrower narrower;
    for (std::size_t k = 0; k < narrower.size(); ++k) {
      narrower[k] = std::sqrt(1. - std::pow(ofRing * stride * static_cast<double>(k), 2));
    }
    return narrower;
  }

  // HUGE_VAL where that reaches out of the image.
  template <class PlaceAt> double mean(const PlaceAt &placeAt) const
  {
    double sum = 0.;
    for (int k = -placesToSide; k <= placesToSide; ++k) {
      sum += bilinear(m_I, placeAt(k)).value_or(HUGE_VAL);
    }
    return sum / (2. * placesToSide + 1.);
  }

  const vpImage<unsigned char> &m_I;
  Eigen::Vector2d m_middle;
  Eigen::Vector2d m_way;
  Eigen::Vector2d m_across;
  Narrower m_narrower;
};

// The darkest line on one side.
struct DarkSide
{
  double grey = HUGE_VAL;
  double distance = 0.; // from the middle, pixels
};

// sign: of the side.
DarkSide darkestBeside(const Across &across, double sign)
{
  DarkSide darkest;
  for (double distance = firstAcross; distance <= lastAcross; distance += stepAcross) {
    const double grey = across.side(sign * distance);
    if (grey < darkest.grey) {
      darkest = {grey, distance};
    }
  }
  return darkest;
}

// Distance of the dark sides from the middle, pixels; nothing if there are none.
std::optional<double> distanceOfSides(const Across &across, double depth)
{
  const double center = across.center();
  const DarkSide right = darkestBeside(across, 1.);
  if (center - right.grey < leastDarkSide * depth) { // whatever the other one is
    return std::nullopt;
  }
  const DarkSide left = darkestBeside(across, -1.);
  const double more = center - std::min(right.grey, left.grey);
  const double less = center - std::max(right.grey, left.grey);
  if (less < std::max(leastDarkSide * depth, leastOfOtherSide * more)) {
    return std::nullopt;
  }
  return 0.5 * (right.distance + left.distance);
}

// Weighted moments of pairs of numbers.
struct Moments
{
  double n = 0., x = 0., y = 0., xx = 0., xy = 0., yy = 0.;

  void add(double first, double second, double weight)
  {
    n += weight;
    x += weight * first;
    y += weight * second;
    xx += weight * first * first;
    xy += weight * first * second;
    yy += weight * second * second;
  }
  double correlation() const { return (n * xy - x * y) / std::sqrt((n * xx - x * x) * (n * yy - y * y)); }
};

// Correlation of an image with the ring and the white inside of it, its code's track left out: minus that of the share
// of black.
double correlationWithRing(const vpImage<unsigned char> &I, const EllipseParameters &ellipse, double ringInner)
{
  constexpr int directions = 24;
  // The white centre, both edges of the ring and what is between and beside them.
  const std::array<double, 8> radii = {
      0., 0.19 * ringInner, 0.38 * ringInner, ringInner - 0.06, ringInner + 0.02, 0.5 * (1. + ringInner), 1., 1.1};
  const NormalDistribution &normal = NormalDistribution::instance();
  Moments moments;
  EllipseWalk walk(ellipse, directions);
  for (int k = 0; k < directions / 2; ++k, walk.next()) {
    const EdgePoint here = walk.here();
    const Eigen::Vector2d out = here.position - ellipse.center;
    // In one direction all circles have the same tangent, their radius times this away from the centre, in blurs.
    const double across = out.dot(here.normal()) / usualBlur;
    for (const double radius : radii) {
      const double black =
          normal.at((1. - radius) * across).cumulative - normal.at((ringInner - radius) * across).cumulative;
      const double area = std::max(radius, 0.1); // in proportion
      for (const double side : {-radius, radius}) {
        if (const auto grey = bilinear(I, ellipse.center + side * out)) {
          moments.add(black, *grey, area);
        }
      }
    }
  }
  return -moments.correlation();
}

// Sets the semi-minor axis with which a ring is most like the image, up the hill from where its dark sides are; false
// if none is like it.
bool setSemiMinor(const vpImage<unsigned char> &I, double ringInner, double sides, EllipseParameters &ellipse)
{
  std::array<double, widths> likeness;
  likeness.fill(HUGE_VAL); // not known
  const auto likenessAt = [&](std::size_t i) {
    if (likeness[i] == HUGE_VAL) {
      ellipse.b = narrowest + stepOfWidth * static_cast<double>(i);
      likeness[i] = correlationWithRing(I, ellipse, ringInner);
    }
    return likeness[i];
  };
  const double start = std::round((2. * sides / (1. + ringInner) - narrowest) / stepOfWidth);
  auto best = static_cast<std::size_t>(std::clamp(start, 1., widths - 2.));
  if (!(likenessAt(best) >= leastAtStart)) {
    return false;
  }
  while (best > 0 && best + 1 < widths) {
    const bool isUp = likenessAt(best + 1) > likenessAt(best);
    if (!isUp && !(likenessAt(best - 1) > likenessAt(best))) {
      break;
    }
    best += isUp ? 1 : -1;
  }
  if (best == 0 || best + 1 == widths || !(likeness[best] >= leastCorrelation)) {
    return false;
  }
  const double offset = vertexOfParabola(-likeness[best - 1], -likeness[best], -likeness[best + 1]);
  ellipse.b = narrowest + stepOfWidth * (static_cast<double>(best) + offset);
  return ellipse.b >= leastSemiMinor && ellipse.b < mostAxisRatio * ellipse.a;
}
} // namespace

std::optional<EllipseParameters> ringBetween(const vpImage<unsigned char> &I, const DarkDot &one, const DarkDot &other,
                                             double ringInner)
{
  const Eigen::Vector2d way = other.place - one.place;
  const double distance = way.norm();
  const double depth = std::min(one.depth, other.depth);
  const double dark = std::max(one.grey, other.grey);
  if (distance < nearestDots || distance > farthestDots || std::abs(one.grey - other.grey) > mostUneven * depth) {
    return std::nullopt;
  }
  const Eigen::Vector2d along = way / distance;
  const Eigen::Vector2d across(-along.y(), along.x());
  const Eigen::Vector2d middle = 0.5 * (one.place + other.place);
  const auto isBright = [&](const Eigen::Vector2d &place, double least) {
    return bilinear(I, place).value_or(0.) >= dark + least * depth;
  };
  const Eigen::Vector2d out = (beyond + beyondOfDistance * distance) * along;
  const Eigen::Vector2d aside = beside * across;
  const bool isLikeRing = isBright(middle, leastMiddle) && isBright(middle - 0.1 * way, leastNearMiddle) &&
                          isBright(middle + 0.1 * way, leastNearMiddle) && isBright(one.place - out, leastBeyond) &&
                          isBright(other.place + out, leastBeyond) && isBright(one.place - aside, leastBeside) &&
                          isBright(one.place + aside, leastBeside) && isBright(other.place - aside, leastBeside) &&
                          isBright(other.place + aside, leastBeside);
  if (!isLikeRing) {
    return std::nullopt;
  }
  const auto sides = distanceOfSides(Across(I, middle, way, ringInner), depth);
  if (!sides) {
    return std::nullopt;
  }
  EllipseParameters ellipse;
  ellipse.center = middle;
  ellipse.a = distance / (1. + ringInner) + inwardByBlur;
  ellipse.angle = along.x() == 0. ? M_PI_2 : std::atan(along.y() / along.x());
  return setSemiMinor(I, ringInner, *sides, ellipse) ? std::make_optional(ellipse) : std::nullopt;
}
} // namespace circle_marker
END_VISP_NAMESPACE
