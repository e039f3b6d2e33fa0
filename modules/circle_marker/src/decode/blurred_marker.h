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
 * A coded marker seen through a strong blur: its pose, the blur and its code together.
 */

#ifndef VP_CIRCLE_MARKER_BLURRED_MARKER_H
#define VP_CIRCLE_MARKER_BLURRED_MARKER_H

#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "decode/code_track.h"
#include "pose/marker_plane.h"
#include "support/camera_model.h"
#include "support/deadline.h"

#include <visp3/circle_marker/vpCircleMarkerFamily.h>
#include <visp3/core/vpImage.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! What blurs a picture, beyond what every lens does. */
struct ImageBlur
{
  Eigen::Vector2d motion = Eigen::Vector2d::Zero(); //!< Way of the image during the exposure, pixels.
  double disc = 0.;                                 //!< Radius of the image of a point out of focus, pixels.
};

/*! A pixel, or the mean of a few, of a blurred marker. */
struct BlurredSample
{
  Eigen::Vector2d pixel; //!< Its place.
  Eigen::Vector2d meter; //!< The same in normalised coordinates.
  double grey = 0.;      //!< Grey level.
};

/*! What a marker's image through a blur is made of: light, ring and sectors, as far as they are linear. */
struct BlurredFit
{
  static constexpr int lightSize = 3;            //!< White at the centre, and its slopes.
  static constexpr int ringAt = lightSize;       //!< The ring's darkness.
  static constexpr int firstSector = ringAt + 1; //!< The sectors' darkness.

  MarkerPlane plane;
  ImageBlur blur;
  Eigen::VectorXd linear;    //!< Grey levels of light, ring, sectors.
  Eigen::MatrixXd matrix;    //!< Of the normal equations of these, without the prior.
  Eigen::VectorXd right;     //!< And their right side.
  double total = 0.;         //!< Sum of the squared grey levels.
  double squares = HUGE_VAL; //!< What is left of it, sum over the samples.
  double plain = 0.;         //!< What light alone would leave.
  std::size_t samples = 0;   //!< Their number.

  /*! Share of the variance that the marker leaves unexplained. */
  double unexplained() const { return squares / plain; }
};

/*!
  Model of a marker through a blur of any size: each sample is the mean of the print over the points that the blur
  smears into it (a line of them for a motion, a disc for a defocus). Given pose and blur, the grey levels of light,
  ring and sectors are linear; pose and blur are found by Levenberg and Marquardt's method with these eliminated in each
  step (G. Golub and V. Pereyra, variable projection, SIAM J. Numer. Anal. 10 (1973)).
*/
class BlurredMarker
{
public:
  BlurredMarker(const vpImage<unsigned char> &I, const CameraModel &camera, const vpCircleMarkerFamily &family,
                const Deadline &deadline = Deadline())
      : m_image(I), m_camera(camera), m_layout(family.getLayout()), m_sectors(static_cast<int>(family.getNbSectors())),
        m_deadline(deadline)
  {
  }

  /*! Chooses samples, about so many, that see nothing beyond the quiet zone at this pose and blur; fewer after the
    deadline. */
  void select(const MarkerPlane &plane, const ImageBlur &blur, std::size_t count);

  std::size_t size() const { return m_samples.size(); }

  /*! The linear part at a pose and blur. After the deadline nothing fits: the squares are HUGE_VAL. */
  void solve(BlurredFit &fit);

  /*! Steps of the nonlinear part, as many as the deadline allows. */
  void improve(BlurredFit &fit, int steps, bool movesSpin);

  /*! How many samples' information counts once. */
  double coherence() const;

  /*! Covariance of the twist (t, w) of the pose in the marker's frame: outer radii, rad; of a family without sectors
    the spin has none. After the deadline any. */
  Eigen::Matrix<double, 6, 6> covariance(const BlurredFit &fit);

private:
  struct Point
  {
    double ring;
    std::array<double, mostSectors> sector;
  };
  void setPose(const MarkerPlane &plane, const ImageBlur &blur);
  void see(const BlurredSample &sample, Point &point) const;
  BlurredFit changed(const BlurredFit &from, const Eigen::VectorXd &by, int poseSize) const;
  bool linearise(const BlurredFit &fit, int poseSize, Eigen::MatrixXd &matrix, Eigen::VectorXd &right);
  bool isOver(Eigen::Index sample) const;
  double darkness(const BlurredSample &sample, const Eigen::VectorXd &linear) const;

  const vpImage<unsigned char> &m_image;
  const CameraModel &m_camera;
  vpCircleMarkerLayout m_layout;
  int m_sectors;
  Deadline m_deadline;
  std::vector<BlurredSample> m_samples;
  double m_block = 1.;                   //!< Side of a sample, pixels.
  Eigen::Vector2d m_center;              //!< Image of the marker's centre, pixels.
  double m_extent = 1.;                  //!< Unit of the light's slopes, pixels.
  Eigen::Matrix2d m_meterPerPixel;       //!< There.
  Eigen::Matrix3d m_toPlane;             //!< From normalised coordinates to the plane at the present pose.
  std::vector<Eigen::Vector2d> m_kernel; //!< Points that the blur smears together, normalised coordinates.
  std::vector<Eigen::Vector3d> m_steps;  //!< The ways to them in homogeneous coordinates of the plane.
  double m_sigma = 0.85;                 //!< Blur about each of them, pixels.
};
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
