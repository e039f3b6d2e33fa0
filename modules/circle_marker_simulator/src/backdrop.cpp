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
 * Image of a scene's background.
 */

#include <algorithm>
#include <cmath>
#include <vector>

#include "backdrop.h"
#include "compose.h"
#include "layers.h"
#include "random_numbers.h"

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

namespace {

// Grey levels of clutter: inside of what a camera with paper at 220 and ink at 30 delivers, and a little beyond.
constexpr double DARKEST = 15.;
constexpr double BRIGHTEST = 240.;

// Draws shapes one over the other.
class Painter
{
public:
  Painter(std::uint64_t seed, const PixelResponse &response, vpImage<float> &I)
      : m_random(seed), m_response(response), m_image(I)
  {
  }

  void gradient();
  void shape();

private:
  double grey() { return m_random.uniform(DARKEST, BRIGHTEST); }
  // Sizes are spread evenly in their logarithm: many small shapes and few large ones.
  double length(double least, double most) { return std::exp(m_random.uniform(std::log(least), std::log(most))); }
  vpImagePoint place();
  vpImagePoint from(const vpImagePoint &p, double direction, double distance);
  void paint(const vpSceneOccluder &occluder);
  void polygon();
  void disc();
  void ring();
  void bar(double least, double most);
  void writing();

  RandomNumbers m_random;
  const PixelResponse &m_response;
  vpImage<float> &m_image;
};

void Painter::gradient()
{
  const double middle = m_random.uniform(60., 190.);
  const double du = m_random.uniform(-60., 60.) / m_image.getWidth();
  const double dv = m_random.uniform(-60., 60.) / m_image.getHeight();
  for (unsigned int i = 0; i < m_image.getHeight(); ++i) {
    for (unsigned int j = 0; j < m_image.getWidth(); ++j) {
      m_image[i][j] =
          static_cast<float>(middle + du * (j - 0.5 * m_image.getWidth()) + dv * (i - 0.5 * m_image.getHeight()));
    }
  }
}

vpImagePoint Painter::place()
{
  const double v = m_random.uniform(0., m_image.getHeight());
  return vpImagePoint(v, m_random.uniform(0., m_image.getWidth()));
}

vpImagePoint Painter::from(const vpImagePoint &p, double direction, double distance)
{
  return vpImagePoint(p.get_v() + distance * std::sin(direction), p.get_u() + distance * std::cos(direction));
}

void Painter::paint(const vpSceneOccluder &occluder)
{
  addLayer(layerOf(occluder), m_response, m_image, 1., {},
           m_image); // over what is there: what is behind is the image itself
}

void Painter::polygon()
{
  const vpImagePoint center = place();
  const double size = length(5., 150.);
  const unsigned int corners = 3 + m_random.index(6);
  std::vector<vpImagePoint> points;
  for (unsigned int i = 0; i < corners; ++i) { // corners seen from the centre in turn: no crossing edges
    const double direction = 2. * M_PI * (i + m_random.uniform(0., 0.8)) / corners;
    points.push_back(from(center, direction, size * m_random.uniform(0.3, 1.)));
  }
  paint(vpSceneOccluder::polygon(points, grey()));
}

void Painter::disc()
{
  const double a = length(3., 80.);
  const double b = a * m_random.uniform(0.3, 1.);
  const double angle = m_random.uniform(0., M_PI);
  paint(vpSceneOccluder::ellipse(place(), a, b, angle, grey()));
}

void Painter::ring()
{
  const vpImagePoint center = place();
  const double a = length(5., 80.);
  const double b = a * m_random.uniform(0.3, 1.);
  const double angle = m_random.uniform(0., M_PI);
  const double ratio = m_random.uniform(0.4, 0.9);
  paint(vpSceneOccluder::ellipse(center, a, b, angle, grey()));
  paint(vpSceneOccluder::ellipse(center, ratio * a, ratio * b, angle, grey()));
}

void Painter::bar(double least, double most)
{
  const vpImagePoint start = place();
  const double direction = m_random.uniform(0., 2. * M_PI);
  const vpImagePoint end = from(start, direction, length(20., 600.));
  paint(vpSceneOccluder::bar(start, end, length(least, most), grey()));
}

void Painter::writing()
{
  vpImagePoint at = place();
  const double size = length(5., 25.);
  const double direction = m_random.uniform(-0.3, 0.3);
  const double shade = grey();
  const unsigned int letters = 3 + m_random.index(8);
  for (unsigned int letter = 0; letter < letters; ++letter) {
    const unsigned int strokes = 2 + m_random.index(3);
    for (unsigned int i = 0; i < strokes; ++i) {
      const vpImagePoint start = from(at, m_random.uniform(0., 2. * M_PI), m_random.uniform(0., 0.5 * size));
      const vpImagePoint end = from(start, m_random.uniform(0., 2. * M_PI), m_random.uniform(0.3, 0.9) * size);
      paint(vpSceneOccluder::bar(start, end, std::max(0.8, 0.12 * size), shade));
    }
    at = from(at, direction, 1.1 * size);
  }
}

void Painter::shape()
{
  switch (m_random.index(6)) {
  case 0:
    return polygon();
  case 1:
    return disc();
  case 2:
    return ring();
  case 3:
    return bar(4., 40.);
  case 4:
    return bar(0.8, 3.);
  default:
    return writing();
  }
}

} // namespace

void drawPhoto(const vpImage<unsigned char> &photo, vpImage<float> &I)
{
  const auto place = [](unsigned int i, unsigned int size, unsigned int sourceSize) {
    return std::clamp((i + 0.5) * sourceSize / size - 0.5, 0., sourceSize - 1.);
  };
  for (unsigned int i = 0; i < I.getHeight(); ++i) {
    const double y = place(i, I.getHeight(), photo.getHeight());
    const unsigned int top = static_cast<unsigned int>(y);
    const unsigned int bottom = std::min(top + 1, photo.getHeight() - 1);
    for (unsigned int j = 0; j < I.getWidth(); ++j) {
      const double x = place(j, I.getWidth(), photo.getWidth());
      const unsigned int left = static_cast<unsigned int>(x);
      const unsigned int right = std::min(left + 1, photo.getWidth() - 1);
      const double upper = photo[top][left] + (x - left) * (photo[top][right] - photo[top][left]);
      const double lower = photo[bottom][left] + (x - left) * (photo[bottom][right] - photo[bottom][left]);
      I[i][j] = static_cast<float>(upper + (y - top) * (lower - upper));
    }
  }
}

void drawClutter(std::uint64_t seed, unsigned int shapes, const PixelResponse &response, vpImage<float> &I)
{
  Painter painter(seed, response, I);
  painter.gradient();
  for (unsigned int i = 0; i < shapes; ++i) {
    painter.shape();
  }
}

} // namespace marker_simulator
END_VISP_NAMESPACE
