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
 * Image of one marker as a function of its pose, of the two grey levels and of the blur.
 */

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include <visp3/core/vpException.h>

#include "../lens.h"
#include "../paper.h"
#include "marker_view.h"

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

namespace {

// Standard deviations of the blur beyond which an edge is over for this purpose (6e-5 of the contrast).
constexpr double BLUR_REACH = 4.;
// Pixels around the marker beyond the reach of the blur, which tell the level of the paper and leave the mirrored pose
// room to move.
constexpr double MARGIN = 4.;
// Least blur the simulator knows beside none, pixels^2.
constexpr double LEAST_VARIANCE = 0.05 * 0.05;
// Change of the blur's variance for a difference, as a share of it: 3 % in the standard deviation.
constexpr double VARIANCE_SHARE = 0.06;
// The same without blur, pixels^2; a one-sided difference.
constexpr double VARIANCE_STEP = 0.02;
// Largest turn for a difference, in radians: the tilt of a marker that faces the camera hardly moves its edge, but its
// image is not linear in larger turns.
constexpr double LARGEST_TURN = 0.04;
// Points of the outer edge whose motion is looked at; 0.5 % is lost between two of them.
constexpr int EDGE_POINTS = 32;
// Largest view, in pixels: more than any camera at hand.
constexpr double MOST_PIXELS = 1e8;
// Cameras kept: those of the state, of a little more and a little less blur, and of a trial state.
constexpr std::size_t CAMERAS_KEPT = 4;

std::vector<PlanePoint> edgeImage(const vpSimulatedMarker &marker, const vpHomogeneousMatrix &cMo, const Lens &lens)
{
  const Paper paper(marker, cMo);
  std::vector<PlanePoint> points;
  for (int i = 0; i < EDGE_POINTS; ++i) {
    const double angle = 2. * M_PI * i / EDGE_POINTS;
    const double x = 0.5 * marker.getSize() * std::cos(angle);
    const double y = 0.5 * marker.getHeight() * std::sin(angle);
    points.push_back(paper.project({x, y}, lens));
  }
  if (!marker.isCircle()) { // of a square the corners are farther out
    for (const double x : {-0.5, 0.5}) {
      for (const double y : {-0.5, 0.5}) {
        points.push_back(paper.project({x * marker.getSize(), y * marker.getHeight()}, lens));
      }
    }
  }
  return points;
}

vpCameraParameters shifted(const vpCameraParameters &cam, double left, double top)
{
  vpCameraParameters result = cam;
  const double u0 = cam.get_u0() - left;
  const double v0 = cam.get_v0() - top;
  switch (cam.get_projModel()) {
  case vpCameraParameters::perspectiveProjWithDistortion:
    result.initPersProjWithDistortion(cam.get_px(), cam.get_py(), u0, v0, cam.get_kud(), cam.get_kdu());
    break;
  case vpCameraParameters::ProjWithKannalaBrandtDistortion:
    result.initProjWithKannalaBrandtDistortion(cam.get_px(), cam.get_py(), u0, v0,
                                               cam.getKannalaBrandtDistortionCoefficients());
    break;
  default:
    result.initPersProjWithoutDistortion(cam.get_px(), cam.get_py(), u0, v0);
  }
  return result;
}

} // namespace

ViewMatrix informationOf(const ViewDerivatives &J, const Eigen::VectorXd &weights)
{
  ViewMatrix information = ViewMatrix::Zero();
  for (Eigen::Index i = 0; i < J.rows(); ++i) {
    const ViewStep row = J.row(i).transpose();
    information += weights[i] * row * row.transpose();
  }
  return information;
}

Eigen::Matrix3d turnAxes(const vpHomogeneousMatrix &cMo)
{
  Eigen::Matrix3d axes;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      axes(i, j) = cMo[i][j];
    }
  }
  return axes;
}

ViewState moved(const ViewState &state, const ViewStep &step, const Eigen::Matrix3d &axes)
{
  ViewState result = state;
  const Eigen::Vector3d turn = axes * step.segment<3>(TURN);
  const double angle = turn.norm();
  const Eigen::Matrix3d rotation = angle > 0. ? Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix()
                                              : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
  const Eigen::Matrix3d orientation = rotation * turnAxes(state.cMo);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      result.cMo[i][j] = orientation(i, j);
    }
    result.cMo[i][3] += step[CENTRE + i];
  }
  result.paper += step[PAPER];
  result.ink += step[INK];
  result.blurVariance = std::max(0., result.blurVariance + step[BLUR]);
  return result;
}

MarkerView::MarkerView(const vpSimulatedMarker &marker, const std::vector<vpHomogeneousMatrix> &poses,
                       const vpCameraParameters &cam, const vpScenePhotometry &photometry, double step)
    : m_marker(marker), m_photometry(photometry), m_step(step)
{
  m_photometry.paper = 1.;
  m_photometry.ink = 0.;
  const Lens lens(cam);
  Box box = {1e9, 1e9, -1e9, -1e9};
  for (const vpHomogeneousMatrix &pose : poses) {
    for (const PlanePoint &p : edgeImage(marker, pose, lens)) {
      box = {std::min(box.left, p.x), std::min(box.top, p.y), std::max(box.right, p.x), std::max(box.bottom, p.y)};
    }
  }
  const double reach = std::ceil(0.5 + BLUR_REACH * photometry.blurSigma + photometry.defocusRadius) + MARGIN;
  const double left = std::floor(box.left - reach);
  const double top = std::floor(box.top - reach);
  const double width = std::ceil(box.right + reach) - left + 1.;
  const double height = std::ceil(box.bottom + reach) - top + 1.;
  if (!(width * height <= MOST_PIXELS)) {
    throw vpException(vpException::badValue, "the marker's image has %g by %g pixels: move it away from the camera",
                      width, height);
  }
  m_width = static_cast<unsigned int>(width);
  m_height = static_cast<unsigned int>(height);
  m_cam = shifted(cam, left, top);
}

vpMarkerSceneSimulator &MarkerView::cameraOf(double blurVariance) const
{
  const auto place = std::find_if(m_cameras.begin(), m_cameras.end(), [blurVariance](const BlurredCamera &candidate) {
    return candidate.blurVariance == blurVariance;
  });
  if (place != m_cameras.end()) {
    return *place->camera;
  }
  vpScenePhotometry photometry = m_photometry;
  photometry.blurSigma = blurVariance < LEAST_VARIANCE ? 0. : std::sqrt(blurVariance);
  auto camera = std::make_unique<vpMarkerSceneSimulator>(m_cam, m_width, m_height);
  camera->setPhotometry(photometry);
  // The sheet goes on, so that its end says nothing of the pose: that of an inverse marker is black.
  camera->setBackground(vpSceneBackground::plain(m_marker.isInverse() ? photometry.ink : photometry.paper));
  camera->addMarker(m_marker);
  if (m_cameras.size() == CAMERAS_KEPT) {
    m_cameras.erase(m_cameras.begin());
  }
  m_cameras.push_back({blurVariance, std::move(camera)});
  return *m_cameras.back().camera;
}

// 1 where there is paper, 0 where there is ink.
Eigen::VectorXd MarkerView::whiteness(const ViewState &state) const
{
  vpMarkerSceneSimulator &camera = cameraOf(state.blurVariance);
  camera.setMarkerPose(0, state.cMo);
  vpImage<float> I;
  camera.renderNoiseFree(I);
  return Eigen::Map<const Eigen::VectorXf>(I.bitmap, I.getSize()).cast<double>();
}

Eigen::VectorXd MarkerView::image(const ViewState &state) const
{
  return state.ink + (state.paper - state.ink) * whiteness(state).array();
}

Eigen::VectorXd MarkerView::shareBeyondSheet(const ViewState &state) const
{
  // A sheet without print: paper and ink are both 0, and what is behind it is 1.
  vpScenePhotometry photometry = m_photometry;
  photometry.paper = 0.;
  photometry.ink = 0.;
  photometry.blurSigma = std::sqrt(state.blurVariance);
  vpMarkerSceneSimulator camera(m_cam, m_width, m_height);
  camera.setPhotometry(photometry);
  camera.setBackground(vpSceneBackground::plain(1.));
  camera.addMarker(vpSimulatedMarker(m_marker).setPose(state.cMo));
  vpImage<float> I;
  camera.renderNoiseFree(I);
  return Eigen::Map<const Eigen::VectorXf>(I.bitmap, I.getSize()).cast<double>();
}

double MarkerView::motionOfEdge(const vpHomogeneousMatrix &from, const vpHomogeneousMatrix &to) const
{
  const Lens lens(m_cam);
  const std::vector<PlanePoint> before = edgeImage(m_marker, from, lens);
  const std::vector<PlanePoint> after = edgeImage(m_marker, to, lens);
  double motion = 0.;
  for (std::size_t i = 0; i < before.size(); ++i) {
    motion = std::max(motion, std::hypot(after[i].x - before[i].x, after[i].y - before[i].y));
  }
  return motion;
}

// The motion is not in proportion to the step for the tilt of a marker that faces the camera, which shortens the image
// in the second order only; so the step is searched for.
double MarkerView::stepOf(const ViewState &state, const Eigen::Matrix3d &axes, int parameter) const
{
  const auto motion = [&](double size) {
    ViewStep step = ViewStep::Zero();
    step[parameter] = size;
    return std::max(motionOfEdge(state.cMo, moved(state, step, axes).cMo),
                    motionOfEdge(state.cMo, moved(state, -step, axes).cMo));
  };
  double size = 1e-6; // metres or radians: below any step that is needed
  while (motion(2. * size) < m_step && (parameter < TURN || size < LARGEST_TURN)) {
    size *= 2.;
  }
  double above = 2. * size;
  for (int i = 0; i < 8; ++i) {
    const double middle = 0.5 * (size + above);
    (motion(middle) < m_step ? size : above) = middle;
  }
  return parameter < TURN ? size : std::min(size, LARGEST_TURN);
}

ViewDerivatives MarkerView::derivatives(const ViewState &state, const Eigen::Matrix3d &axes,
                                        const FreeParameters &free) const
{
  ViewDerivatives J = ViewDerivatives::Zero(size(), VIEW_PARAMETERS);
  for (int k = CENTRE; k <= SPIN; ++k) {
    if (free[k]) {
      ViewStep step = ViewStep::Zero();
      step[k] = stepOf(state, axes, k);
      J.col(k) = (image(moved(state, step, axes)) - image(moved(state, -step, axes))) / (2. * step[k]);
    }
  }
  // The image is linear in the levels: ink + (paper - ink) * whiteness.
  J.col(PAPER) = whiteness(state);
  J.col(INK) = 1. - J.col(PAPER).array();
  if (free[BLUR]) {
    ViewState wider = state;
    ViewState narrower = state;
    const bool isBlurred = (1. - VARIANCE_SHARE) * state.blurVariance >= LEAST_VARIANCE;
    const double change = isBlurred ? VARIANCE_SHARE * state.blurVariance : VARIANCE_STEP;
    wider.blurVariance += change;
    narrower.blurVariance -= isBlurred ? change : 0.;
    J.col(BLUR) = (image(wider) - image(narrower)) / (wider.blurVariance - narrower.blurVariance);
  }
  return J;
}

} // namespace marker_simulator
END_VISP_NAMESPACE
