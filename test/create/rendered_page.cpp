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
 * Measuring a rendered page in millimetres.
 */

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "rendered_page.h"
#include "run_program.h"

namespace test {
namespace {
const double pi = std::acos(-1.);
constexpr double middleGrey = 127.5;
} // namespace

RenderedPage::RenderedPage(const cv::Mat &grey, double pixelsPerMillimetre)
    : m_grey(grey), m_density(pixelsPerMillimetre)
{
  if (grey.empty() || grey.type() != CV_8UC1) {
    throw std::runtime_error("the page was not rendered as a grey picture");
  }
}

double RenderedPage::at(double x, double y) const
{
  // Pixel (u, v) covers [u, u+1] x [v, v+1] of the paper: its centre is half a pixel from its corner.
  const double u = x * m_density - 0.5;
  const double v = y * m_density - 0.5;
  const int left = static_cast<int>(std::floor(u));
  const int top = static_cast<int>(std::floor(v));
  const auto grey = [this](int column, int row) {
    const bool inside = column >= 0 && row >= 0 && column < m_grey.cols && row < m_grey.rows;
    return inside ? static_cast<double>(m_grey.at<unsigned char>(row, column)) : 255.;
  };
  const double a = u - left;
  const double b = v - top;
  return (1 - b) * ((1 - a) * grey(left, top) + a * grey(left + 1, top)) +
         b * ((1 - a) * grey(left, top + 1) + a * grey(left + 1, top + 1));
}

int RenderedPage::darkestAround(double x, double y, double side, double diameter) const
{
  const double halfDiagonal = std::sqrt(0.5) / m_density;
  const double border = 1 / m_density;
  int darkest = 255;
  for (int row = 0; row < m_grey.rows; ++row) {
    const double dy = (row + 0.5) / m_density - y;
    for (int column = 0; column < m_grey.cols; ++column) {
      const double dx = (column + 0.5) / m_density - x;
      const bool inSquare = std::max(std::abs(dx), std::abs(dy)) <= side / 2 - border;
      if (inSquare && std::hypot(dx, dy) > diameter / 2 + halfDiagonal + border) {
        darkest = std::min(darkest, static_cast<int>(m_grey.at<unsigned char>(row, column)));
      }
    }
  }
  return darkest;
}

RenderedPage::Circle RenderedPage::circleAround(double x, double y, double from, double to) const
{
  constexpr int nbRays = 720;
  const double step = (to > from ? 0.1 : -0.1) / m_density;
  std::vector<double> radii;
  double sumX = 0, sumY = 0, sum = 0;
  for (int ray = 0; ray < nbRays; ++ray) {
    const double c = std::cos(2 * pi * ray / nbRays);
    const double s = std::sin(2 * pi * ray / nbRays);
    double radius = from;
    const bool darkBefore = at(x + from * c, y + from * s) < middleGrey;
    while ((at(x + radius * c, y + radius * s) < middleGrey) == darkBefore) {
      radius += step;
      if ((to - radius) * step < 0) {
        throw std::runtime_error("no edge between the two radii");
      }
    }
    radius -= step / 2;
    radii.push_back(radius);
    sum += radius;
    // First harmonic of the radius: the displacement of the centre.
    sumX += 2 * radius * c;
    sumY += 2 * radius * s;
  }
  const double offsetX = sumX / nbRays;
  const double offsetY = sumY / nbRays;
  Circle circle{x + offsetX, y + offsetY, 2 * sum / nbRays, 0};
  for (int ray = 0; ray < nbRays; ++ray) {
    const double angle = 2 * pi * ray / nbRays;
    const double expected = circle.diameter / 2 + offsetX * std::cos(angle) + offsetY * std::sin(angle);
    circle.roundness = std::max(circle.roundness, std::abs(radii[static_cast<std::size_t>(ray)] - expected));
  }
  return circle;
}

std::uint32_t RenderedPage::wordAround(double x, double y, double diameter, unsigned int nbSectors, bool &clean) const
{
  std::uint32_t word = 0;
  clean = true;
  for (unsigned int sector = 0; sector < nbSectors; ++sector) {
    double darkest = 255, lightest = 0;
    // Everywhere but within 1.5 pixels of the edges: there pixels are cut, and interpolation reaches for one more.
    constexpr int nbSteps = 20;
    const double border = 1.5 / m_density;
    const double inner = 0.40 * diameter / 2 + border;
    const double outer = 0.68 * diameter / 2 - border;
    for (int across = 0; across <= nbSteps; ++across) {
      const double radius = inner + (outer - inner) * across / nbSteps;
      const double first = 2 * pi * sector / nbSectors + border / radius;
      const double last = 2 * pi * (sector + 1) / nbSectors - border / radius;
      for (int along = 0; along <= nbSteps; ++along) {
        const double angle = first + (last - first) * along / nbSteps;
        const double grey = at(x + radius * std::cos(angle), y + radius * std::sin(angle));
        darkest = std::min(darkest, grey);
        lightest = std::max(lightest, grey);
      }
    }
    clean = clean && (lightest < 5 || darkest > 250);
    word = (word << 1) | (lightest < middleGrey ? 1 : 0);
  }
  return word;
}

double RenderedPage::darkLength(double y, double fromX, double toX) const
{
  const double step = 0.1 / m_density;
  double first = std::numeric_limits<double>::quiet_NaN();
  double last = first;
  for (double x = fromX; x <= toX; x += step) {
    if (at(x, y) < middleGrey) {
      first = std::isnan(first) ? x : first;
      last = x;
    }
  }
  return last - first + step;
}

RenderedPage loadPage(const std::filesystem::path &file, double pixelsPerMillimetre)
{
  return RenderedPage(cv::imread(file.string(), cv::IMREAD_GRAYSCALE), pixelsPerMillimetre);
}

RenderedPage renderPdf(const std::filesystem::path &folder, const std::string &file, int page, int dotsPerInch)
{
  const std::string number = std::to_string(page);
  const std::string density = std::to_string(dotsPerInch);
  const Outcome outcome =
      run(PDFTOPPM, {"-gray", "-singlefile", "-r", density, "-f", number, "-l", number, file, "page"}, folder);
  EXPECT_EQ(0, outcome.status) << outcome.err;
  return loadPage(folder / "page.pgm", dotsPerInch / 25.4);
}

RenderedPage renderSvg(const std::filesystem::path &folder, const std::string &file, double width, double density)
{
  const std::string pixels = std::to_string(std::lround(width * density));
  const Outcome outcome = run(
      RSVG_CONVERT,
      {"--width", pixels, "--keep-aspect-ratio", "--background-color", "white", "--output", "page.png", file}, folder);
  EXPECT_EQ(0, outcome.status) << outcome.err;
  return loadPage(folder / "page.png", static_cast<double>(std::lround(width * density)) / width);
}

bool isMissing(const char *program)
{
  return std::string(program).empty();
}
} // namespace test
