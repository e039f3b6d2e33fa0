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

#include <visp3/circle_marker/vpCircleMarkerFamily.h>

#include <cmath>

#include <visp3/core/vpException.h>

#include "decode/cyclic_code.h"

BEGIN_VISP_NAMESPACE

namespace {
/*!
  What distinguishes the families. Generators: bit i is the coefficient of x^i.
  Golay code: F. J. MacWilliams, N. J. A. Sloane, "The Theory of Error-Correcting Codes", 1977, chapter 2.6.
  BCH codes: the same, chapter 7.6, over GF(32) with the primitive polynomial x^5 + x^2 + 1.
*/
struct FamilyData
{
  vpCircleMarkerFamily::vpType type;
  const char *name;
  unsigned int nbSectors; // n, prime, so that every orbit but the constant words has n members.
  unsigned int nbIds;     // (2^k - 2) / n, with k = n - degree of the generator.
  unsigned int minimumDistance;
  std::uint32_t generator;
};

const FamilyData allFamilies[] = {
    // x^11 + x^9 + x^7 + x^6 + x^5 + x + 1
    {vpCircleMarkerFamily::GOLAY23, "golay23", 23, 178, 7, 0xAE3},
    // Minimal polynomials of alpha, alpha^3, alpha^5.
    {vpCircleMarkerFamily::BCH31, "bch31", 31, 2114, 7, 0x8FAF},
    // Minimal polynomials of alpha, alpha^3, alpha^5, alpha^7.
    {vpCircleMarkerFamily::BCH31R, "bch31r", 31, 66, 11, 0x1626D5},
    {vpCircleMarkerFamily::RING, "ring", 0, 0, 0, 0},
    {vpCircleMarkerFamily::DISC, "disc", 0, 0, 0, 0},
};

const FamilyData &dataOf(vpCircleMarkerFamily::vpType type)
{
  for (const FamilyData &data : allFamilies) {
    if (data.type == type) {
      return data;
    }
  }
  throw vpException(vpException::badValue, "%d is no family of circular markers: use a value of vpType",
                    static_cast<int>(type));
}
} // namespace

/*!
  A family with its default layout. Implicit, so that a vpType can be given wherever a family is expected.

  \exception vpException::badValue : If \e type is no value of vpType.
*/
vpCircleMarkerFamily::vpCircleMarkerFamily(vpType type) : m_type(dataOf(type).type), m_layout()
{
  if (!isCoded()) {
    m_layout.codeOuter = 0;
    m_layout.codeInner = 0;
  }
  if (type == DISC) {
    m_layout.ringInner = 0;
  }
}

/*!
  The family of a name, as getName() writes it.

  \exception vpException::badValue : If no family has this name; the message lists those that exist.
*/
vpCircleMarkerFamily vpCircleMarkerFamily::fromName(const std::string &name)
{
  std::string known;
  for (const FamilyData &data : allFamilies) {
    if (name == data.name) {
      return vpCircleMarkerFamily(data.type);
    }
    known += (known.empty() ? "" : ", ") + std::string(data.name);
  }
  throw vpException(vpException::badValue, "No family of circular markers is named \"%s\": use one of %s", name.c_str(),
                    known.c_str());
}

/*!
  A plain ring without a code.

  \param ratio : Inner radius over outer radius, above 0 and below 1. It has to be that of the print: a ring of another
  one is not found or, where blur and gamma hide the difference, in some 20 pixels, taken for one at another distance;
  so is any that is off by less than 0.02. The detector finds rings of 0.2 to 0.95.
  \exception vpException::badValue : If the ratio is not between 0 and 1, both excluded.
*/
vpCircleMarkerFamily vpCircleMarkerFamily::ring(double ratio)
{
  if (!(ratio > 0 && ratio < 1)) {
    throw vpException(vpException::badValue,
                      "The ratio of a ring is its inner radius over its outer radius, above 0 and below 1, not %g",
                      ratio);
  }
  vpCircleMarkerFamily family(RING);
  family.m_layout.ringInner = ratio;
  return family;
}

/*!
  The same family printed with other radii, for studies of the design: such markers are not those of the default print.

  \param layout : Radii in units of the ring's outer radius; those of a code count for coded families only.
  \exception vpException::badValue : If the parts overlap or are not there: they are, from the centre outward, the white
  centre, the code track, the white gap, the ring and the quiet zone. A disc has a ring from 0 to 1.
*/
vpCircleMarkerFamily vpCircleMarkerFamily::withLayout(const vpCircleMarkerLayout &layout) const
{
  const bool isRing = m_type == DISC ? layout.ringInner == 0. : layout.ringInner > 0. && layout.ringInner < 1.;
  const bool hasRing = isRing && layout.quietZone > 0. && std::isfinite(layout.quietZone);
  const bool hasCode =
      layout.codeInner > 0. && layout.codeInner < layout.codeOuter && layout.codeOuter < layout.ringInner;
  if (!hasRing || (isCoded() && !hasCode)) {
    throw vpException(
        vpException::badValue,
        "A marker with a code from %g to %g, a ring from %g to 1 and a quiet zone of %g cannot be "
        "printed: the code lies inside of the ring, both inside of the quiet zone; a disc's ring begins at "
        "0, and no other does",
        layout.codeInner, layout.codeOuter, layout.ringInner, layout.quietZone);
  }
  vpCircleMarkerFamily family(*this);
  family.m_layout = layout;
  if (!isCoded()) {
    family.m_layout.codeOuter = 0;
    family.m_layout.codeInner = 0;
  }
  return family;
}

/*! The five families, each with its default layout, in the order of vpType. */
std::vector<vpCircleMarkerFamily> vpCircleMarkerFamily::all()
{
  std::vector<vpCircleMarkerFamily> families;
  for (const FamilyData &data : allFamilies) {
    families.push_back(vpCircleMarkerFamily(data.type));
  }
  return families;
}

/*! The family's name, as programs and messages write it: "golay23", "bch31", "bch31r", "ring" or "disc". */
std::string vpCircleMarkerFamily::getName() const
{
  return dataOf(m_type).name;
}

/*! Whether the markers of the family carry a code, hence an id and a spin. */
bool vpCircleMarkerFamily::isCoded() const
{
  return getNbSectors() > 0;
}

/*! Number n of sectors of the code track; 0 without a code. */
unsigned int vpCircleMarkerFamily::getNbSectors() const
{
  return dataOf(m_type).nbSectors;
}

/*! Number of ids, which run from 0 to getNbIds() - 1; 0 without a code. */
unsigned int vpCircleMarkerFamily::getNbIds() const
{
  return dataOf(m_type).nbIds;
}

/*! Least number of sectors in which two markers differ, whatever their rotations; 0 without a code. */
unsigned int vpCircleMarkerFamily::getMinimumDistance() const
{
  return dataOf(m_type).minimumDistance;
}

/*! Generator polynomial of the cyclic code, bit i is the coefficient of x^i; 0 without a code. */
std::uint32_t vpCircleMarkerFamily::getGenerator() const
{
  return dataOf(m_type).generator;
}

/*!
  The word printed on a marker: the smallest of its orbit; the most significant of the getNbSectors() bits is sector 0.

  \exception vpException::badValue : If the family has no code or no such id.
*/
std::uint32_t vpCircleMarkerFamily::getCodeword(int id) const
{
  const std::vector<std::uint32_t> &words = circle_marker::codeOf(*this).getRepresentatives();
  if (id < 0 || static_cast<std::size_t>(id) >= words.size()) {
    throw vpException(vpException::badValue, "The family %s has no id %d: use 0 to %d", getName().c_str(), id,
                      static_cast<int>(words.size()) - 1);
  }
  return words[static_cast<std::size_t>(id)];
}

/*!
  Whether a sector of a marker's code track is black.

  \param id : The marker.
  \param sector : From 0 to getNbSectors() - 1; sector k spans 2*pi*k/n to 2*pi*(k+1)/n from +x toward +y.
  \exception vpException::badValue : If the family has no code, no such id or no such sector.
*/
bool vpCircleMarkerFamily::isSectorBlack(int id, unsigned int sector) const
{
  const std::uint32_t word = getCodeword(id);
  if (sector >= getNbSectors()) {
    throw vpException(vpException::badValue, "The family %s has no sector %u: use 0 to %u", getName().c_str(), sector,
                      getNbSectors() - 1);
  }
  return circle_marker::isSectorBlack(word, sector, getNbSectors());
}

END_VISP_NAMESPACE
