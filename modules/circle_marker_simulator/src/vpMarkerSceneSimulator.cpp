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
 * Simulated camera that looks at printed markers.
 */

#include <algorithm>
#include <cmath>

#include <visp3/core/vpException.h>
#include <visp3/core/vpExponentialMap.h>

#include <visp3/circle_marker_simulator/vpMarkerSceneSimulator.h>

#include "backdrop.h"
#include "compose.h"
#include "jpeg_loss.h"
#include "layers.h"
#include "lens.h"
#include "paper.h"
#include "sensor.h"
#include "truth.h"

BEGIN_VISP_NAMESPACE

using namespace marker_simulator;

namespace {

// Motion between two instants of the exposure that leaves no trace next to a blur of half a pixel or more, in pixels.
constexpr double MOTION_STEP = 0.25;
// Most instants when their number is left to the simulator; 64 pixels of motion blur.
constexpr int MOST_MOTION_STEPS = 256;
// Standard deviation of a pixel's square, along either side, in pixels.
const double PIXEL_BLUR = 1. / std::sqrt(12.);
// A penumbra wider than this, in pixels, is even within the blur: it multiplies pixels. At an edge that is a third of a
// grey level off.
constexpr double WIDE_PENUMBRA = 30.;
// Background before another one is asked for: darker than paper and brighter than ink.
constexpr double PLAIN_BACKGROUND = 110.;

vpHomogeneousMatrix poseAt(const vpHomogeneousMatrix &cMo, const vpColVector &twist, double instant)
{
  return vpExponentialMap::direct(twist, -instant) * cMo;
}

// Largest distance that a sheet's corner moves in the image during the exposure, in pixels.
double motionInImage(const vpSimulatedMarker &marker, const vpColVector &twist, const Lens &lens)
{
  double motion = 0.;
  for (int corner = 0; corner < 4; ++corner) {
    const double x = (corner & 1 ? 0.5 : -0.5) * marker.getSheetWidth();
    const double y = (corner & 2 ? 0.5 : -0.5) * marker.getSheetHeight();
    const PlanePoint p = Paper(marker, poseAt(marker.getPose(), twist, -0.5)).project({x, y}, lens);
    const PlanePoint q = Paper(marker, poseAt(marker.getPose(), twist, 0.5)).project({x, y}, lens);
    motion = std::max(motion, std::hypot(p.x - q.x, p.y - q.y));
  }
  return motion;
}

int motionSteps(const vpSceneMotion &motion, const std::vector<vpSimulatedMarker> &markers, const Lens &lens)
{
  if (motion.twist.sumSquare() == 0.) {
    return 1;
  }
  if (motion.steps > 0) {
    return static_cast<int>(motion.steps);
  }
  double longest = 0.;
  for (const vpSimulatedMarker &marker : markers) {
    longest = std::max(longest, motionInImage(marker, motion.twist, lens));
  }
  return static_cast<int>(std::clamp(std::ceil(longest / MOTION_STEP), 1., static_cast<double>(MOST_MOTION_STEPS)));
}

} // namespace

/*!
  A camera that looks at an empty scene.

  \param cam : camera parameters, any of ViSP's models.
  \param width, height : size of the images, in pixels.
  \exception vpException::badValue : no pixels.
*/
vpMarkerSceneSimulator::vpMarkerSceneSimulator(const vpCameraParameters &cam, unsigned int width, unsigned int height)
    : m_cam(cam), m_width(width), m_height(height), m_background(vpSceneBackground::plain(PLAIN_BACKGROUND))
{
  if (width == 0 || height == 0) {
    throw vpException(vpException::badValue, "an image of %u by %u pixels cannot be rendered", width, height);
  }
  setPhotometry(m_photometry);
}

/*!
  Sets light, blur and sensor.
  \exception vpException::badValue : values that no camera has, or a reflection without a size.
*/
void vpMarkerSceneSimulator::setPhotometry(const vpScenePhotometry &photometry)
{
  if (photometry.reflection && !(photometry.reflection->radius > 0.)) {
    throw vpException(vpException::badValue, "a reflection with a radius of %g pixels: it must be positive",
                      photometry.reflection->radius);
  }
  if (!(photometry.noiseSigma >= 0.) || !(photometry.gamma > 0.)) {
    throw vpException(vpException::badValue,
                      "noise of %g grey levels with a gamma of %g: noise must not be negative, "
                      "gamma must be positive",
                      photometry.noiseSigma, photometry.gamma);
  }
  checkJpegQuality(photometry.jpegQuality.value_or(100));
  m_response = std::make_shared<const PixelResponse>(photometry.blurSigma, photometry.defocusRadius);
  m_photometry = photometry;
  drawBackground();
}

/*! Sets what is behind the markers. */
void vpMarkerSceneSimulator::setBackground(const vpSceneBackground &background)
{
  m_background = background;
  drawBackground();
}

/*!
  Sets the motion during the exposure.
  \exception vpException::dimensionError : the twist has not 6 elements.
*/
void vpMarkerSceneSimulator::setMotion(const vpSceneMotion &motion)
{
  if (motion.twist.size() != 6) {
    throw vpException(vpException::dimensionError, "a twist has 6 elements, translation first, not %u",
                      motion.twist.size());
  }
  m_motion = motion;
}

/*! Adds a marker in front of those already there. \return Its index. */
unsigned int vpMarkerSceneSimulator::addMarker(const vpSimulatedMarker &marker)
{
  m_markers.push_back(marker);
  return static_cast<unsigned int>(m_markers.size()) - 1;
}

/*!
  Moves a marker.
  \param index : as returned by addMarker().
  \param cMo : pose in the camera frame, z into the marker, lengths in metres.
  \exception vpException::badValue : no such marker.
*/
void vpMarkerSceneSimulator::setMarkerPose(unsigned int index, const vpHomogeneousMatrix &cMo)
{
  if (index >= m_markers.size()) {
    throw vpException(vpException::badValue, "there is no marker %u: the scene has %d", index,
                      static_cast<int>(m_markers.size()));
  }
  m_markers[index].setPose(cMo);
}

/*! Removes all markers. */
void vpMarkerSceneSimulator::clearMarkers()
{
  m_markers.clear();
}

/*! Adds an occluder, in front of all markers and of the occluders already there. */
void vpMarkerSceneSimulator::addOccluder(const vpSceneOccluder &occluder)
{
  m_occluders.push_back(occluder);
}

/*! Removes all occluders. */
void vpMarkerSceneSimulator::clearOccluders()
{
  m_occluders.clear();
}

void vpMarkerSceneSimulator::drawBackground()
{
  m_backgroundImage.resize(m_height, m_width, static_cast<float>(m_background.getGrey()));
  if (m_background.getPhoto().getSize() > 0) {
    drawPhoto(m_background.getPhoto(), m_backgroundImage);
  }
  else if (m_background.getClutterSeed()) {
    drawClutter(*m_background.getClutterSeed(), m_background.getClutterShapes(), *m_response, m_backgroundImage);
  }
}

/*!
  Renders an image.

  \param[out] I : the image, of the camera's size.
  \param seed : seed of the noise.
  \return The truth of each marker, in the order in which they were added.
  \exception vpException::badValue : a part of a marker's sheet is not in front of the camera or beyond its lens model.
*/
std::vector<vpMarkerTruth> vpMarkerSceneSimulator::render(vpImage<unsigned char> &I, std::uint64_t seed) const
{
  vpImage<float> exact;
  renderNoiseFree(exact);
  quantise(exact, m_photometry.noiseSigma, seed, I);
  if (m_photometry.jpegQuality) {
    loseToJpeg(*m_photometry.jpegQuality, I);
  }
  return getTruth();
}

/*!
  Renders the image before noise, rounding and compression.
  \param[out] I : grey levels, not clamped (but by a gamma other than 1).
  \exception vpException::badValue : as for render().
*/
void vpMarkerSceneSimulator::renderNoiseFree(vpImage<float> &I) const
{
  const Lens lens(m_cam);
  I = m_backgroundImage;
  const std::optional<vpSceneShadow> &shadow = m_photometry.shadow;
  const bool isWide = shadow && shadow->penumbra > WIDE_PENUMBRA;
  const double blur = std::hypot(m_photometry.blurSigma, PIXEL_BLUR);
  std::vector<SharpShadow> shadows;
  if (shadow && !isWide) {
    castShadow(*shadow, blur, m_photometry.defocusRadius, I);
    shadows = sharpShadows(*shadow, blur);
  }
  const int steps = motionSteps(m_motion, m_markers, lens);
  for (int step = 0; step < steps; ++step) {
    const double instant = (step + 0.5) / steps - 0.5;
    std::vector<Layer> layers;
    for (const vpSimulatedMarker &marker : m_markers) {
      const vpHomogeneousMatrix cMo = steps == 1 ? marker.getPose() : poseAt(marker.getPose(), m_motion.twist, instant);
      const double sheet = marker.isInverse() ? m_photometry.ink : m_photometry.paper;
      const double print = marker.isInverse() ? m_photometry.paper : m_photometry.ink;
      layers.push_back(layerOf(marker, cMo, lens, sheet, print));
    }
    for (const vpSceneOccluder &occluder : m_occluders) {
      layers.push_back(layerOf(occluder));
    }
    hideCoveredParts(layers);
    for (const Layer &layer : layers) {
      addLayer(layer, *m_response, m_backgroundImage, 1. / steps, shadows, I);
    }
  }
  if (isWide) {
    castShadow(*shadow, blur, m_photometry.defocusRadius, I);
  }
  illuminate(m_photometry, I);
  if (m_photometry.reflection) {
    reflect(*m_photometry.reflection, I);
  }
  applyGamma(m_photometry.gamma, I);
}

/*!
  Truth of each marker, in the order in which they were added.
  \exception vpException::badValue : as for render().
*/
std::vector<vpMarkerTruth> vpMarkerSceneSimulator::getTruth() const
{
  const Lens lens(m_cam);
  std::vector<Outline> bodies;
  for (const vpSimulatedMarker &marker : m_markers) {
    bodies.push_back(sheetImage(marker, marker.getPose(), lens));
  }
  for (const vpSceneOccluder &occluder : m_occluders) {
    bodies.push_back(layerOf(occluder).body);
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    setApart(i, bodies[i]);
  }
  const Box frame = {-0.5, -0.5, m_width - 0.5, m_height - 0.5};
  std::vector<vpMarkerTruth> truths;
  for (std::size_t i = 0; i < m_markers.size(); ++i) {
    truths.push_back(truthOf(m_markers[i], lens, {bodies.begin() + i + 1, bodies.end()}, frame));
  }
  return truths;
}

/*!
  Image, in pixels, of a point of the camera frame, in metres: the exact inverse of vpPixelMeterConversion.
  \exception vpException::badValue : the point is not in front of the camera or beyond its lens model.
*/
vpImagePoint vpMarkerSceneSimulator::project(double X, double Y, double Z) const
{
  const PlanePoint p = Lens(m_cam).project(X, Y, Z);
  return vpImagePoint(p.y, p.x);
}

END_VISP_NAMESPACE
