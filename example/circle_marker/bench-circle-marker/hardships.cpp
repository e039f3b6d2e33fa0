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
 * Frames whose marker is covered in part, or whose picture is bad.
 */

#include "hardships.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include <visp3/circle_marker/vpCircleMarkerFamily.h>

#include "hard_pictures.h"

namespace bench {
namespace {
using Random = std::mt19937_64;

constexpr unsigned int imageWidth = 640;  // pixels
constexpr unsigned int imageHeight = 480; // pixels
constexpr double leastDiameter = 40.;     // of the ring before its tilt, pixels
constexpr double mostDiameter = 160.;     // pixels
constexpr double leastSmall = 12.;        // of small ones, pixels
constexpr double mostSmall = 45.;         // pixels
constexpr double mostTilt = M_PI / 3.;    // rad
constexpr int halvings = 24;              // of an interval that has the covered share: to 1e-7 of it

double uniform(Random &random, double low, double high)
{
  return std::uniform_real_distribution<double>(low, high)(random);
}

struct Point
{
  double x; // in the marker's plane, in units of the ring's outer radius
  double y;
};
using Polygon = std::vector<Point>;

/*! Shapes that grow with a number, without an end. */
using Growing = std::function<std::vector<Polygon>(double)>;

bool isInside(const Polygon &polygon, const Point &p)
{
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Point &a = polygon[i];
    const Point &b = polygon[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) {
      inside = !inside;
    }
  }
  return inside;
}

// Share of the points of the unit disc, on a grid, for which something is so.
template <typename Predicate> double shareOfDisc(const Predicate &isSo)
{
  constexpr int side = 81;
  int all = 0;
  int so = 0;
  for (int i = 0; i < side * side; ++i) {
    const Point p = {2. * (i % side) / (side - 1.) - 1., 2. * (i / side) / (side - 1.) - 1.};
    if (p.x * p.x + p.y * p.y <= 1.) {
      ++all;
      so += isSo(p) ? 1 : 0;
    }
  }
  return static_cast<double>(so) / all;
}

// The least number for which something that grows with it reaches a level.
template <typename Grows> double numberFor(double level, double low, double high, const Grows &grows)
{
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    (grows(middle) < level ? low : high) = middle;
  }
  return high;
}

Polygon strip(double direction, double from, double to)
{
  constexpr double far = 3.; // radii: beyond the sheet
  const double c = std::cos(direction);
  const double s = std::sin(direction);
  const auto at = [&](double along, double across) { return Point{c * along - s * across, s * along + c * across}; };
  return {at(from, -far), at(to, -far), at(to, far), at(from, far)};
}

Growing halfPlane(Random &random)
{
  const double direction = uniform(random, 0., 2. * M_PI);
  return [direction](double size) { return std::vector<Polygon>{strip(direction, 1. - size, 3.)}; };
}

Growing bars(Random &random, int count)
{
  std::vector<std::pair<double, double>> axes; // direction and place
  for (int i = 0; i < count; ++i) {
    axes.emplace_back(uniform(random, 0., 2. * M_PI), uniform(random, 0., 0.8));
  }
  return [axes](double size) {
    std::vector<Polygon> strips;
    for (const auto &[direction, place] : axes) {
      strips.push_back(strip(direction, place - 0.5 * size, place + 0.5 * size));
    }
    return strips;
  };
}

// Round or angular shapes that lie anywhere on the marker.
Growing blobs(Random &random, int count, bool round)
{
  std::vector<std::pair<Point, Polygon>> shapes; // place, and corners about it
  for (int i = 0; i < count; ++i) {
    const double angle = uniform(random, 0., 2. * M_PI);
    const double distance = std::sqrt(uniform(random, 0., 1.));
    const double turn = uniform(random, 0., M_PI);
    const double slender = uniform(random, 0.5, 1.);
    const int corners = round ? 60 : static_cast<int>(uniform(random, 3., 9.));
    Polygon shape;
    for (int k = 0; k < corners; ++k) {
      const double a = 2. * M_PI * (k + (round ? 0. : uniform(random, 0., 0.8))) / corners;
      const double r = round ? 1. : uniform(random, 0.5, 1.2);
      const double x = r * std::cos(a);
      const double y = r * slender * std::sin(a);
      shape.push_back({std::cos(turn) * x - std::sin(turn) * y, std::sin(turn) * x + std::cos(turn) * y});
    }
    shapes.emplace_back(Point{distance * std::cos(angle), distance * std::sin(angle)}, shape);
  }
  return [shapes](double size) {
    std::vector<Polygon> polygons;
    for (const auto &[place, corners] : shapes) {
      Polygon polygon;
      for (const Point &corner : corners) {
        polygon.push_back({place.x + size * corner.x, place.y + size * corner.y});
      }
      polygons.push_back(polygon);
    }
    return polygons;
  };
}

/*! What is drawn of a frame before something happens to it. */
struct Draft
{
  vpMarkerSceneSimulator simulator;
  vpScenePhotometry photometry;
  double diameter = 0.; // of the ring before its tilt, pixels
  double tilt = 0.;     // rad
  double u = 0.;        // place of the marker's centre, pixels
  double v = 0.;
  std::uint64_t poseSeed = 0;

  vpHomogeneousMatrix pose() const
  {
    return randomPose(poseSeed, simulator.getCameraParameters(), diameter, tilt, u, v);
  }

  vpImagePoint project(const vpHomogeneousMatrix &cMo, const Point &p) const
  {
    const double x = 0.5 * markerSize * p.x;
    const double y = 0.5 * markerSize * p.y;
    return simulator.project(cMo[0][0] * x + cMo[0][1] * y + cMo[0][3], cMo[1][0] * x + cMo[1][1] * y + cMo[1][3],
                             cMo[2][0] * x + cMo[2][1] * y + cMo[2][3]);
  }
};

void cover(Draft &draft, const Growing &growing, double share, Random &random)
{
  const auto covered = [&growing](double size) {
    const std::vector<Polygon> shapes = growing(size);
    return shareOfDisc([&shapes](const Point &p) {
      return std::any_of(shapes.begin(), shapes.end(), [&p](const Polygon &shape) { return isInside(shape, p); });
    });
  };
  constexpr double largest = 2.5; // radii: any shape covers all of the marker
  const vpHomogeneousMatrix cMo = draft.pose();
  for (const Polygon &shape : growing(numberFor(share, 0., largest, covered))) {
    std::vector<vpImagePoint> corners;
    for (const Point &corner : shape) {
      corners.push_back(draft.project(cMo, corner));
    }
    draft.simulator.addOccluder(vpSceneOccluder::polygon(corners, uniform(random, 20., 230.)));
  }
}

// The marker is moved over the image's border.
void moveOut(Draft &draft, double share, Random &random)
{
  const bool sideways = uniform(random, 0., 1.) < 0.5;
  const bool back = uniform(random, 0., 1.) < 0.5;
  double &place = sideways ? draft.u : draft.v;
  const double size = sideways ? imageWidth : imageHeight;
  const auto outside = [&](double distance) {
    place = back ? -distance : size - 1. + distance;
    const vpHomogeneousMatrix cMo = draft.pose();
    return shareOfDisc([&](const Point &p) {
      const vpImagePoint image = draft.project(cMo, p);
      return image.get_u() < -0.5 || image.get_v() < -0.5 || image.get_u() > imageWidth - 0.5 ||
             image.get_v() > imageHeight - 0.5;
    });
  };
  outside(numberFor(share, -mostDiameter, mostDiameter, outside));
}

void spoil(Draft &draft, const Hardship &hardship, Random &random, vpSceneMotion &motion, double &sheet)
{
  vpScenePhotometry &photometry = draft.photometry;
  const double direction = uniform(random, 0., 2. * M_PI);
  const auto name = [&hardship](const char *kind) { return hardship.name == kind; };
  if (name("contrast")) {
    photometry.paper = 120. + 0.5 * hardship.level;
    photometry.ink = 120. - 0.5 * hardship.level;
  }
  else if (name("noise") || isOfPictures(hardship)) {
    photometry.noiseSigma = hardship.level;
  }
  else if (name("motion")) {
    const double way = hardship.level * markerSize;
    motion.twist[0] = way * std::cos(direction);
    motion.twist[1] = way * std::sin(direction);
  }
  else if (name("defocus")) {
    photometry.defocusRadius = 0.5 * hardship.level * draft.diameter;
  }
  else if (name("light gradient")) {
    photometry.gradientU = hardship.level * imageWidth / draft.diameter * std::cos(direction);
    photometry.gradientV = hardship.level * imageHeight / draft.diameter * std::sin(direction);
    photometry.lightCenter = vpImagePoint(draft.v, draft.u);
    photometry.paper = 160.; // so that the brighter side is not cut off
  }
  else if (name("shadow")) {
    vpSceneShadow shadow;
    const double place = uniform(random, -0.4, 0.4) * draft.diameter;
    shadow.edge = vpImagePoint(draft.v + place * std::sin(direction), draft.u + place * std::cos(direction));
    shadow.direction = direction;
    shadow.factor = hardship.level;
    shadow.penumbra = uniform(random, 0.5, 3.);
    photometry.shadow = shadow;
  }
  else if (name("reflection")) { // of a lamp, on glossy paper
    photometry.paper = 150.;     // so that the brighter side is not cut off
    const auto aside = [&] { return uniform(random, -0.4, 0.4) * draft.diameter; };
    vpSceneReflection reflection;
    reflection.center = vpImagePoint(draft.v + aside(), draft.u + aside());
    reflection.radius = uniform(random, 0.2, 0.3) * draft.diameter;
    reflection.grey = hardship.level * (photometry.paper - photometry.ink);
    photometry.reflection = reflection;
  }
  else if (name("over-exposure")) {
    photometry.paper *= hardship.level;
    photometry.ink *= hardship.level;
  }
  else if (name("quiet zone")) {
    sheet = markerSize * (1. + hardship.level);
  }
  else if (name("gamma 0.45, contrast raised")) {
    photometry.gamma = 0.45;
  }
  else if (name("three bars over a quarter, gamma")) {
    cover(draft, bars(random, 3), 0.25, random);
    photometry.gamma = hardship.level;
  }
  else if (name("three bars over a quarter, over-exposure")) {
    cover(draft, bars(random, 3), 0.25, random);
    photometry.paper *= hardship.level;
    photometry.ink *= hardship.level;
  }
  else if (name("three bars over a quarter, motion")) {
    cover(draft, bars(random, 3), 0.25, random);
    motion.twist[0] = hardship.level * markerSize * std::cos(direction);
    motion.twist[1] = hardship.level * markerSize * std::sin(direction);
  }
  else if (name("JPEG")) {
    photometry.jpegQuality = static_cast<int>(hardship.level);
  }
}
} // namespace

const std::vector<Hardship> &hardships()
{
  static const std::vector<Hardship> list = [] {
    std::vector<Hardship> all = {{"nothing", 0., false}};
    for (const double share : {0.1, 0.25, 0.4}) {
      for (const char *shape : {"half plane", "bar", "three bars", "blob", "polygon", "three blobs", "border"}) {
        all.push_back({shape, share, true});
      }
    }
    for (const Hardship &hardship : {Hardship{"contrast", 50.},
                                     {"contrast", 25.},
                                     {"noise", 10.},
                                     {"noise", 20.},
                                     {"colour sensor, noise", 2.},
                                     {"colour sensor, noise", 10.},
                                     {"smoothed, noise", 2.},
                                     {"smoothed, noise", 10.},
                                     {"enlarged, noise", 2.},
                                     {"enlarged, noise", 10.},
                                     {"undistorted, noise", 2.},
                                     {"undistorted, noise", 10.},
                                     {"sharpened by 1 pixel", 0.5},
                                     {"sharpened by 1 pixel", 1.},
                                     {"sharpened by 1 pixel", 2.},
                                     {"sharpened by 2 pixels", 0.5},
                                     {"sharpened by 2 pixels", 1.},
                                     {"sharpened by 2 pixels", 2.},
                                     {"contrast raised", 3.},
                                     {"contrast raised", 5.},
                                     {"gamma 0.45, contrast raised", 4.},
                                     {"motion", 0.1},
                                     {"motion", 0.25},
                                     {"defocus", 0.08},
                                     {"defocus", 0.15},
                                     {"darker corners", 0.64},
                                     {"darker corners", 0.4},
                                     {"light gradient", 0.5},
                                     {"light gradient", 0.9},
                                     {"shadow", 0.5},
                                     {"shadow", 0.25},
                                     {"reflection", 0.3},
                                     {"reflection", 0.7},
                                     {"over-exposure", 1.5},
                                     {"over-exposure", 2.5},
                                     {"quiet zone", 1. / 6.},
                                     {"JPEG", 75.},
                                     {"JPEG", 50.},
                                     {"three bars over a quarter, gamma", 0.45},
                                     {"three bars over a quarter, gamma", 2.2},
                                     {"three bars over a quarter, motion", 0.03},
                                     {"three bars over a quarter, motion", 0.06},
                                     {"three bars over a quarter, over-exposure", 1.5},
                                     {"three bars over a quarter, over-exposure", 2.5}}) {
      all.push_back(hardship);
    }
    return all;
  }();
  return list;
}

Scene makeHardScene(const Hardship &hardship, const std::string &family, std::uint64_t seed, HardMarkers markers)
{
  Random random(seed);
  Draft draft = {vpMarkerSceneSimulator(hardCamera(hardship, imageWidth, imageHeight), imageWidth, imageHeight), {}};
  const bool isSmall = markers == HardMarkers::SMALL;
  const double least = isSmall ? leastSmall : leastDiameter;
  draft.diameter = least * std::pow((isSmall ? mostSmall : mostDiameter) / least, uniform(random, 0., 1.));
  if (isSmall) {
    draft.photometry = anyPhotometry(~seed);
  }
  draft.tilt = uniform(random, 0., mostTilt);
  draft.poseSeed = random();
  const double margin = 0.85 * draft.diameter; // half the diagonal of the sheet
  draft.u = uniform(random, margin, imageWidth - margin);
  draft.v = uniform(random, margin, imageHeight - margin);
  const bool isCoded = vpCircleMarkerFamily::fromName(family).isCoded();
  const int id = isCoded ? static_cast<int>(random() % vpSimulatedMarker::codewords(family).size()) : -1;
  constexpr unsigned int shapes = 30; // as many a pixel as on the larger frames
  // A thin quiet zone is on black ground; the other frames are on clutter.
  const bool onBlack = hardship.name == "quiet zone";
  draft.simulator.setBackground(onBlack ? vpSceneBackground::plain(20.) : vpSceneBackground::clutter(random(), shapes));
  vpSceneMotion motion;
  double sheet = markerSize * 7. / 6.;
  if (!hardship.covers) {
    spoil(draft, hardship, random, motion, sheet);
  }
  else if (hardship.name == "border") {
    moveOut(draft, hardship.level, random);
  }
  else {
    const Growing growing = hardship.name == "half plane"   ? halfPlane(random)
                            : hardship.name == "bar"        ? bars(random, 1)
                            : hardship.name == "three bars" ? bars(random, 3)
                            : hardship.name == "blob"       ? blobs(random, 1, true)
                            : hardship.name == "polygon"    ? blobs(random, 1, false)
                                                            : blobs(random, 3, true);
    cover(draft, growing, hardship.level, random);
  }
  draft.simulator.setPhotometry(draft.photometry);
  draft.simulator.setMotion(motion);
  vpSimulatedMarker marker = vpSimulatedMarker::circle(family, id, markerSize);
  draft.simulator.addMarker(marker.setSheetSide(sheet).setPose(draft.pose()));
  Scene scene;
  scene.camera = draft.simulator.getCameraParameters();
  scene.truth = draft.simulator.render(scene.image, seed);
  processPicture(hardship, draft.photometry.noiseSigma, seed, scene);
  return scene;
}
} // namespace bench
