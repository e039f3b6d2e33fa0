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

#include <cmath>

#include <visp3/core/vpException.h>

#include <visp3/circle_marker_simulator/vpSimulatedMarker.h>

#include "april_tag_36h11.h"
#include "marker_codes.h"

BEGIN_VISP_NAMESPACE

namespace {

// Default print: a ring of 180 mm on a square of 210 mm, that is a margin of a sixth of the ring's radius.
constexpr double DEFAULT_QUIET_ZONE = 1. / 6.;
// Ratio of the ring, with a code or, unless another is asked for, without: black from 0.80 to 1.00 of the outer radius.
constexpr double RING_RATIO = 0.80;
// Half of the narrowest white sector (31 sectors, inner radius of the track 0.4) is 0.0405 of the radius.
constexpr double MOST_INK_SPREAD = 0.02;
// Largest height of a bent sheet's arc, as a share of its side: an arc of 46 degrees, which no wall has.
constexpr double MOST_BOW = 0.1;

} // namespace

vpSimulatedMarker::vpSimulatedMarker(const std::string &family, int id, double width, double height)
    : m_family(family), m_id(id), m_size(width), m_height(height), m_sheetWidth(width), m_sheetHeight(height)
{
  if (!(width > 0.) || !(height > 0.) || !std::isfinite(width) || !std::isfinite(height)) {
    throw vpException(vpException::badValue, "a marker of %g m by %g m cannot be printed: sizes must be positive",
                      width, height);
  }
}

/*!
  A circular marker on a square sheet with the default quiet zone.

  \param family : "golay23", "bch31", "bch31r", "ring" (ratio 0.8) or "disc".
  \param id : number of the marker; not used (-1) by ring and disc.
  \param size : outer diameter of the black ring, in metres.
  \exception vpException::badValue : unknown family or id, size not positive.
*/
vpSimulatedMarker vpSimulatedMarker::circle(const std::string &family, int id, double size)
{
  if (family == "ring") {
    return ring(size, RING_RATIO);
  }
  if (family == "disc") {
    return disc(size);
  }
  const std::vector<std::uint32_t> &words = marker_simulator::representativesOf(family);
  if (id < 0 || id >= static_cast<int>(words.size())) {
    throw vpException(vpException::badValue, "family %s has the ids 0 to %d, not %d", family.c_str(),
                      static_cast<int>(words.size()) - 1, id);
  }
  vpSimulatedMarker marker(family, id, size, size);
  marker.m_ringRatio = RING_RATIO;
  marker.m_sectors = sectors(family);
  marker.m_codeword = words[id];
  return marker.setQuietZone(DEFAULT_QUIET_ZONE);
}

/*!
  A plain ring.

  \param size : outer diameter, in metres.
  \param ratio : inner over outer diameter, from 0 (a disc) to less than 1.
  \exception vpException::badValue : a ratio out of this range, or a size that is not positive.
*/
vpSimulatedMarker vpSimulatedMarker::ring(double size, double ratio)
{
  if (!(ratio >= 0. && ratio < 1.)) {
    throw vpException(vpException::badValue, "a ring's ratio of inner to outer diameter is in [0, 1), not %g", ratio);
  }
  vpSimulatedMarker marker("ring", -1, size, size);
  marker.m_ringRatio = ratio;
  return marker.setQuietZone(DEFAULT_QUIET_ZONE);
}

/*! A filled disc of the given diameter, in metres. */
vpSimulatedMarker vpSimulatedMarker::disc(double size)
{
  return vpSimulatedMarker("disc", -1, size, size).setQuietZone(DEFAULT_QUIET_ZONE);
}

/*!
  A marker of rings of one's own, for studies of the design; setTrack() adds a code.

  \param radii : inner and outer radius of each black ring, over half the size; they do not overlap. An inner radius of
  0 makes a disc.
  \param size : diameter of a circle that holds all that is black, in metres.
  \exception vpException::badValue : radii out of order, negative or beyond the size.
*/
vpSimulatedMarker vpSimulatedMarker::rings(const std::vector<std::array<double, 2>> &radii, double size)
{
  vpSimulatedMarker marker("rings", -1, size, size);
  for (const auto &[inner, outer] : radii) {
    if (!(inner >= 0. && inner < outer && outer <= 1.)) {
      throw vpException(vpException::badValue, "a ring from %g to %g of half the size cannot be printed", inner, outer);
    }
  }
  marker.m_ringRatio = 1.; // No ring but those.
  marker.m_rings = radii;
  return marker.setQuietZone(DEFAULT_QUIET_ZONE);
}

/*!
  An AprilTag of the family 36h11 with a white border of one cell (an eighth of the size).

  \param id : 0 to 9.
  \param size : side of the black square, in metres, which is the size that vpDetectorAprilTag wants.
*/
vpSimulatedMarker vpSimulatedMarker::aprilTag36h11(int id, double size)
{
  vpSimulatedMarker marker("36h11", id, size, size);
  marker.m_picture = marker_simulator::aprilTagCells(id);
  return marker.setSheetSide(size * 10. / 8.);
}

/*!
  Any picture, printed from edge to edge: each of its pixels becomes a rectangle of one grey.

  \param picture : 0 is ink, 255 is paper.
  \param width, height : size of the print, in metres.
  \exception vpException::badValue : the picture is empty, or a size is not positive.
*/
vpSimulatedMarker vpSimulatedMarker::bitmap(const vpImage<unsigned char> &picture, double width, double height)
{
  if (picture.getSize() == 0) {
    throw vpException(vpException::badValue, "an empty picture cannot be printed");
  }
  vpSimulatedMarker marker("bitmap", -1, width, height);
  marker.m_picture = picture;
  return marker;
}

/*! Words of a coded family in the order of the ids, sector 0 the most significant bit, as printed. */
std::vector<std::uint32_t> vpSimulatedMarker::codewords(const std::string &family)
{
  return marker_simulator::representativesOf(family);
}

/*! Number of sectors of a family's code track, 0 without a code. */
unsigned int vpSimulatedMarker::sectors(const std::string &family)
{
  const auto code = marker_simulator::codeOf(family);
  return code ? code->length : 0;
}

/*! Sets the pose in the camera frame (z into the marker, lengths in metres). */
vpSimulatedMarker &vpSimulatedMarker::setPose(const vpHomogeneousMatrix &cMo)
{
  m_cMo = cMo;
  return *this;
}

/*!
  Sets the width of white paper around the marker in units of half its size (the ring's outer radius): the sheet is a
  square of side size (1 + quietZone).
*/
vpSimulatedMarker &vpSimulatedMarker::setQuietZone(double quietZone)
{
  return setSheetSide(m_size * (1. + quietZone));
}

/*!
  Sets the side of the square white sheet, in metres; it is centred on the marker.
  \exception vpException::badValue : the sheet is smaller than the marker.
*/
vpSimulatedMarker &vpSimulatedMarker::setSheetSide(double side)
{
  if (!(side >= m_size) || !(side >= m_height)) {
    throw vpException(vpException::badValue, "a sheet of %g m is too small for a marker of %g m by %g m", side, m_size,
                      m_height);
  }
  m_sheetWidth = side;
  m_sheetHeight = side;
  return *this;
}

/*!
  Another layout of a marker with a code, in units of the ring's outer radius.
  \exception vpException::badValue : the marker has no code, or its parts overlap.
*/
vpSimulatedMarker &vpSimulatedMarker::setLayout(double ringRatio, double trackInner, double trackOuter)
{
  if (!m_codeword || !(trackInner > 0. && trackInner < trackOuter && trackOuter < ringRatio && ringRatio < 1.)) {
    throw vpException(vpException::badValue,
                      "a code from %g to %g inside of a ring from %g to 1 cannot be printed on a marker of family %s",
                      trackInner, trackOuter, ringRatio, m_family.c_str());
  }
  m_ringRatio = ringRatio;
  m_trackInner = trackInner;
  m_trackOuter = trackOuter;
  return *this;
}

/*!
  Prints a code on a marker of rings().

  \param inner, outer : radii of the code track over half the size.
  \param sectors : number of sectors, up to 32.
  \param word : sector 0 is the most significant of so many bits; neither all 0 nor all 1.
  \param isWindows : whether ones are white windows in a black ring, which must hold the track, or black sectors on
  white paper.
  \exception vpException::badValue : the marker is none of rings(), or there is no such track or word.
*/
vpSimulatedMarker &vpSimulatedMarker::setTrack(double inner, double outer, unsigned int sectors, std::uint32_t word,
                                               bool isWindows)
{
  constexpr unsigned int mostSectors = 32;
  const bool hasWord = sectors > 1 && sectors <= mostSectors && word != 0 && word >> (sectors - 1) <= 1 &&
                       word != 0xFFFFFFFFu >> (mostSectors - sectors);
  if (m_family != "rings" || !hasWord || !(inner > 0. && inner < outer && outer <= 1.)) {
    throw vpException(vpException::badValue,
                      "a code of %u sectors from %g to %g of half the size cannot be printed on a marker of family %s",
                      sectors, inner, outer, m_family.c_str());
  }
  m_trackInner = inner;
  m_trackOuter = outer;
  m_sectors = sectors;
  m_codeword = word;
  m_hasWindows = isWindows;
  return *this;
}

/*!
  Sets how far ink has spread: every black edge lies this much further out, in metres; negative for ink that is too
  thin. Only for circular markers and AprilTags.
  \exception vpException::badValue : a bitmap, or more than 0.02 of the marker's size.
*/
vpSimulatedMarker &vpSimulatedMarker::setInkSpread(double spread)
{
  if (m_family == "bitmap") {
    throw vpException(vpException::badValue, "ink spread is for circular markers and tags, not for bitmaps");
  }
  if (!(std::fabs(spread) <= MOST_INK_SPREAD * m_size)) {
    throw vpException(vpException::badValue,
                      "an ink spread of %g m would close or dissolve the cells of a marker of "
                      "%g m: at most %g m",
                      spread, m_size, MOST_INK_SPREAD * m_size);
  }
  m_inkSpread = spread;
  return *this;
}

/*!
  Makes the marker white on black: what is paper is as dark as ink, the sheet too, and what is ink is as bright as
  paper.

  \param inverse : Whether it is.
  \return This marker.
*/
vpSimulatedMarker &vpSimulatedMarker::setInverse(bool inverse)
{
  m_isInverse = inverse;
  return *this;
}

/*!
  Bends the sheet about an axis in its plane through the marker's centre, as paper bends: into a part of a cylinder,
  without stretching.

  The marker's pose is then that of the plane through the mean of the ring's outer edge, of which one half lies above
  and one half below: a bend moves the marker neither nearer nor farther on average.

  \param bow : height of the arc over a length of the sheet's side across the axis, in metres; positive: the sheet's
  edges lie farther from the viewer than its middle. 0: flat.
  \param axis : direction of the cylinder's axis, in radians from +x toward +y of the marker frame.
  \exception vpException::badValue : more than a tenth of the sheet's side.
*/
vpSimulatedMarker &vpSimulatedMarker::setBow(double bow, double axis)
{
  const double side = std::fmax(m_sheetWidth, m_sheetHeight);
  if (!(std::fabs(bow) <= MOST_BOW * side) || !std::isfinite(axis)) {
    throw vpException(vpException::badValue, "a bow of %g m is too much for a sheet of %g m: at most %g m", bow, side,
                      MOST_BOW * side);
  }
  m_bow = bow;
  m_bowAxis = axis;
  return *this;
}

END_VISP_NAMESPACE
