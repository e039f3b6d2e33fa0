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
 * Binary cyclic codes: error correction and identification of rotated words.
 */

#ifndef VP_CYCLIC_CODE_H
#define VP_CYCLIC_CODE_H

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <visp3/circle_marker/vpCircleMarkerFamily.h>
#include <visp3/circle_marker/vpConfigCircleMarker.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  A binary cyclic code of length n <= 31, whose generator polynomial g(x) divides x^n - 1, and its orbits under
  rotation. One orbit is one marker, the position in the orbit is the marker's spin.

  Words are unsigned integers of n bits: sector 0 is the most significant of the n bits and the coefficient of x^(n-1),
  sector k is bit n-1-k. Rotating a word by +r sectors moves the content of sector k to sector (k + r) mod n: this is
  what a marker turned by +r sectors (clockwise as a viewer sees the print) shows. Rotations are taken modulo n.
*/
class CyclicCode
{
public:
  using Word = std::uint32_t;

  /*! A codeword that is the representative of orbit \e id rotated by +\e rotation sectors, in [0, n-1]. */
  struct Identity
  {
    int id;
    unsigned int rotation;
  };

  /*!
    \param length : n, prime and at most 31, so that every orbit but those of the constant words has n members.
    \param generator : g(x), bit i is the coefficient of x^i; its degree is n - k.
    \param minimumDistance : Hamming distance d of the code; up to (d-1)/2 errors can be corrected.
    \exception vpException::badValue : If g(x) does not divide x^n - 1.
  */
  CyclicCode(unsigned int length, Word generator, unsigned int minimumDistance);

  unsigned int getLength() const { return m_length; }
  unsigned int getDimension() const { return m_length - m_degree; }

  /*! Largest number of wrong sectors with one nearest codeword: (d-1)/2. */
  unsigned int getCapacity() const { return (m_minimumDistance - 1) / 2; }

  /*! The smallest word of each orbit, ascending: the index is the id. Constant words (all 0, all 1) are no markers. */
  const std::vector<Word> &getRepresentatives() const { return m_representatives; }

  /*! The code word of a message of k bits: the product of the polynomials message(x) and g(x). */
  Word encode(Word message) const;

  /*! Calls visit(word) for every codeword but the zero word. */
  template <typename Visitor> void forEachCodeword(const Visitor &visit) const
  {
    // In the order of a Gray code each message differs from the last in one bit.
    Word word = 0;
    for (Word number = 1; number < Word(1) << getDimension(); ++number) {
      unsigned int bit = 0;
      while (((number >> bit) & 1U) == 0) {
        ++bit;
      }
      word ^= m_generator << bit;
      visit(word);
    }
  }

  /*! The word turned by +rotation sectors. */
  Word rotate(Word word, unsigned int rotation) const;

  /*!
    The codeword that differs from \e word in at most \e maxErrors sectors (beyond getCapacity() this bound is taken),
    or nothing. Bits above the n-th are ignored.

    A constant word is a codeword and can be the answer: identify() then refuses it.
  */
  std::optional<Word> correct(Word word, unsigned int maxErrors) const;

  /*! Orbit and rotation of a codeword; nothing for a word outside the code and for the constant words. */
  std::optional<Identity> identify(Word codeword) const;

private:
  using Leader = std::pair<Word, Word>; // Syndrome and error pattern.

  Word syndrome(Word word) const;
  Word timesX(Word remainder) const;
  void listRepresentatives();
  void listLeaders();

  unsigned int m_length;               //!< n, sectors.
  Word m_generator;                    //!< g(x), bit i is the coefficient of x^i.
  unsigned int m_degree;               //!< Degree of g(x): n - k.
  unsigned int m_minimumDistance;      //!< d.
  Word m_mask;                         //!< n ones.
  std::vector<Word> m_representatives; //!< Smallest word of each orbit, ascending.
  std::vector<Leader> m_leaders;       //!< Correctable error patterns with sector 0 wrong, by syndrome.
};

/*! Whether a sector of a word of so many is black: the first is the most significant of its bits. */
constexpr bool isSectorBlack(CyclicCode::Word word, unsigned int sector, unsigned int sectors)
{
  return ((word >> (sectors - 1 - sector)) & 1U) != 0;
}

/*! Number of sectors in which two words differ. */
unsigned int hammingDistance(CyclicCode::Word a, CyclicCode::Word b);

/*!
  The code of a family. It is computed from the generator at the first call for this family, once, whatever the
  number of threads.
  \exception vpException::badValue : If the family has no code.
*/
const CyclicCode &codeOf(const vpCircleMarkerFamily &family);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
