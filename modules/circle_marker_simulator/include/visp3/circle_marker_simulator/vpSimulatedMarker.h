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
 * A printed marker in a simulated scene.
 */

/*!
  \file vpSimulatedMarker.h
  \brief A printed marker in a simulated scene.
*/

#ifndef VP_SIMULATED_MARKER_H
#define VP_SIMULATED_MARKER_H

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <visp3/core/vpHomogeneousMatrix.h>
#include <visp3/core/vpImage.h>

#include <visp3/circle_marker_simulator/vpConfigCircleMarkerSimulator.h>

BEGIN_VISP_NAMESPACE

/*!
  \class vpSimulatedMarker
  \ingroup group_circle_marker_simulator
  \brief A printed marker: a circular marker, an AprilTag or any picture, on a white sheet, flat unless bent by
  setBow().

  The marker frame has its origin in the marker's centre and, seen upright from the front, x to the right, y down and
  z into the marker, away from the camera: a frontal upright marker has the identity as rotation. Lengths in metres.

  This class states the markers' geometry and codes a second time, on its own, so that a mistake in the detector's
  own statement cannot hide.
*/
class VISP_EXPORT vpSimulatedMarker
{
public:
  static vpSimulatedMarker circle(const std::string &family, int id, double size);
  static vpSimulatedMarker ring(double size, double ratio);
  static vpSimulatedMarker disc(double size);
  static vpSimulatedMarker rings(const std::vector<std::array<double, 2>> &radii, double size);
  static vpSimulatedMarker aprilTag36h11(int id, double size);
  static vpSimulatedMarker bitmap(const vpImage<unsigned char> &picture, double width, double height);
  static std::vector<std::uint32_t> codewords(const std::string &family);
  static unsigned int sectors(const std::string &family);

  vpSimulatedMarker &setPose(const vpHomogeneousMatrix &cMo);
  vpSimulatedMarker &setQuietZone(double quietZone);
  vpSimulatedMarker &setSheetSide(double side);
  vpSimulatedMarker &setInkSpread(double spread);
  vpSimulatedMarker &setLayout(double ringRatio, double trackInner, double trackOuter);
  vpSimulatedMarker &setTrack(double inner, double outer, unsigned int sectors, std::uint32_t word,
                              bool isWindows = false);
  vpSimulatedMarker &setInverse(bool inverse);
  vpSimulatedMarker &setBow(double bow, double axis = 0.);

  /*! Pose of the marker in the camera frame, lengths in metres. */
  const vpHomogeneousMatrix &getPose() const { return m_cMo; }
  /*! Family: "golay23", "bch31", "bch31r", "ring", "disc", "rings", "36h11" or "bitmap". */
  const std::string &getFamily() const { return m_family; }
  /*! Number within the family, -1 for a family without numbers. */
  int getId() const { return m_id; }
  /*! Outer diameter of the ring, side of the tag's black square or width of the picture, in metres. */
  double getSize() const { return m_size; }
  /*! Height of the picture, in metres; the same as getSize() but for a bitmap. */
  double getHeight() const { return m_height; }
  /*! True for the circular families. */
  bool isCircle() const { return m_picture.getSize() == 0; }
  /*! Inner radius of the ring over its outer radius; 0 for a disc. */
  double getRingRatio() const { return m_ringRatio; }
  /*! Inner radius of the code track over the ring's outer radius. */
  double getTrackInner() const { return m_trackInner; }
  /*! Outer radius of the code track over the ring's outer radius. */
  double getTrackOuter() const { return m_trackOuter; }
  /*! Black rings besides that of the ring ratio: inner and outer radius over half the size. */
  const std::vector<std::array<double, 2>> &getRings() const { return m_rings; }
  /*! Whether the code's ones are white windows in a black ring, not black sectors on white paper. */
  bool hasWindows() const { return m_hasWindows; }
  /*! Width of the white sheet, in metres. */
  double getSheetWidth() const { return m_sheetWidth; }
  /*! Height of the white sheet, in metres. */
  double getSheetHeight() const { return m_sheetHeight; }
  /*! Distance by which every black edge has moved outward, in metres. */
  double getInkSpread() const { return m_inkSpread; }
  /*! Whether ink and paper have changed places. */
  bool isInverse() const { return m_isInverse; }
  /*! Height of the arc into which the sheet is bent, in metres: see setBow(). */
  double getBow() const { return m_bow; }
  /*! Direction of the axis about which the sheet is bent, in radians from +x toward +y of the marker frame. */
  double getBowAxis() const { return m_bowAxis; }
  /*! Codeword of the marker, sector 0 its most significant bit; empty for a family without a code. */
  const std::optional<std::uint32_t> &getCodeword() const { return m_codeword; }
  /*! Number of sectors of the code track. */
  unsigned int getNbSectors() const { return m_sectors; }
  /*! Picture to be printed from edge to edge, 0 ink and 255 paper; of size 0 for a circular marker. */
  const vpImage<unsigned char> &getPicture() const { return m_picture; }

private:
  vpSimulatedMarker(const std::string &family, int id, double width, double height);

  std::string m_family;                       //!< Name of the family.
  int m_id;                                   //!< Number in the family, -1 without.
  double m_size;                              //!< Diameter, side or width, in metres.
  double m_height;                            //!< Height, in metres.
  double m_sheetWidth;                        //!< Width of the white sheet, in metres.
  double m_sheetHeight;                       //!< Height of the white sheet, in metres.
  double m_ringRatio = 0.;                    //!< Inner over outer radius of the ring.
  double m_trackInner = 0.40;                 //!< Inner radius of the code track over the outer radius of the ring.
  double m_trackOuter = 0.68;                 //!< Outer radius of the code track over the outer radius of the ring.
  std::vector<std::array<double, 2>> m_rings; //!< Further rings, over half the size.
  bool m_hasWindows = false;                  //!< Whether ones of the code are white.
  bool m_isInverse = false;                   //!< Whether it is white on black.
  double m_inkSpread = 0.;                    //!< Outward displacement of black edges, in metres.
  double m_bow = 0.;                          //!< Height of the sheet's arc, in metres.
  double m_bowAxis = 0.;                      //!< Axis of the bend, in radians.
  unsigned int m_sectors = 0;                 //!< Number of sectors of the code track.
  std::optional<std::uint32_t> m_codeword;    //!< Codeword, where there is one.
  vpImage<unsigned char> m_picture;           //!< Picture of a tag or bitmap.
  vpHomogeneousMatrix m_cMo;                  //!< Pose in the camera frame.
};

END_VISP_NAMESPACE

#endif
