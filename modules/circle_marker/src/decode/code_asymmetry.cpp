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
 * Whether what an outline holds differs in opposite directions as a code does.
 */

#include "decode/code_asymmetry.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Cholesky>

#include "support/sensor_range.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// How much more than the noise the differences are at least: in standard deviations of their mean square, and, root
// mean square, as a share of the range of grey levels inside. Of a thousand golay23 and bch31 of 8 to 30 pixels that
// were found, with what else they are found by, the least were 1.8 and 0.033.
constexpr double leastSignificance = 1.5;
constexpr double leastShare = 0.025;
// And how large they are at most, root mean square, as a share of that range: of those markers 0.25. Half a ring at the
// edge of something has 0.4.
constexpr double mostShare = 0.35;

// What opposite pixels differ by.
struct Asymmetry
{
  double variance = 0.; // of a pixel, as far as nothing symmetric explains it, squared grey levels
  double freedom = 0.;  // number of differences that it was told from
  double range = 0.;    // of the means of opposite pixels, grey levels
  Eigen::Vector2i away; // where the centre is rather, half pixels
};

// Adds up the differences of all pixels inside of an outline from those opposite to them.
class OppositePixels
{
public:
  // twice: coordinates of the centre in half pixels.
  OppositePixels(const vpImage<unsigned char> &I, const EllipseParameters &outline, const Eigen::Vector2i &twice)
      : m_image(I), m_outline(outline), m_axis(std::cos(outline.angle), std::sin(outline.angle)), m_twiceU(twice.x()),
        m_twiceV(twice.y())
  {
  }

  std::optional<Asymmetry> compare()
  {
    const int reach = static_cast<int>(std::ceil(2. * m_outline.a)) + 1;
    for (int v = (m_twiceV + 1) / 2; 2 * v <= m_twiceV + reach; ++v) { // the lower half; the other is opposite
      for (int u = (m_twiceU - reach) / 2; 2 * u <= m_twiceU + reach; ++u) {
        const bool isCounted = 2 * v > m_twiceV || 2 * u > m_twiceU;
        if (isCounted && isInside(u, v) && hasNeighbours(u, v) && hasNeighbours(m_twiceU - u, m_twiceV - v)) {
          add(u, v);
        }
      }
    }
    if (m_count <= unknowns) {
      return std::nullopt;
    }
    Asymmetry result;
    result.freedom = m_count - unknowns;
    result.range = m_most - m_least;
    const Eigen::Matrix<double, unknowns, 1> fitted = m_matrix.ldlt().solve(m_right);
    result.variance = std::max(0., m_squares - fitted.dot(m_right)) / (2. * result.freedom);
    // f(d - x) - f(-d - x) = f(d - x) - f(d + x) is -2 x times the gradient of the symmetric f.
    const Eigen::Vector2d halves = (-2. * fitted.head<2>()).cwiseMax(-1.).cwiseMin(1.);
    result.away = halves.array().round().cast<int>();
    return result;
  }

private:
  static constexpr int unknowns = 4; // two of the centre's place, two of the light's gradient

  bool isInside(int u, int v) const
  {
    const double du = u - 0.5 * m_twiceU;
    const double dv = v - 0.5 * m_twiceV;
    const double along = (du * m_axis.x() + dv * m_axis.y()) / m_outline.a;
    const double across = (dv * m_axis.x() - du * m_axis.y()) / m_outline.b;
    return along * along + across * across < 1.;
  }

  bool hasNeighbours(int u, int v) const
  {
    return u >= 1 && v >= 1 && u + 1 < static_cast<int>(m_image.getWidth()) &&
           v + 1 < static_cast<int>(m_image.getHeight());
  }

  double at(int u, int v) const { return m_image[static_cast<unsigned int>(v)][static_cast<unsigned int>(u)]; }

  Eigen::Vector2d gradientAt(int u, int v) const
  {
    return {0.5 * (at(u + 1, v) - at(u - 1, v)), 0.5 * (at(u, v + 1) - at(u, v - 1))};
  }

  void add(int u, int v)
  {
    const int u2 = m_twiceU - u;
    const int v2 = m_twiceV - v;
    const double difference = at(u, v) - at(u2, v2);
    const double mean = 0.5 * (at(u, v) + at(u2, v2));
    Eigen::Matrix<double, unknowns, 1> derivatives;
    derivatives.head<2>() = gradientAt(u, v) - gradientAt(u2, v2);
    derivatives.tail<2>() << u - u2, v - v2;
    m_matrix += derivatives * derivatives.transpose();
    m_right += difference * derivatives;
    m_squares += difference * difference;
    m_least = std::min(m_least, mean);
    m_most = std::max(m_most, mean);
    ++m_count;
  }

  const vpImage<unsigned char> &m_image;
  const EllipseParameters &m_outline;
  const Eigen::Vector2d m_axis;
  const int m_twiceU; // the centre, to half a pixel: there a pixel is opposite to each pixel
  const int m_twiceV;
  int m_count = 0;
  double m_squares = 0.;
  double m_least = HUGE_VAL;
  double m_most = -HUGE_VAL;
  Eigen::Matrix<double, unknowns, unknowns> m_matrix = Eigen::Matrix<double, unknowns, unknowns>::Zero();
  Eigen::Matrix<double, unknowns, 1> m_right = Eigen::Matrix<double, unknowns, 1>::Zero();
};
} // namespace

bool isAsymmetricAsCode(const vpImage<unsigned char> &I, const EllipseParameters &outline, double noise)
{
  constexpr int looks = 3; // from the outline's centre to one that is right to a quarter of a pixel
  Eigen::Vector2i twice = (2. * outline.center).array().round().cast<int>();
  std::optional<Asymmetry> asymmetry;
  for (int look = 0; look < looks; ++look) {
    const auto here = OppositePixels(I, outline, twice).compare();
    if (!here) {
      return false;
    }
    if (!asymmetry || here->variance < asymmetry->variance) {
      asymmetry = here;
    }
    if (here->away.isZero()) {
      break;
    }
    twice += here->away;
  }
  const double ofNoise = std::max(noise * noise, quantisation * quantisation);
  const double significance = (asymmetry->variance / ofNoise - 1.) * std::sqrt(0.5 * asymmetry->freedom);
  const auto squareOf = [&](double share) { return share * share * asymmetry->range * asymmetry->range; };
  return significance > leastSignificance && asymmetry->variance - ofNoise > squareOf(leastShare) &&
         asymmetry->variance - ofNoise < squareOf(mostShare);
}
} // namespace circle_marker
END_VISP_NAMESPACE
