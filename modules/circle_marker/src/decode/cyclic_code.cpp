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

#include <algorithm>
#include <bitset>

#include <visp3/core/vpException.h>

#include "cyclic_code.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
/*! Calls visit(pattern) for every pattern of \e nbOnes ones among the bits below \e firstFree, added to \e pattern. */
template <typename Visitor>
void forEachPattern(CyclicCode::Word pattern, unsigned int firstFree, unsigned int nbOnes, const Visitor &visit)
{
  if (nbOnes == 0) {
    visit(pattern);
    return;
  }
  for (unsigned int bit = nbOnes - 1; bit < firstFree; ++bit) {
    forEachPattern(pattern | (CyclicCode::Word(1) << bit), bit, nbOnes - 1, visit);
  }
}

unsigned int degreeOf(CyclicCode::Word polynomial)
{
  unsigned int degree = 0;
  while (polynomial >>= 1) {
    ++degree;
  }
  return degree;
}

CyclicCode makeCode(const vpCircleMarkerFamily &family)
{
  return CyclicCode(family.getNbSectors(), family.getGenerator(), family.getMinimumDistance());
}
} // namespace

unsigned int hammingDistance(CyclicCode::Word a, CyclicCode::Word b)
{
  return static_cast<unsigned int>(std::bitset<32>(a ^ b).count());
}

CyclicCode::CyclicCode(unsigned int length, Word generator, unsigned int minimumDistance)
    : m_length(length), m_generator(generator), m_degree(degreeOf(generator)), m_minimumDistance(minimumDistance),
      m_mask(0), m_representatives(), m_leaders()
{
  if (length < 2 || length > 31 || generator < 2 || m_degree >= length || minimumDistance < 1) {
    throw vpException(vpException::badValue,
                      "A cyclic code needs a length of 2 to 31, a generator of lower degree and a distance >= 1");
  }
  m_mask = (Word(1) << length) - 1;

  // x^n mod g(x): by n multiplications by x, starting from 1.
  Word power = 1;
  for (unsigned int i = 0; i < length; ++i) {
    power = timesX(power);
  }
  if (power != 1) {
    throw vpException(vpException::badValue, "The generator 0x%x does not divide x^%u - 1: the code is not cyclic",
                      generator, length);
  }
  listRepresentatives();
  listLeaders();
}

/*! x r(x) mod g(x), for a remainder r of degree below that of g. */
CyclicCode::Word CyclicCode::timesX(Word remainder) const
{
  remainder <<= 1;
  return (remainder >> m_degree) & 1 ? remainder ^ m_generator : remainder;
}

/*! w(x) mod g(x): 0 for codewords, and the same for all words with the same error pattern. */
CyclicCode::Word CyclicCode::syndrome(Word word) const
{
  Word remainder = 0;
  for (unsigned int bit = m_length; bit-- > 0;) {
    remainder = timesX(remainder) ^ ((word >> bit) & 1);
  }
  return remainder;
}

CyclicCode::Word CyclicCode::encode(Word message) const
{
  Word product = 0;
  for (unsigned int bit = 0; bit < getDimension(); ++bit) {
    if ((message >> bit) & 1) {
      product ^= m_generator << bit;
    }
  }
  return product;
}

CyclicCode::Word CyclicCode::rotate(Word word, unsigned int rotation) const
{
  // Sector k is bit n-1-k: a higher sector is a lower bit.
  const unsigned int shift = rotation % m_length;
  word &= m_mask;
  return ((word >> shift) | (word << (m_length - shift))) & m_mask;
}

void CyclicCode::listRepresentatives()
{
  const Word nbMessages = Word(1) << getDimension();
  for (Word message = 0; message < nbMessages; ++message) {
    const Word word = encode(message);
    if (word == 0 || word == m_mask) {
      continue;
    }
    bool smallest = true;
    for (unsigned int rotation = 1; rotation < m_length && smallest; ++rotation) {
      smallest = word <= rotate(word, rotation);
    }
    if (smallest) {
      m_representatives.push_back(word);
    }
  }
  std::sort(m_representatives.begin(), m_representatives.end());
}

void CyclicCode::listLeaders()
{
  // Every correctable error pattern is a rotation of one with sector 0 wrong: only those are kept (32 thousand
  // patterns, 256 kB, for bch31r instead of a million syndromes), and correct() turns the word instead.
  const unsigned int firstSector = m_length - 1; // As a bit.
  for (unsigned int nbErrors = 1; nbErrors <= getCapacity(); ++nbErrors) {
    forEachPattern(Word(1) << firstSector, firstSector, nbErrors - 1,
                   [this](Word pattern) { m_leaders.emplace_back(syndrome(pattern), pattern); });
  }
  std::sort(m_leaders.begin(), m_leaders.end());
}

/*
  J. E. Meggitt, "Error correcting codes and their implementation for data transmission systems", IRE Transactions on
  Information Theory 7(4), 1961: the syndrome of a word rotated by one place, x w(x) mod (x^n - 1), is x s(x) mod g(x).
*/
std::optional<CyclicCode::Word> CyclicCode::correct(Word word, unsigned int maxErrors) const
{
  word &= m_mask;
  Word remainder = syndrome(word);
  if (remainder == 0) {
    return word;
  }
  // Multiplying by x moves sector k to sector k-1: after t steps sector 0 holds what was in sector t.
  for (unsigned int turn = 0; turn < m_length; ++turn) {
    const auto leader = std::lower_bound(m_leaders.begin(), m_leaders.end(), Leader(remainder, 0));
    if (leader != m_leaders.end() && leader->first == remainder) {
      // At most (d-1)/2 errors: no second pattern of so few errors exists, so a refusal is final.
      if (hammingDistance(leader->second, 0) > maxErrors) {
        return std::nullopt;
      }
      return word ^ rotate(leader->second, turn);
    }
    remainder = timesX(remainder);
  }
  return std::nullopt;
}

std::optional<CyclicCode::Identity> CyclicCode::identify(Word codeword) const
{
  if ((codeword & ~m_mask) != 0) {
    return std::nullopt;
  }
  Word smallest = codeword;
  unsigned int turnsBack = 0; // rotate(smallest, turnsBack) == codeword
  for (unsigned int rotation = 1; rotation < m_length; ++rotation) {
    const Word turned = rotate(codeword, m_length - rotation);
    if (turned < smallest) {
      smallest = turned;
      turnsBack = rotation;
    }
  }
  const auto found = std::lower_bound(m_representatives.begin(), m_representatives.end(), smallest);
  if (found == m_representatives.end() || *found != smallest) {
    return std::nullopt;
  }
  return Identity{static_cast<int>(found - m_representatives.begin()), turnsBack};
}

const CyclicCode &codeOf(const vpCircleMarkerFamily &family)
{
  // Static locals are initialised once, thread safe, when first reached.
  switch (family.getType()) {
  case vpCircleMarkerFamily::GOLAY23: {
    static const CyclicCode golay23 = makeCode(family);
    return golay23;
  }
  case vpCircleMarkerFamily::BCH31: {
    static const CyclicCode bch31 = makeCode(family);
    return bch31;
  }
  case vpCircleMarkerFamily::BCH31R: {
    static const CyclicCode bch31r = makeCode(family);
    return bch31r;
  }
  case vpCircleMarkerFamily::RING:
  case vpCircleMarkerFamily::DISC:
    break;
  }
  throw vpException(vpException::badValue, "The family %s has no code: use golay23, bch31 or bch31r",
                    family.getName().c_str());
}
} // namespace circle_marker
END_VISP_NAMESPACE
