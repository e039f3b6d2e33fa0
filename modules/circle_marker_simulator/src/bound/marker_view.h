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

#ifndef VP_SIMULATOR_MARKER_VIEW_H
#define VP_SIMULATOR_MARKER_VIEW_H

#include <array>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include <visp3/circle_marker_simulator/vpMarkerPoseBound.h>
#include <visp3/circle_marker_simulator/vpMarkerSceneSimulator.h>

BEGIN_VISP_NAMESPACE
namespace marker_simulator {

//! What the image depends on.
struct ViewState
{
  vpHomogeneousMatrix cMo; //!< Pose, z into the marker, metres.
  double paper;            //!< Grey level.
  double ink;              //!< Grey level.
  double blurVariance;     //!< Square of the Gaussian's standard deviation, pixels^2.
};

/*!
  The parameters of a view, in the order of the columns of MarkerView::derivatives():
  the centre along the camera's axes (metres), the turn about the marker's own centre along the columns of `axes`
  (radians: two axes across the normal, then the normal), paper, ink, blur variance.
*/
constexpr int CENTRE = 0;
constexpr int TURN = 3;
constexpr int SPIN = 5;
constexpr int PAPER = 6;
constexpr int INK = 7;
constexpr int BLUR = 8;
constexpr int VIEW_PARAMETERS = 9;

//! One value for each parameter.
using ViewStep = Eigen::Matrix<double, VIEW_PARAMETERS, 1>;
//! Which parameters are to be changed.
using FreeParameters = std::array<bool, VIEW_PARAMETERS>;

//! One row for each pixel.
using ViewDerivatives = Eigen::Matrix<double, Eigen::Dynamic, VIEW_PARAMETERS, Eigen::RowMajor>;
using ViewMatrix = Eigen::Matrix<double, VIEW_PARAMETERS, VIEW_PARAMETERS>;

/*!
  J^T W J. Row by row: Eigen's product of large matrices would start threads of its own, which here only get into one
  another's way.
*/
ViewMatrix informationOf(const ViewDerivatives &J, const Eigen::VectorXd &weights);

//! Two axes across the marker's normal, and the normal, as columns, in the camera frame.
Eigen::Matrix3d turnAxes(const vpHomogeneousMatrix &cMo);

//! The state changed by a step in all parameters; `axes` are those of the turn.
ViewState moved(const ViewState &state, const ViewStep &step, const Eigen::Matrix3d &axes);

/*!
  The part of the image around a marker, before noise, as a vector of pixels. The paper goes on without end: the edge of
  the sheet is not to be seen. Not to be used by two threads at once.
*/
class MarkerView
{
public:
  /*!
    \param marker, cam, photometry : what is seen, by which camera, in which light.
    \param poses : the view holds the marker and all that blurs into its edges at these poses, and a little more.
    \param step : greatest motion of the marker's outer edge for a difference, in pixels.
    \exception vpException::badValue : the marker is too large in the image, or cannot be seen.
  */
  MarkerView(const vpSimulatedMarker &marker, const std::vector<vpHomogeneousMatrix> &poses,
             const vpCameraParameters &cam, const vpScenePhotometry &photometry, double step);

  //! Number of pixels.
  Eigen::Index size() const { return static_cast<Eigen::Index>(m_width) * m_height; }

  Eigen::VectorXd image(const ViewState &state) const;

  //! Derivatives of the pixels by the free parameters, by differences, 0 for the others; one row for each pixel.
  ViewDerivatives derivatives(const ViewState &state, const Eigen::Matrix3d &axes, const FreeParameters &free) const;

  //! Share of what each pixel sees that lies beyond the sheet.
  Eigen::VectorXd shareBeyondSheet(const ViewState &state) const;

private:
  double stepOf(const ViewState &state, const Eigen::Matrix3d &axes, int parameter) const;
  double motionOfEdge(const vpHomogeneousMatrix &from, const vpHomogeneousMatrix &to) const;
  Eigen::VectorXd whiteness(const ViewState &state) const;
  vpMarkerSceneSimulator &cameraOf(double blurVariance) const;

  //! A simulated camera of one blur; to make another one costs more than a small image.
  struct BlurredCamera
  {
    double blurVariance;
    std::unique_ptr<vpMarkerSceneSimulator> camera;
  };

  vpSimulatedMarker m_marker;     //!< The marker.
  vpCameraParameters m_cam;       //!< The camera, its principal point counted from the view's first pixel.
  vpScenePhotometry m_photometry; //!< Paper of level 1 and ink of level 0; blur other than the Gaussian.
  double m_step;                  //!< Greatest motion of the outer edge, in pixels.
  unsigned int m_width = 0;       //!< Pixels.
  unsigned int m_height = 0;      //!< Pixels.
  mutable std::vector<BlurredCamera> m_cameras; //!< Those used last.
};

} // namespace marker_simulator
END_VISP_NAMESPACE

#endif
