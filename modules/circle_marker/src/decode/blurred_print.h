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
 * The print of a marker as it is seen through a blur.
 */

/*!
  \file blurred_print.h
  \brief How much a place of the image sees of each part of a print, through a blur of any size.

  The blur is a sum over points, a line of them for a motion, a disc for a defocus, each of them blurred as by any lens.
  That last blur makes a ramp of an edge. A place sees the ring and each sector by a share; the grey level is linear in
  their darknesses. As pose and blur change, each point q of the print moves, by the twist \f$ (\upsilon, \omega) \f$ of
  the pose in the marker's frame (image_model.h) by
  \f[ \dot q = (\upsilon_z + \omega_x q_y - \omega_y q_x) \, s - \upsilon_{xy} + \omega_z (q_y, -q_x)^T, \f]
  and with it what is seen there; and as the print turns and comes nearer, the ramps on it become wider or narrower.
*/

#ifndef VP_CIRCLE_MARKER_BLURRED_PRINT_H
#define VP_CIRCLE_MARKER_BLURRED_PRINT_H

#include <array>
#include <vector>

#include <Eigen/Core>

#include "decode/code_track.h"
#include "pose/marker_plane.h"

#include <visp3/circle_marker/vpCircleMarkerFamily.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*! What blurs a picture, beyond what every lens does. */
struct ImageBlur
{
  Eigen::Vector2d motion = Eigen::Vector2d::Zero(); //!< Way of the image during the exposure, pixels.
  double disc = 0.;                                 //!< Radius of the image of a point out of focus, pixels.
};

/*! A number for each part of a print: the share that a place of the image sees, or a darkness, grey levels. */
struct PrintParts
{
  double ring;                            //!< Of the ring.
  std::array<double, mostSectors> sector; //!< Of each sector of the code.
};

/*! Derivatives of the darkness of a place of the image. */
struct DarknessSlopes
{
  Eigen::Matrix<double, 6, 1> byTwist = Eigen::Matrix<double, 6, 1>::Zero(); //!< Three in radii, three in rad.
  Eigen::Vector2d byMotion = Eigen::Vector2d::Zero();                        //!< 1 / pixel.
  double byDisc = 0.;                                                        //!< 1 / pixel.
};

/*! A print at a pose, through a blur. */
class BlurredPrint
{
public:
  BlurredPrint(const vpCircleMarkerLayout &layout, int sectors) : m_layout(layout), m_sectors(sectors) {}

  /*! Radius of the disc, and length of the way, below which there is none, pixels. */
  static constexpr double leastKernel = 0.3;

  /*!
    Sets pose and blur.
    \param plane, blur : These.
    \param meterPerPixel : Derivative of normalised coordinates by the pixel at the marker.
    \param block : Side of what a place stands for, pixels.
  */
  void set(const MarkerPlane &plane, const ImageBlur &blur, const Eigen::Matrix2d &meterPerPixel, double block);

  /*! Whether all that a place sees, in normalised coordinates, lies within a radius on the marker's plane. */
  bool isWithin(const Eigen::Vector2d &meter, double radius) const;

  /*! What a place sees. */
  void see(const Eigen::Vector2d &meter, PrintParts &shares) const;

  /*! How the darkness of a place changes with pose and blur. */
  DarknessSlopes slopesAt(const Eigen::Vector2d &meter, const PrintParts &darkness) const;

private:
  // One point of the blur, on the print.
  struct Spot
  {
    double x, y, r;     // there
    double perWidth;    // width of a ramp across the radius, its inverse
    double outer, edge; // signed distances from the ring's circles, positive inside, in widths
    double rim, hub;    // and from the track's
    double track;       // share of the track
    // Where that is not 0: its sector, the shares of that which the neighbours have, the place within it and the width
    // of a ramp, in sectors.
    int sector;
    double before, after, inside, angular;
  };
  // Derivatives of the darkness that a spot sees.
  struct SpotSlopes
  {
    bool isFlat() const { return byRadius == 0. && byAngle == 0. && byWidth == 0. && byAngularWidth == 0.; }

    double byRadius = 0.;
    double byAngle = 0.;
    double byWidth = 0.;        // by the logarithm of the width of ramps across the radius
    double byAngularWidth = 0.; // and of those along it
  };
  using Velocities = Eigen::Matrix<double, 2, 6>;

  SpotSlopes slopesOf(const Spot &spot, const PrintParts &darkness) const;
  Velocities velocitiesAt(const Eigen::Vector2d &q) const;
  Velocities strainsAt(const Eigen::Vector2d &q, const Eigen::Vector2d &d) const;
  Spot spotAt(double x, double y, const Eigen::Matrix2d &metric) const;
  Eigen::Matrix2d byPixelAt(const Eigen::Vector3d &h) const;
  Eigen::Matrix2d metricOf(const Eigen::Matrix2d &byPixel) const;
  int before(int sector) const { return (sector + m_sectors - 1) % m_sectors; }
  int after(int sector) const { return (sector + 1) % m_sectors; }

  vpCircleMarkerLayout m_layout;
  int m_sectors;
  Eigen::Matrix2d m_meterPerPixel = Eigen::Matrix2d::Identity();
  Eigen::Matrix3d m_toPlane = Eigen::Matrix3d::Identity(); //!< From normalised coordinates to the plane.
  Eigen::Vector3d m_eye = -Eigen::Vector3d::UnitZ();       //!< The camera's centre in the marker's frame, radii.
  std::vector<Eigen::Vector2d> m_byBlur; //!< Derivatives of the blur's points by the motion or the disc's radius.
  std::vector<Eigen::Vector3d> m_steps;  //!< The ways to them in homogeneous coordinates of the plane.
  bool m_isDisc = false;                 //!< Whether it is a disc.
  double m_sigma = 0.85;                 //!< Blur about each of them, pixels.
  Eigen::Vector2d m_sigmaByBlur = Eigen::Vector2d::Zero(); //!< Derivative of its logarithm by motion or disc.
};
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
