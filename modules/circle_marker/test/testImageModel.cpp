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
 * The image model against brute-force integration, and its derivatives against finite differences.
 */

#include "testDarkness.h"
#include "testPatternDistance.h"
#include "testRoomTools.h"

#include "refine/fit_pixels.h"
#include "support/camera_model.h"

using namespace circle_marker;
using namespace room_test;

namespace {
constexpr unsigned int side = 130;

struct Error
{
  double worst = 0.;
  double squares = 0.;
  int pixels = 0; // that see an edge

  double rootMeanSquare() const { return std::sqrt(squares / pixels); }
};

ModelPixel pixelAt(const CameraModel &camera, const Eigen::Vector2d &where)
{
  return {camera.toMeter(where), camera.meterPerPixel(where)};
}

//! The scene as share of black, on paper without end.
MarkerScene asDarkness(MarkerScene scene)
{
  scene.white = 0.;
  scene.black = 1.;
  scene.sheet = 1e9;
  return scene;
}

//! A scene that moves by (u, v) pixels with normal chance while the shutter is open.
vpImage<double> exposeMoved(const MarkerScene &scene, double blur, const Eigen::Vector2d &motion)
{
  vpImage<double> sum(side, side, 0.);
  double total = 0.;
  constexpr double step = 0.5; // of the normal chance's standard deviation: its sum is exact to 1e-8
  for (double place = -4.; place <= 4.; place += step) {
    const double weight = std::exp(-0.5 * place * place);
    const auto moved = [&](double u, double v) { return scene(u + place * motion.x(), v + place * motion.y()); };
    const vpImage<double> still = expose(side, side, blur, moved, 8);
    for (unsigned int i = 0; i < sum.getSize(); ++i) {
      sum.bitmap[i] += weight * still.bitmap[i];
    }
    total += weight;
  }
  for (unsigned int i = 0; i < sum.getSize(); ++i) {
    sum.bitmap[i] /= total;
  }
  return sum;
}

//! Model against integration at every pixel of the image.
Error compare(const MarkerScene &scene, const vpImage<double> &truth, const BlurParameters &parameters)
{
  const CameraModel camera(scene.camera());
  const MarkerPlane plane = scene.plane();
  const MarkerPattern pattern = patternOf(scene.family, scene.family.isCoded() ? 0 : -1);
  MarkerPattern printed = pattern;
  printed.setWord(scene.word);
  Error error;
  for (unsigned int v = 0; v < side; ++v) {
    for (unsigned int u = 0; u < side; ++u) {
      const double value = darknessAt(pixelAt(camera, Eigen::Vector2d(u, v)), plane, printed, parameters).value;
      const double difference = std::fabs(value - truth[v][u]);
      error.worst = std::max(error.worst, difference);
      if (truth[v][u] > 0.001 && truth[v][u] < 0.999) {
        error.squares += difference * difference;
        ++error.pixels;
      }
    }
  }
  return error;
}

Error compare(const MarkerScene &scene, double blur)
{
  BlurParameters parameters;
  parameters.sigma = std::sqrt(blur * blur + 1. / 12.);
  return compare(scene, expose(side, side, blur, asDarkness(scene), 8), parameters);
}

const vpCircleMarkerFamily::vpType families[] = {vpCircleMarkerFamily::GOLAY23, vpCircleMarkerFamily::BCH31,
                                                 vpCircleMarkerFamily::BCH31R, vpCircleMarkerFamily::RING,
                                                 vpCircleMarkerFamily::DISC};

int randomId(Random &random, const vpCircleMarkerFamily &family)
{
  return family.isCoded() ? static_cast<int>(random() % family.getNbIds()) : -1;
}
} // namespace

TEST(ImageModel, AgreesWithIntegrationFromSixtyPixels)
{
  Random random = randomOfTest();
  for (const vpCircleMarkerFamily::vpType type : families) {
    const vpCircleMarkerFamily family(type);
    for (int i = 0; i < 12; ++i) {
      const double diameter = uniform(random, 60., 100.);
      const double tilt = uniform(random, 0., 0.7);
      const double blur = uniform(random, 0.5, 0.9);
      const MarkerScene scene = markerScene(random, family, randomId(random, family), diameter, tilt, side);
      const Error error = compare(scene, blur);
      // The worst pixels are the corners of sectors at the track's inner rim, whose image curves by a pixel in 12.
      EXPECT_LT(error.worst, 0.01) << family.getName() << " diameter " << diameter << " tilt " << tilt << " blur "
                                   << blur;
      EXPECT_LT(error.rootMeanSquare(), 0.0015) << family.getName() << " diameter " << diameter << " tilt " << tilt;
    }
  }
}

TEST(ImageModel, AgreesWithIntegrationAtTwentyPixels)
{
  Random random = randomOfTest();
  for (const vpCircleMarkerFamily::vpType type : families) {
    const vpCircleMarkerFamily family(type);
    for (int i = 0; i < 12; ++i) {
      const double tilt = uniform(random, 0., 0.7);
      MarkerScene scene = markerScene(random, family, randomId(random, family), 20., tilt, side);
      const Error error = compare(scene, 0.7);
      EXPECT_LT(error.worst, 0.05) << family.getName() << " tilt " << tilt;
      EXPECT_LT(error.rootMeanSquare(), 0.012) << family.getName() << " tilt " << tilt;
    }
  }
}

// Before a wide lens a marker that leans is seen in a perspective that changes within the blur of an edge: here by up
// to 0.6 % a pixel. Its farther edges are narrower than its nearer ones.
TEST(ImageModel, AgreesWithIntegrationInStrongPerspective)
{
  Random random = randomOfTest();
  Error all;
  for (const vpCircleMarkerFamily::vpType type : families) {
    const vpCircleMarkerFamily family(type);
    for (int i = 0; i < 12; ++i) {
      MarkerScene scene = markerScene(random, family, randomId(random, family), uniform(random, 70., 110.),
                                      uniform(random, 0.7, 1.1), side);
      scene.focal /= 4.; // at a quarter of the distance its image has the same size
      scene.center.z() /= 4.;
      const Error error = compare(scene, 0.8);
      EXPECT_LT(error.rootMeanSquare(), 0.002) << family.getName(); // the slender ones of 31 sectors
      all.squares += error.squares;
      all.pixels += error.pixels;
    }
  }
  EXPECT_LT(all.rootMeanSquare(), 0.0007); // and 0.0012 if distances to edges were as in a parallel projection
}

TEST(ImageModel, AgreesWithIntegrationInMotion)
{
  Random random = randomOfTest();
  for (const vpCircleMarkerFamily::vpType type : families) {
    const vpCircleMarkerFamily family(type);
    for (int i = 0; i < 2; ++i) {
      const MarkerScene scene = markerScene(random, family, randomId(random, family), uniform(random, 80., 100.),
                                            uniform(random, 0., 0.5), side);
      const double blur = uniform(random, 0.5, 0.7);
      const double moved = uniform(random, 0.5, 1.2);
      const double angle = uniform(random, 0., M_PI);
      const Eigen::Vector2d direction(std::cos(angle), std::sin(angle));
      // Variances across and along the motion; sigma^2 is their geometric mean, exp(4 size) their ratio.
      const double across = blur * blur + 1. / 12.;
      const double along = across + moved * moved;
      BlurParameters parameters;
      parameters.sigma = std::sqrt(std::sqrt(across * along));
      parameters.elongation =
          0.25 * std::log(along / across) * Eigen::Vector2d(std::cos(2. * angle), std::sin(2. * angle));
      const Error error = compare(scene, exposeMoved(asDarkness(scene), blur, moved * direction), parameters);
      EXPECT_LT(error.worst, 0.015) << family.getName() << " moved " << moved << " angle " << angle;
      EXPECT_LT(error.rootMeanSquare(), 0.002) << family.getName() << " moved " << moved << " angle " << angle;
    }
  }
}

TEST(ImageModel, FarFromTheEdgesItIsBlackOrWhite)
{
  Random random = randomOfTest();
  for (int i = 0; i < 10; ++i) {
    const vpCircleMarkerFamily family(vpCircleMarkerFamily::GOLAY23);
    const MarkerScene scene = markerScene(random, family, 17, 100., uniform(random, 0., 0.7), side);
    const MarkerPattern pattern = patternOf(family, 17);
    const CameraModel camera(scene.camera());
    int flat = 0;
    for (unsigned int v = 0; v < side; v += 2) {
      for (unsigned int u = 0; u < side; u += 2) {
        const ModelPixel pixel = pixelAt(camera, Eigen::Vector2d(u, v));
        const PatternDistance distance = distanceToPattern(pixel, scene.plane(), pattern);
        const Eigen::Vector2d q = scene.onMarker(u, v);
        EXPECT_NEAR(distance.radius, std::max(q.norm(), 1e-6), 1e-9);
        if (distance.toEdges > 5.) {
          const Darkness darkness = darknessAt(pixel, scene.plane(), pattern, BlurParameters());
          EXPECT_NEAR(darkness.value, scene.isBlack(q) ? 1. : 0., 1e-5);
          EXPECT_LT(std::fabs(darkness.bySigma), 1e-4);
          ++flat;
        }
      }
    }
    EXPECT_GT(flat, 100);
  }
}

TEST(ImageModel, DistanceToEdgesIsThatOfThePrint)
{
  // Walk from a pixel in all directions until the print changes colour: the first change is the nearest edge.
  Random random = randomOfTest();
  for (int i = 0; i < 8; ++i) {
    const vpCircleMarkerFamily family(families[i % 4]);
    const int id = randomId(random, family);
    const MarkerScene scene = markerScene(random, family, id, 90., uniform(random, 0., 0.7), side);
    const MarkerPattern pattern = patternOf(family, id);
    const CameraModel camera(scene.camera());
    for (int k = 0; k < 150; ++k) {
      const Eigen::Vector2d where(std::floor(uniform(random, 20., 110.)), std::floor(uniform(random, 20., 110.)));
      const double distance = distanceToPattern(pixelAt(camera, where), scene.plane(), pattern).toEdges;
      const bool here = scene.isBlack(scene.onMarker(where.x(), where.y()));
      double nearest = HUGE_VAL;
      for (int direction = 0; direction < 90; ++direction) {
        const Eigen::Vector2d step(std::cos(2. * M_PI * direction / 90.), std::sin(2. * M_PI * direction / 90.));
        for (double t = 0.05; t < std::min(nearest, 4.); t += 0.05) {
          const Eigen::Vector2d p = where + t * step;
          if (scene.isBlack(scene.onMarker(p.x(), p.y())) != here) {
            nearest = t;
            break;
          }
        }
      }
      if (nearest < 3.) {
        // Never farther than the truth, but for first order; nearer only where a rim of the track is white.
        EXPECT_LT(distance, nearest + 0.3) << "pixel " << where.transpose();
      }
      else if (!family.isCoded()) {
        EXPECT_GT(distance, 2.6) << "pixel " << where.transpose();
      }
    }
  }
}

TEST(ImageModel, TheValueIsTheSameWithoutItsDerivatives)
{
  Random random = randomOfTest();
  const vpImage<unsigned char> I(side, side, 0);
  double worst = 0.;
  int seen = 0;
  for (const vpCircleMarkerFamily::vpType type : families) {
    const vpCircleMarkerFamily family(type);
    for (const int borders : {1, 3, 5}) {
      const int id = randomId(random, family);
      const MarkerScene scene = markerScene(random, family, id, 60., uniform(random, 0.2, 1.), side);
      const MarkerPlane plane = scene.plane();
      const MarkerPattern pattern = patternOf(family, id);
      std::vector<FitPixel> pixels;
      selectPixels(I, CameraModel(scene.camera()), scene.frame(), &plane, 1, pattern, {BlurParameters(), 0.3, 1e6},
                   pixels);
      PixelBlocks blocks;
      packPixels(pixels, plane, pattern, Photometry(), 2., 1., borders, blocks);
      const ImageModel model(plane, pattern, BlurParameters(), blocks);
      for (std::size_t kind = 0; kind < pixelSights; ++kind) {
        for (const PixelBlock &block : blocks.bySight[kind]) {
          DarknessLanes all;
          Lanes value;
          model.evaluate(block, static_cast<PixelSight>(kind), all);
          model.evaluate(block, static_cast<PixelSight>(kind), value);
          worst = std::max(worst, static_cast<double>((value - all.value).abs().maxCoeff()));
          ++seen;
        }
      }
    }
  }
  EXPECT_GT(seen, 1000);
  EXPECT_LT(worst, 1e-6); // compilers may round differently
}

TEST(ImageModel, SpreadMovesEveryEdgeOutward)
{
  // Ink that has spread by s has each of its edges displaced by s: for the ring, other radii.
  Random random = randomOfTest();
  MarkerScene scene = markerScene(random, vpCircleMarkerFamily::ring(0.8), -1, 90., 0., side);
  const CameraModel camera(scene.camera());
  const MarkerPattern pattern = patternOf(scene.family, -1);
  const double perPixel = scene.center.z() / (scene.focal * scene.radius);
  BlurParameters spread;
  spread.spread = 0.25 * perPixel;
  MarkerPattern larger = pattern;
  larger.ring[0].radius += 0.25 * perPixel;
  larger.ring[1].radius -= 0.25 * perPixel;
  for (unsigned int v = 0; v < side; ++v) {
    for (unsigned int u = 0; u < side; ++u) {
      const ModelPixel pixel = pixelAt(camera, Eigen::Vector2d(u, v));
      EXPECT_NEAR(darknessAt(pixel, scene.plane(), pattern, spread).value,
                  darknessAt(pixel, scene.plane(), larger, BlurParameters()).value, 0.002);
    }
  }
}
