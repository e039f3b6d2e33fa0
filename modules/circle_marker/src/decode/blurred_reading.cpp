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
 * Code and pose of a marker seen through a strong blur.
 */

#include "decode/blurred_reading.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/LU>
#include <Eigen/Eigenvalues>

#include "decode/cyclic_code.h"
#include "pose/hypotheses.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Samples of the first look and of the fit.
constexpr std::size_t fewSamples = 250;
constexpr std::size_t manySamples = 500;
// Radii of the disc that are tried first, and lengths of the way, in semi-major axes of the outline; directions of it.
constexpr std::array<double, 2> firstDiscs = {0.07, 0.14};
constexpr std::array<double, 2> firstWays = {0.22, 0.42};
constexpr int firstDirections = 8;
// The outline of something that moved is longer along the way by this share of it on each side.
constexpr double outlineGrowth = 0.28;
// Starts that are followed, and those of them that are followed to the end.
constexpr std::size_t followed = 4;
constexpr std::size_t finished = 2;
constexpr int followedSteps = 4;
constexpr int finishedSteps = 10;
// A first look that leaves more than this share of the image's variance unexplained is none of a marker. If the best
// one still leaves more than the second after a step, there is none: of 809 true markers the best left up to 0.09 then,
// of rings with another code 0.09 to 0.3. Nor is one that leaves more than the third after some steps: the best ones of
// true markers leave up to 0.05. (Before the first step it does not tell: markers in a defocus of a quarter of their
// radius left up to 0.4, and with a start of that defocus so did what is none leave less.)
constexpr double mostUnexplainedAtFirst = 0.6;
constexpr double mostUnexplainedAfterStep = 0.12;
constexpr double mostUnexplainedAfterSteps = 0.1;
// Spins that are told apart, by the sector.
constexpr int phases = 8;
// A codeword that is seen through a blur leaves this share of the image's variance unexplained at most: those of true
// markers leave a hundredth.
constexpr double mostUnexplained = 0.05;
// A defocus beyond this radius, in semi-major axes, has wiped out the finest of a code: of sectors that are black and
// white in turn, 11.5 cycles around a track of mean radius 0.54, a disc shows nothing from 0.18 on (the first zero of
// its transfer function). Then a codeword, too, may leave no more than so many times what sectors of any grey leave:
// those of 25 true markers left up to 1.7, of codes of 19 sectors, which golay23 was read from, 2.3 and more.
constexpr double wideDisc = 0.2;
constexpr double mostOfAnySectors = 2.;
// Nothing moves farther than this while it is seen, in semi-major axes: a marker on its way by a quarter of its
// diameter is promised, and is read. A motion three times as long made two dots of a grid look like a code.
constexpr double longestWay = 0.7;
// A ring has no code to prove it.
constexpr double mostUnexplainedOfRing = 0.02;
// A codeword that leaves less than this unexplained is not looked for elsewhere.
constexpr double sureUnexplained = 0.01;

// Whether a codeword explains what sectors of any grey do, in a blur as there is.
bool isCode(const BlurredFit &fit, double unexplained, const EllipseParameters &outline)
{
  const bool isFineSeen = fit.blur.disc < wideDisc * outline.a;
  return fit.blur.motion.norm() < longestWay * outline.a &&
         (isFineSeen || unexplained < mostOfAnySectors * fit.unexplained());
}

// The outline without what a motion adds to it; nothing if nothing is left.
std::optional<EllipseParameters> shrunk(const EllipseParameters &ellipse, const Eigen::Vector2d &way)
{
  const Eigen::Vector2d major(std::cos(ellipse.angle), std::sin(ellipse.angle));
  const Eigen::Vector2d minor(-major.y(), major.x());
  Eigen::Matrix2d shape =
      ellipse.a * ellipse.a * major * major.transpose() + ellipse.b * ellipse.b * minor * minor.transpose();
  const Eigen::Vector2d direction = way.normalized();
  const double extent = std::sqrt(direction.dot(shape * direction));
  const double less = extent - outlineGrowth * way.norm();
  if (less < 0.3 * extent) {
    return std::nullopt;
  }
  // A dual conic: the squared extent in each direction.
  shape -= (extent * extent - less * less) * direction * direction.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> eigen(shape);
  if (eigen.eigenvalues()[0] <= 0.) {
    return std::nullopt;
  }
  EllipseParameters result = ellipse;
  result.a = std::sqrt(eigen.eigenvalues()[1]);
  result.b = std::sqrt(eigen.eigenvalues()[0]);
  result.angle = std::atan2(eigen.eigenvectors()(1, 1), eigen.eigenvectors()(0, 1));
  return result;
}

std::optional<PosePair> posesOfEllipse(const EllipseParameters &ellipse, const CameraModel &camera, double radius)
{
  constexpr int count = 32;
  std::vector<EdgePoint> points(count);
  const Eigen::Vector2d major(std::cos(ellipse.angle), std::sin(ellipse.angle));
  const Eigen::Vector2d minor(-major.y(), major.x());
  for (int i = 0; i < count; ++i) {
    const double angle = 2. * M_PI * i / count;
    points[static_cast<std::size_t>(i)].position =
        ellipse.center + ellipse.a * std::cos(angle) * major + ellipse.b * std::sin(angle) * minor;
  }
  return posesFromOutline(points, camera, radius);
}

// All starts, the best first.
std::vector<BlurredFit> firstLooks(BlurredMarker &marker, const CameraModel &camera, const EllipseParameters &outline,
                                   double radius, const Deadline &deadline)
{
  std::vector<BlurredFit> looks;
  const auto look = [&](const EllipseParameters &ellipse, const ImageBlur &blur) {
    if (deadline.hasPassed()) {
      return;
    }
    const auto poses = posesOfEllipse(ellipse, camera, radius);
    if (!poses) {
      return;
    }
    for (const MarkerPlane &plane : *poses) {
      marker.select(plane, blur, fewSamples);
      BlurredFit fit;
      fit.plane = plane;
      fit.blur = blur;
      if (marker.size() > fewSamples / 4) {
        marker.solve(fit);
        if (fit.unexplained() < mostUnexplainedAtFirst) {
          looks.push_back(fit);
        }
      }
    }
  };
  for (const double disc : firstDiscs) {
    look(outline, {Eigen::Vector2d::Zero(), disc * outline.a});
  }
  for (const double way : firstWays) {
    for (int i = 0; i < firstDirections; ++i) {
      const double angle = M_PI * i / firstDirections;
      const Eigen::Vector2d motion = way * outline.a * Eigen::Vector2d(std::cos(angle), std::sin(angle));
      if (const auto ellipse = shrunk(outline, motion)) {
        look(*ellipse, {motion, 0.});
      }
    }
  }
  std::sort(looks.begin(), looks.end(),
            [](const BlurredFit &p, const BlurredFit &q) { return p.unexplained() < q.unexplained(); });
  return looks;
}

// The best of the starts after some steps.
std::vector<BlurredFit> bestLooks(BlurredMarker &marker, const CameraModel &camera, const EllipseParameters &outline,
                                  double radius, const Deadline &deadline)
{
  std::vector<BlurredFit> fits = firstLooks(marker, camera, outline, radius, deadline);
  fits.resize(std::min(fits.size(), followed));
  double least = HUGE_VAL;
  for (BlurredFit &fit : fits) {
    marker.select(fit.plane, fit.blur, fewSamples);
    if (marker.size() < fewSamples / 4) {
      fit.squares = HUGE_VAL;
      continue;
    }
    marker.solve(fit);
    marker.improve(fit, 1, false);
    least = std::min(least, fit.unexplained());
  }
  if (!(least < mostUnexplainedAfterStep)) {
    return {};
  }
  for (BlurredFit &fit : fits) {
    if (fit.squares < HUGE_VAL) {
      marker.select(fit.plane, fit.blur, fewSamples);
      marker.solve(fit);
      marker.improve(fit, followedSteps - 1, false);
    }
  }
  std::sort(fits.begin(), fits.end(),
            [](const BlurredFit &p, const BlurredFit &q) { return p.unexplained() < q.unexplained(); });
  fits.resize(std::min(fits.size(), finished));
  fits.erase(std::remove_if(fits.begin(), fits.end(),
                            [](const BlurredFit &fit) { return !(fit.unexplained() < mostUnexplainedAfterSteps); }),
             fits.end());
  return fits;
}

// What a codeword leaves unexplained of a fit, when light and contrast are its own.
class CodewordSquares
{
public:
  CodewordSquares(const BlurredFit &fit, int sectors) : m_sectors(sectors), m_plain(fit.plain)
  {
    const int light = BlurredFit::lightSize;
    const int rest = 1 + sectors;
    const Eigen::MatrixXd inverse = fit.matrix.topLeftCorner(light, light).inverse();
    const Eigen::MatrixXd mixed = fit.matrix.bottomLeftCorner(rest, light);
    const Eigen::MatrixXd matrix = fit.matrix.bottomRightCorner(rest, rest) - mixed * inverse * mixed.transpose();
    const Eigen::VectorXd right = fit.right.tail(rest) - mixed * inverse * fit.right.head(light);
    m_ring = matrix(0, 0);
    m_ringRight = right[0];
    for (int k = 0; k < sectors; ++k) {
      m_right[static_cast<std::size_t>(k)] = right[1 + k];
      m_diagonal[static_cast<std::size_t>(k)] = matrix(1 + k, 1 + k) + 2. * matrix(0, 1 + k);
      for (int l = 0; l < sectors; ++l) {
        m_matrix[static_cast<std::size_t>(k)][static_cast<std::size_t>(l)] = matrix(1 + k, 1 + l);
      }
    }
  }

  double of(CyclicCode::Word word) const
  {
    double right = m_ringRight;
    double square = m_ring;
    std::array<std::size_t, mostSectors> black;
    std::size_t count = 0;
    for (int k = 0; k < m_sectors; ++k) {
      if ((word >> (m_sectors - 1 - k)) & 1U) {
        const auto here = static_cast<std::size_t>(k);
        right += m_right[here];
        square += m_diagonal[here];
        for (std::size_t l = 0; l < count; ++l) {
          square += 2. * m_matrix[here][black[l]];
        }
        black[count++] = here;
      }
    }
    return right > 0. ? m_plain - right * right / square : m_plain;
  }

private:
  int m_sectors;
  double m_plain;
  double m_ring = 0.;
  double m_ringRight = 0.;
  std::array<double, mostSectors> m_right;
  std::array<double, mostSectors> m_diagonal;
  std::array<std::array<double, mostSectors>, mostSectors> m_matrix;
};

struct BestWords
{
  CyclicCode::Word best = 0;
  double squares = HUGE_VAL;
  double next = HUGE_VAL;
};

// After the deadline the best of those so far.
BestWords bestWords(const BlurredFit &fit, const CyclicCode &code, const Deadline &deadline)
{
  constexpr unsigned int wordsAtOnce = 1024; // some tenths of a millisecond
  const CodewordSquares squares(fit, static_cast<int>(code.getLength()));
  BestWords words;
  unsigned int count = 0;
  bool isOver = false;
  code.forEachCodeword([&](CyclicCode::Word word) {
    isOver = isOver || (++count % wordsAtOnce == 0 && deadline.hasPassed());
    if (isOver) {
      return;
    }
    const double here = squares.of(word);
    if (here < words.squares) {
      words.next = words.squares;
      words.squares = here;
      words.best = word;
    }
    else {
      words.next = std::min(words.next, here);
    }
  });
  return words;
}

// The other pose of the circle's image.
MarkerPlane twinOf(const MarkerPlane &plane, const CameraModel &camera)
{
  constexpr std::size_t count = 32;
  std::vector<EdgePoint> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2. * M_PI * static_cast<double>(i) / count;
    points[i].position = camera.toPixel(plane.project(Eigen::Vector2d(std::cos(angle), std::sin(angle))));
  }
  const auto poses = posesFromOutline(points, camera, plane.radius);
  if (!poses) {
    return plane;
  }
  const auto cosine = [&](std::size_t i) { return (*poses)[i].rotation.col(2).dot(plane.rotation.col(2)); };
  return (*poses)[cosine(0) < cosine(1) ? 0 : 1];
}

// Fits the twin as well, puts the better first, and tells how well both are known.
void fitBoth(BlurredMarker &marker, const CameraModel &camera, bool movesSpin, BlurredReading &reading)
{
  constexpr double samePose = 0.02; // rad between two normals: less is one pose
  BlurredFit &fit = reading.fit;
  marker.select(fit.plane, fit.blur, manySamples);
  marker.solve(fit);
  marker.improve(fit, finishedSteps, movesSpin);
  BlurredFit twin;
  twin.plane = twinOf(fit.plane, camera);
  copySpin(fit.plane, twin.plane);
  twin.blur = fit.blur;
  marker.solve(twin);
  marker.improve(twin, finishedSteps, movesSpin);
  if (twin.squares < fit.squares) {
    std::swap(fit, twin);
  }
  const auto freedom = static_cast<double>(fit.samples) - static_cast<double>(fit.linear.size()) - 8.; // pose, blur
  const double variance = fit.squares / std::max(freedom, 1.);
  reading.poses.covariance[0] = marker.covariance(fit);
  reading.poses.covariance[1] = reading.poses.covariance[0];
  reading.poses.cost[0] = fit.squares / (2. * variance * marker.coherence());
  reading.poses.noise = std::sqrt(variance);
  reading.poses.unexplained = fit.unexplained();
  reading.twin = fit.plane;
  const double cosine = twin.plane.rotation.col(2).dot(fit.plane.rotation.col(2));
  if (twin.squares < HUGE_VAL && cosine < std::cos(samePose)) {
    reading.twin = twin.plane;
    reading.poses.covariance[1] = marker.covariance(twin);
    reading.poses.cost[1] = twin.squares / (2. * variance * marker.coherence());
  }
}
} // namespace

std::optional<BlurredReading> readBlurred(const vpImage<unsigned char> &I, const CameraModel &camera,
                                          const EllipseParameters &outline, double radius,
                                          const vpCircleMarkerFamily &family, double leastMargin,
                                          const Deadline &deadline)
{
  BlurredMarker marker(I, camera, family, deadline);
  std::vector<BlurredFit> fits = bestLooks(marker, camera, outline, radius, deadline);
  std::optional<BlurredReading> best;
  const CyclicCode &code = codeOf(family);
  for (BlurredFit &fit : fits) {
    if (!(fit.squares < HUGE_VAL)) {
      continue;
    }
    // The spin that explains most, then all together.
    marker.select(fit.plane, fit.blur, manySamples);
    BlurredFit turned = fit;
    turned.squares = HUGE_VAL;
    for (int i = 0; i < phases; ++i) {
      BlurredFit other;
      other.plane = fit.plane;
      other.blur = fit.blur;
      other.plane.spin(2. * M_PI * i / (phases * family.getNbSectors()));
      marker.solve(other);
      if (other.squares < turned.squares) {
        turned = other;
      }
    }
    // A codeword leaves no less than sectors that may have any grey.
    if (!(turned.squares < HUGE_VAL) || turned.unexplained() > mostUnexplained) {
      continue;
    }
    marker.improve(turned, finishedSteps, true);
    if (turned.samples < manySamples / 4) {
      continue; // they tell the sectors, but prove nothing
    }
    const BestWords words = bestWords(turned, code, deadline);
    const auto identity = code.identify(words.best);
    if (!identity) {
      continue;
    }
    BlurredReading reading;
    reading.fit = turned;
    reading.unexplained = words.squares / turned.plain;
    reading.code.id = identity->id;
    reading.code.margin = 1. - words.squares / words.next;
    reading.code.spin = 2. * M_PI * identity->rotation / family.getNbSectors();
    if (isCode(turned, reading.unexplained, outline) && (!best || reading.unexplained < best->unexplained)) {
      best = reading;
    }
    if (best && best->unexplained < sureUnexplained) {
      break;
    }
  }
  if (deadline.hasPassed() || !best || best->unexplained > mostUnexplained || best->code.margin < leastMargin) {
    return std::nullopt; // and no time is spent on its poses
  }
  fitBoth(marker, camera, true, *best);
  best->poses.disc = best->fit.blur.disc / outline.a;
  return deadline.hasPassed() ? std::nullopt : best;
}

std::optional<BlurredReading> fitBlurredRing(const vpImage<unsigned char> &I, const CameraModel &camera,
                                             const EllipseParameters &outline, double radius,
                                             const vpCircleMarkerFamily &family, const Deadline &deadline)
{
  BlurredMarker marker(I, camera, family, deadline);
  BlurredReading best;
  for (BlurredFit &fit : bestLooks(marker, camera, outline, radius, deadline)) {
    if (!(fit.squares < HUGE_VAL)) {
      continue;
    }
    marker.select(fit.plane, fit.blur, manySamples);
    marker.solve(fit);
    marker.improve(fit, finishedSteps, false);
    if (fit.squares < HUGE_VAL && fit.unexplained() < best.unexplained) {
      best.fit = fit;
      best.unexplained = fit.unexplained();
    }
  }
  if (deadline.hasPassed() || best.unexplained > mostUnexplainedOfRing) {
    return std::nullopt;
  }
  fitBoth(marker, camera, false, best);
  best.poses.disc = best.fit.blur.disc / outline.a;
  best.code.margin = 1.;
  return deadline.hasPassed() ? std::nullopt : std::optional<BlurredReading>(best);
}
} // namespace circle_marker
END_VISP_NAMESPACE
