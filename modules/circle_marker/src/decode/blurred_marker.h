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

#include "decode/blurred_print.h"
#include "support/camera_model.h"
#include "support/deadline.h"

#include <visp3/circle_marker/vpCircleMarkerFamily.h>
#include <visp3/core/vpImage.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
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
        m_deadline(deadline), m_print(m_layout, m_sectors)
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
  BlurredFit changed(const BlurredFit &from, const Eigen::VectorXd &by, int poseSize) const;
  bool linearise(const BlurredFit &fit, int poseSize, Eigen::MatrixXd &matrix, Eigen::VectorXd &right);
  bool isOver(Eigen::Index sample) const;

  const vpImage<unsigned char> &m_image;
  const CameraModel &m_camera;
  vpCircleMarkerLayout m_layout;
  int m_sectors;
  Deadline m_deadline;
  std::vector<BlurredSample> m_samples;
  double m_block = 1.;             //!< Side of a sample, pixels.
  Eigen::Vector2d m_center;        //!< Image of the marker's centre, pixels.
  double m_extent = 1.;            //!< Unit of the light's slopes, pixels.
  Eigen::Matrix2d m_meterPerPixel; //!< There.
  BlurredPrint m_print;            //!< At the present pose and blur.
};
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
