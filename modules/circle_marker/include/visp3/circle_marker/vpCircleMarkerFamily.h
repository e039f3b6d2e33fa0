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
 * Families of circular markers: their layout and their codes.
 */

/*!
  \file vpCircleMarkerFamily.h
  \brief Families of circular markers: their layout and their codes.
*/

#ifndef VP_CIRCLE_MARKER_FAMILY_H
#define VP_CIRCLE_MARKER_FAMILY_H

#include <cstdint>
#include <string>
#include <vector>

#include <visp3/circle_marker/vpConfigCircleMarker.h>

BEGIN_VISP_NAMESPACE

/*!
  \struct vpCircleMarkerLayout
  \ingroup group_circle_marker
  \brief Radii of the parts of a circular marker, in units of the ring's outer radius.

  A black ring on white paper; inside it, after a white gap, a track of equal sectors carries the code
  (a black sector is a 1); the centre is white. A margin of white paper, the quiet zone, surrounds the ring.
*/
struct vpCircleMarkerLayout
{
  double ringInner = 0.80;     //!< Inner radius of the black ring; 0 for a filled disc.
  double codeOuter = 0.68;     //!< Outer radius of the code track; 0 without a code.
  double codeInner = 0.40;     //!< Inner radius of the code track; 0 without a code.
  double quietZone = 1.0 / 6.; //!< Least width of the white margin around the ring (15 mm for a ring of 180 mm).
};

/*!
  \class vpCircleMarkerFamily
  \ingroup group_circle_marker
  \brief A family of circular markers: layout, cyclic code and numbering.

  The codes are cyclic: every rotation of a codeword is a codeword, so an orbit of n words under rotation is one
  marker, and the position in the orbit is its spin about the normal. The numbering is fixed for ever, so that printed
  markers stay valid: ids number the orbits by ascending representative, the smallest word of an orbit, from 0.
  Sector k spans the angles 2*pi*k/n to 2*pi*(k+1)/n from +x toward +y of the marker frame whose z axis points into
  the marker (clockwise as a viewer sees the print); sector 0 is the most significant of the n bits.

  | family  | code             | ids  | minimum distance |
  |---------|------------------|------|------------------|
  | golay23 | Golay [23,12,7]  | 178  | 7                |
  | bch31   | BCH [31,16,7]    | 2114 | 7                |
  | bch31r  | BCH [31,11,11]   | 66   | 11               |
  | ring    | none             | -    | -                |
  | disc    | none             | -    | -                |
*/
class VISP_EXPORT vpCircleMarkerFamily
{
public:
  /*! Names of the families. */
  enum vpType
  {
    GOLAY23, //!< Binary Golay code, the default: 178 markers.
    BCH31,   //!< BCH code [31,16,7]: 2114 markers.
    BCH31R,  //!< BCH code [31,11,11]: 66 markers, for occlusion and dirt.
    RING,    //!< Plain ring without a code: 5 degrees of freedom.
    DISC     //!< Filled disc without a code: 5 degrees of freedom.
  };

  vpCircleMarkerFamily(vpType type = GOLAY23);

  static vpCircleMarkerFamily fromName(const std::string &name);
  static vpCircleMarkerFamily ring(double ratio);
  static std::vector<vpCircleMarkerFamily> all();

  /*! Which family it is. */
  vpType getType() const { return m_type; }
  std::string getName() const;
  bool isCoded() const;
  unsigned int getNbSectors() const;
  unsigned int getNbIds() const;
  unsigned int getMinimumDistance() const;
  std::uint32_t getGenerator() const;
  /*! Radii of its parts, in units of the ring's outer radius. */
  const vpCircleMarkerLayout &getLayout() const { return m_layout; }
  vpCircleMarkerFamily withLayout(const vpCircleMarkerLayout &layout) const;
  std::uint32_t getCodeword(int id) const;
  bool isSectorBlack(int id, unsigned int sector) const;

private:
  vpType m_type;                 //!< Which family.
  vpCircleMarkerLayout m_layout; //!< Radii, in units of the outer radius.
};

END_VISP_NAMESPACE

#endif
