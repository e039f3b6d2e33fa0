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
 * The likelihood of all codewords at a measured pose.
 */

#include "refine/code_likelihood.h"

#include <algorithm>
#include <array>
#include <vector>

#include <Eigen/Core>

#include "decode/code_track.h"
#include "decode/cyclic_code.h"
#include "refine/plane_point.h"
#include "support/normal_distribution.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Phases of the sectors that are tried: an eighth of a sector moves no edge by more than a small part of the blur.
constexpr int phases = 8;
// A pixel sees the sectors whose borders are within this many standard deviations of the blur; and no more than these
// to either side of the one that it lies in.
constexpr double reach = 3.;
constexpr int mostReach = 4;
// Pixels of the track, and this many standard deviations of the blur around it.
constexpr double around = 1.5;
// What the model leaves besides noise, in units of the contrast: pose, blur and light are not exact.
constexpr double modelError = 0.04;
// Where paper is brighter than this, grey levels, a pixel that is as well cannot be told from brighter.
constexpr double brightest = 254.;
// Spins of one marker in neighbouring phases differ by no more than this, in sectors.
constexpr double sameSpin = 0.75;

constexpr double fullTurn = 2. * M_PI;

// An edge at a place: the standardised distance, positive on the side that is asked for, the share of that side and its
// density, and the gradient of the place in the image, in coordinates in which the blur is 1.
struct Edge
{
  Edge(double standardised, const Eigen::Vector2d &across) : distance(standardised), gradient(across)
  {
    const auto normal = NormalDistribution::instance().at(standardised);
    share = normal.cumulative;
    density = normal.density;
  }

  double distance, share, density;
  Eigen::Vector2d gradient; // of unit length
};

// The side of a circle about the centre that is nearer to it. Its curvature takes from what is inside: image_model.h.
Edge insideOf(double radius, const PlanePoint &point)
{
  const double r = std::max(point.q.norm(), 1e-6);
  const Eigen::Vector2d gradient = point.byPixel.transpose() * (point.q / r); // of the radius, by the blur
  const double length = gradient.norm();
  return {(radius - r) / length - 0.5 * length / std::max(r, length), -gradient / length};
}

// The side of a border between sectors toward larger angles.
Edge beyondBorder(double angle, const PlanePoint &point)
{
  const Eigen::Vector2d across(-std::sin(angle), std::cos(angle));
  const Eigen::Vector2d gradient = point.byPixel.transpose() * across;
  const double length = gradient.norm();
  return {across.dot(point.q) / length, gradient / length};
}

// What the probability of both sides is more than the product of both: two terms of the tetrachoric series.
double together(const Edge &a, const Edge &b)
{
  const double rho = a.gradient.dot(b.gradient);
  return a.density * b.density * rho * (1. + 0.5 * rho * a.distance * b.distance);
}

/*! The rims of the track at a pixel. */
struct Rims
{
  Edge outer, inner;
};

/*! What a pixel of the track sees. */
struct TrackPixel
{
  PlanePoint point;
  Rims rims;
  double black; // that is not explained by the ring: 0 for white, 1 for ink
};

/*! Pixels of the track, and how large the noise is on their black. */
struct Track
{
  std::vector<TrackPixel> pixels;
  double noise = 0.;
};

// Share of the pixel that lies in the track beyond a border.
double beyond(double angle, const Rims &rims, const PlanePoint &point)
{
  const Edge border = beyondBorder(angle, point);
  return (rims.outer.share - rims.inner.share) * border.share + together(rims.outer, border) -
         together(rims.inner, border);
}

// Black of the ring that a pixel sees.
double ringAt(const vpCircleMarkerLayout &layout, const PlanePoint &point)
{
  const double inner = layout.ringInner > 0. ? insideOf(layout.ringInner, point).share : 0.;
  return insideOf(1., point).share - inner;
}

// Nothing if the track leaves the image or the light is not known.
std::optional<Track> trackOf(const vpImage<unsigned char> &I, const CameraModel &camera, const FittedPose &fit,
                             const ImageFrame &frame, const vpCircleMarkerLayout &layout)
{
  const Photometry &photometry = fit.photometry;
  if (photometry.shadow) {
    return std::nullopt;
  }
  const Eigen::Matrix2d blur = photometry.blur.sigma * photometry.blur.shape();
  Eigen::Vector2d least(HUGE_VAL, HUGE_VAL), most(-HUGE_VAL, -HUGE_VAL);
  for (int k = 0; k < 16; ++k) {
    const double angle = fullTurn * k / 16;
    const Eigen::Vector2d p =
        camera.toPixel(fit.plane.project(layout.codeOuter * Eigen::Vector2d(std::cos(angle), std::sin(angle))));
    least = least.cwiseMin(p);
    most = most.cwiseMax(p);
  }
  const double margin = around * photometry.blur.widest() + 1.;
  if (least.minCoeff() < margin || most.x() > I.getWidth() - 1. - margin || most.y() > I.getHeight() - 1. - margin) {
    return std::nullopt;
  }
  Track track;
  double squaredContrast = 0.;
  for (int v = static_cast<int>(least.y() - margin); v <= static_cast<int>(most.y() + margin) + 1; ++v) {
    for (int u = static_cast<int>(least.x() - margin); u <= static_cast<int>(most.x() + margin) + 1; ++u) {
      if (u < 0 || v < 0 || u >= static_cast<int>(I.getWidth()) || v >= static_cast<int>(I.getHeight())) {
        continue;
      }
      const Eigen::Vector2d p(u, v);
      PlanePoint point = planePoint({camera.toMeter(p), camera.meterPerPixel(p)}, fit.plane);
      point.byPixel = point.byPixel * blur;
      const Rims rims = {insideOf(layout.codeOuter, point), insideOf(layout.codeInner, point)};
      if (rims.outer.distance < -around || rims.inner.distance > around) {
        continue;
      }
      const Eigen::Vector2d offset = (p - frame.center) / frame.size;
      const double light = photometry.light + photometry.lightGradient.dot(offset);
      const double contrast = light * photometry.contrast;
      const double grey = I[static_cast<unsigned int>(v)][static_cast<unsigned int>(u)];
      if ((light > brightest && grey > brightest) || contrast <= 0.) {
        return std::nullopt;
      }
      track.pixels.push_back({point, rims, (light - grey) / contrast - ringAt(layout, point)});
      squaredContrast += contrast * contrast;
    }
  }
  if (track.pixels.empty()) {
    return std::nullopt;
  }
  const double contrast = std::sqrt(squaredContrast / static_cast<double>(track.pixels.size()));
  track.noise = std::hypot(fit.noise / contrast, modelError);
  return track;
}

using SectorMatrix = Eigen::Matrix<double, mostSectors, mostSectors>;
using SectorVector = Eigen::Matrix<double, mostSectors, 1>;

/*! Squared residuals as a quadratic form of the sectors' colours: squares - 2 right' c + c' matrix c. */
struct Squares
{
  SectorMatrix matrix = SectorMatrix::Zero();
  SectorVector right = SectorVector::Zero();
  double squares = 0.;
};

// With the first sector beginning at an angle.
Squares squaresOf(const Track &track, const vpCircleMarkerLayout &layout, int sectors, double start)
{
  Squares result;
  const double pitch = fullTurn / sectors;
  std::array<double, 2 * mostReach + 2> shares;
  std::array<int, 2 * mostReach + 1> numbers;
  std::array<double, 2 * mostReach + 1> weights;
  for (const TrackPixel &pixel : track.pixels) {
    const PlanePoint &point = pixel.point;
    const double angle = std::atan2(point.q.y(), point.q.x()) - start;
    const int own = static_cast<int>(std::floor(angle / pitch));
    const double blur = point.byPixel.norm() / std::max(point.q.norm(), layout.codeInner); // rad, at most
    const int wide = std::clamp(static_cast<int>(std::ceil(reach * blur / pitch)), 1, mostReach);
    for (int k = 0; k <= 2 * wide + 1; ++k) {
      shares[static_cast<std::size_t>(k)] = beyond(start + (own - wide + k) * pitch, pixel.rims, point);
    }
    const int count = 2 * wide + 1;
    for (int k = 0; k < count; ++k) {
      const auto i = static_cast<std::size_t>(k);
      numbers[i] = ((own - wide + k) % sectors + sectors) % sectors;
      weights[i] = shares[i] - shares[i + 1];
    }
    for (int i = 0; i < count; ++i) {
      const auto a = static_cast<std::size_t>(i);
      result.right[numbers[a]] += weights[a] * pixel.black;
      for (int j = 0; j < count; ++j) {
        const auto b = static_cast<std::size_t>(j);
        result.matrix(numbers[a], numbers[b]) += weights[a] * weights[b];
      }
    }
    result.squares += pixel.black * pixel.black;
  }
  return result;
}

/*! The quadratic form for whole words, by look-ups: what four sectors and the next four have to do with each other. */
class WordCosts
{
public:
  WordCosts(const Squares &squares, unsigned int sectors) : m_groups((sectors + 3) / 4)
  {
    for (unsigned int group = 0; group < m_groups; ++group) {
      for (unsigned int value = 0; value < 256; ++value) {
        m_costs[group][value] = static_cast<float>(costOf(squares, sectors, group, value));
      }
    }
  }

  float of(CyclicCode::Word word) const
  {
    const CyclicCode::Word first = word & 15U;
    float cost = 0.f;
    for (unsigned int group = 0; group + 1 < m_groups; ++group) {
      cost += m_costs[group][(word >> (4 * group)) & 255U];
    }
    return cost + m_costs[m_groups - 1][(word >> (4 * (m_groups - 1))) | (first << 4)];
  }

private:
  // Of the group's own bits, value & 15, and of their products with the next group's, value >> 4.
  static double costOf(const Squares &squares, unsigned int sectors, unsigned int group, unsigned int value)
  {
    const bool isLast = 4 * group + 4 >= sectors;
    double cost = 0.;
    for (unsigned int i = 0; i < 4; ++i) {
      if (((value >> i) & 1U) == 0 || 4 * group + i >= sectors) {
        continue;
      }
      const unsigned int a = sectors - 1 - 4 * group - i; // sector 0 is the most significant bit
      cost += squares.matrix(a, a) - 2. * squares.right[a];
      for (unsigned int j = i + 1; j < 8; ++j) {
        const unsigned int bit = j < 4 ? 4 * group + j : isLast ? j - 4 : 4 * group + j;
        if (((value >> j) & 1U) != 0 && bit < sectors) {
          cost += 2. * squares.matrix(a, sectors - 1 - bit);
        }
      }
    }
    return cost;
  }

  unsigned int m_groups;
  std::array<std::array<float, 256>, (mostSectors + 3) / 4> m_costs;
};

/*! A codeword at a phase. */
struct Contender
{
  CyclicCode::Word word = 0;
  double cost = HUGE_VAL;
  int id = -1;
  double spin = 0.;
};

// The two best codewords at a phase. A white track, the zero word, costs nothing but the squares; it may be the best.
std::array<Contender, 2> bestTwo(const Squares &squares, const CyclicCode &code, double start)
{
  const WordCosts costs(squares, code.getLength());
  CyclicCode::Word best = 0, second = 0;
  float bestCost = 0.f, secondCost = HUGE_VALF;
  code.forEachCodeword([&](CyclicCode::Word word) {
    const float cost = costs.of(word);
    if (cost < bestCost) {
      second = best;
      secondCost = bestCost;
      best = word;
      bestCost = cost;
    }
    else if (cost < secondCost) {
      second = word;
      secondCost = cost;
    }
  });
  std::array<Contender, 2> two;
  two[0].word = best;
  two[0].cost = squares.squares + static_cast<double>(bestCost);
  two[1].word = second;
  two[1].cost = squares.squares + static_cast<double>(secondCost);
  for (Contender &contender : two) {
    if (const auto identity = code.identify(contender.word)) { // else constant: no marker's
      contender.id = identity->id;
      contender.spin = std::remainder(start + fullTurn * identity->rotation / code.getLength(), fullTurn);
    }
  }
  return two;
}
} // namespace

std::optional<LikelyCode> mostLikelyCode(const vpImage<unsigned char> &I, const CameraModel &camera,
                                         const FittedPose &fit, const ImageFrame &frame,
                                         const vpCircleMarkerFamily &family, const Deadline &deadline)
{
  const vpCircleMarkerLayout &layout = family.getLayout();
  const auto track = trackOf(I, camera, fit, frame, layout);
  if (!track) {
    return std::nullopt;
  }
  const CyclicCode &code = codeOf(family);
  const double pitch = fullTurn / code.getLength();
  std::array<Contender, 2 * phases> contenders;
  for (int phase = 0; phase < phases; ++phase) {
    if (deadline.hasPassed()) { // a phase of bch31 takes about a millisecond
      return std::nullopt;
    }
    const double start = pitch * phase / phases;
    const auto two = bestTwo(squaresOf(*track, layout, static_cast<int>(code.getLength()), start), code, start);
    std::copy(two.begin(), two.end(), contenders.begin() + 2 * phase);
  }
  const Contender &best = *std::min_element(contenders.begin(), contenders.end(),
                                            [](const auto &p, const auto &q) { return p.cost < q.cost; });
  if (best.id < 0) {
    return LikelyCode();
  }
  double next = HUGE_VAL;
  for (const Contender &contender : contenders) {
    const bool isSame =
        contender.id == best.id && std::abs(std::remainder(contender.spin - best.spin, fullTurn)) < sameSpin * pitch;
    next = isSame ? next : std::min(next, contender.cost);
  }
  const double variance = track->noise * track->noise;
  return LikelyCode{best.id, best.spin, (next - best.cost) / (2. * variance),
                    std::sqrt(std::max(best.cost, 0.) / (variance * static_cast<double>(track->pixels.size())))};
}
} // namespace circle_marker
END_VISP_NAMESPACE
