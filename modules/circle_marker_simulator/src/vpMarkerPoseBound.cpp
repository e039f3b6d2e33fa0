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
 * Least error of a marker's pose that the noise of an image allows.
 */

#include <cmath>

#include <Eigen/Dense>

#include <visp3/core/vpException.h>

#include <visp3/circle_marker_simulator/vpMarkerPoseBound.h>

#include "bound/marker_view.h"
#include "bound/mirror_fit.h"
#include "paper.h"

BEGIN_VISP_NAMESPACE

using namespace marker_simulator;

namespace {

// Standard deviation of an evenly distributed grey level: 256 / sqrt(12).
constexpr double ANY_GREY = 73.9;
// Variance of an angle that may be anything from -pi to pi.
constexpr double ANY_ANGLE = M_PI * M_PI / 3.;

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

vpMatrix toViSP(const Matrix6d &M)
{
  vpMatrix result(6, 6);
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      result[i][j] = M(i, j);
    }
  }
  return result;
}

Eigen::Matrix3d skew(const Eigen::Vector3d &v)
{
  Eigen::Matrix3d S;
  S << 0., -v[2], v[1], v[2], 0., -v[0], -v[1], v[0], 0.;
  return S;
}

// From errors of the centre and turns about the centre along `axes` to delta = (upsilon, omega): a point p moves by
// upsilon + omega x p, so that upsilon = centre's motion - omega x centre = centre's motion + [centre]x omega.
Matrix6d toTwist(const vpHomogeneousMatrix &cMo, const Eigen::Matrix3d &axes)
{
  Matrix6d A = Matrix6d::Identity();
  A.topRightCorner<3, 3>() = skew(Eigen::Vector3d(cMo[0][3], cMo[1][3], cMo[2][3])) * axes;
  A.bottomRightCorner<3, 3>() = axes;
  return A;
}

// Inverse of a symmetric positive matrix whose rows differ in unit and size; nothing if it is singular.
Eigen::MatrixXd inverseOf(const Eigen::MatrixXd &M)
{
  const Eigen::VectorXd scale = M.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * M * scale.asDiagonal();
  const Eigen::LDLT<Eigen::MatrixXd> solver(scaled);
  const Eigen::MatrixXd inverse = solver.solve(Eigen::MatrixXd::Identity(M.rows(), M.cols()));
  return scale.asDiagonal() * inverse * scale.asDiagonal();
}

// Information of the pose when the nuisances are unknown (Schur complement); the spin is left out without a code.
Eigen::MatrixXd poseInformation(const ViewDerivatives &J, const Eigen::VectorXd &weights, int dof)
{
  const Eigen::MatrixXd all = informationOf(J, weights);
  const auto pose = all.topLeftCorner(dof, dof);
  const auto mixed = all.block(0, PAPER, dof, VIEW_PARAMETERS - PAPER);
  const Eigen::MatrixXd nuisance = all.bottomRightCorner(VIEW_PARAMETERS - PAPER, VIEW_PARAMETERS - PAPER);
  return pose - mixed * inverseOf(nuisance) * mixed.transpose();
}

void checkPhotometry(const vpScenePhotometry &photometry)
{
  if (!(photometry.noiseSigma > 0.) || !(photometry.paper > photometry.ink)) {
    throw vpException(
        vpException::badValue,
        "a noise of %g grey levels, paper of %g and ink of %g: there is a bound only with noise, and with "
        "paper brighter than ink",
        photometry.noiseSigma, photometry.paper, photometry.ink);
  }
  if (photometry.gamma != 1. || photometry.gradientU != 0. || photometry.gradientV != 0. || photometry.shadow ||
      photometry.reflection || photometry.jpegQuality) {
    throw vpException(vpException::badValue, "the bound's model has no gamma, light gradient, shadow, reflection or "
                                             "JPEG loss: leave them at their defaults");
  }
}

void checkView(const vpSimulatedMarker &marker)
{
  if (!Paper(marker, marker.getPose()).showsItsFace()) {
    throw vpException(vpException::badValue, "the marker shows its back: there is nothing to be measured");
  }
}

ViewState stateOf(const vpSimulatedMarker &marker, const vpScenePhotometry &photometry)
{
  return {marker.getPose(), photometry.paper, photometry.ink, photometry.blurSigma * photometry.blurSigma};
}

Eigen::VectorXd weightsOf(const MarkerView &view, const ViewState &state, double noise,
                          vpMarkerPoseBound::Surround surround)
{
  Eigen::ArrayXd variance = Eigen::ArrayXd::Constant(view.size(), noise * noise);
  if (surround == vpMarkerPoseBound::UNKNOWN_SURROUND) {
    variance += (ANY_GREY * view.shareBeyondSheet(state)).array().square();
  }
  return variance.inverse();
}

// Degrees of freedom: a circular marker without a code looks the same at any spin.
unsigned int dofOf(const vpSimulatedMarker &marker)
{
  return marker.isCircle() && !marker.getCodeword() ? 5 : 6;
}

FreeParameters allFree(bool hasSpin)
{
  FreeParameters free;
  free.fill(true);
  free[SPIN] = hasSpin;
  return free;
}

} // namespace

/*!
  \param cam : camera parameters, any of ViSP's models; taken for exact.
  \param photometry : paper, ink, Gaussian blur, defocus disc (known) and noise. Rounding to 8 bits, which is not
  modelled, is as good as an additional variance of 1/12 for a noise of half a grey level and more.
  \exception vpException::badValue : no noise, no contrast, or effects that the model has not (gamma, gradient, shadow,
  reflection, JPEG).
*/
vpMarkerPoseBound::vpMarkerPoseBound(const vpCameraParameters &cam, const vpScenePhotometry &photometry)
    : m_cam(cam), m_photometry(photometry)
{
  checkPhotometry(photometry);
}

/*! Sets what is known of the scene around the marker; WHITE_SURROUND unless set. */
void vpMarkerPoseBound::setSurround(Surround surround)
{
  m_surround = surround;
}

/*!
  Sets how far a difference moves the marker's outer edge at most, in pixels; 0.05 unless set.
  \exception vpException::badValue : not between 1e-3, where the image's rounding shows, and 0.5.
*/
void vpMarkerPoseBound::setStep(double step)
{
  if (!(step >= 1e-3 && step <= 0.5)) {
    throw vpException(vpException::badValue, "a step of %g pixels is too small or too large: from 0.001 to 0.5", step);
  }
  m_step = step;
}

/*!
  Cramer-Rao bound of a marker's pose.

  \param marker : the marker at its pose (z into the marker, metres), with its sheet, which matters with
  UNKNOWN_SURROUND only. The whole marker is taken to be in the image.
  \exception vpException::badValue : the marker cannot be seen.
*/
vpPoseBound vpMarkerPoseBound::bound(const vpSimulatedMarker &marker) const
{
  checkView(marker);
  const vpHomogeneousMatrix &cMo = marker.getPose();
  const MarkerView view(marker, {cMo}, m_cam, m_photometry, m_step);
  const ViewState state = stateOf(marker, m_photometry);
  const Eigen::Matrix3d axes = turnAxes(cMo);
  vpPoseBound result;
  result.dof = dofOf(marker);
  const int dof = static_cast<int>(result.dof);
  const ViewDerivatives J = view.derivatives(state, axes, allFree(result.dof == 6));
  const Eigen::VectorXd weights = weightsOf(view, state, m_photometry.noiseSigma, m_surround);
  const Eigen::MatrixXd information = poseInformation(J, weights, dof);
  Matrix6d covariance = Matrix6d::Zero();
  covariance(SPIN, SPIN) = ANY_ANGLE;
  covariance.topLeftCorner(dof, dof) = inverseOf(information);
  const Matrix6d A = toTwist(cMo, axes);
  const Matrix6d back = A.inverse();
  Matrix6d padded = Matrix6d::Zero();
  padded.topLeftCorner(dof, dof) = information;
  result.information = toViSP(back.transpose() * padded * back);
  result.covariance = toViSP(A * covariance * A.transpose());
  result.x = std::sqrt(covariance(0, 0));
  result.y = std::sqrt(covariance(1, 1));
  result.z = std::sqrt(covariance(2, 2));
  result.normal = std::sqrt(covariance(TURN, TURN) + covariance(TURN + 1, TURN + 1));
  result.spin = std::sqrt(covariance(SPIN, SPIN));
  return result;
}

/*!
  How well the pose can be told from the mirrored one, whose normal is about the normal reflected about the line of
  sight. The mirrored pose, the levels and the blur that go with it are fitted by Gauss-Newton; some ten times the work
  of bound().

  \param marker : as for bound().
  \exception vpException::badValue : the marker cannot be seen.
*/
vpPoseSeparation vpMarkerPoseBound::separation(const vpSimulatedMarker &marker) const
{
  checkView(marker);
  const ViewState state = stateOf(marker, m_photometry);
  const vpHomogeneousMatrix mirror = mirrored(marker.getPose());
  const MarkerView view(marker, {marker.getPose(), mirror}, m_cam, m_photometry, m_step);
  const Eigen::VectorXd weights = weightsOf(view, state, m_photometry.noiseSigma, m_surround);
  const MirrorFit fit = fitMirror(view, weights, state, dofOf(marker) == 6);

  vpPoseSeparation result;
  result.separation = fit.distance;
  result.wrongChoice = 0.5 * std::erfc(0.5 * fit.distance / M_SQRT2);
  result.mirror = fit.state.cMo;
  result.isDistinct = fit.isDistinct;
  return result;
}

END_VISP_NAMESPACE
