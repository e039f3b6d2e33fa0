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
 * Codewords compared by what they leave of a blurred image.
 */

#include "decode/blurred_words.h"

#include <algorithm>
#include <array>

#include <Eigen/LU>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// What a codeword leaves unexplained of a fit, when light and contrast are its own.
class CodewordSquares
{
public:
  CodewordSquares(const BlurredFit &fit, unsigned int sectors) : m_sectors(sectors), m_plain(fit.plain)
  {
    const int light = BlurredFit::lightSize;
    const Eigen::Index rest = 1 + sectors;
    const Eigen::MatrixXd inverse = fit.matrix.topLeftCorner(light, light).inverse();
    const Eigen::MatrixXd mixed = fit.matrix.bottomLeftCorner(rest, light);
    const Eigen::MatrixXd matrix = fit.matrix.bottomRightCorner(rest, rest) - mixed * inverse * mixed.transpose();
    const Eigen::VectorXd right = fit.right.tail(rest) - mixed * inverse * fit.right.head(light);
    m_ring = matrix(0, 0);
    m_ringRight = right[0];
    for (unsigned int k = 0; k < sectors; ++k) {
      m_right[k] = right[1 + k];
      m_diagonal[k] = matrix(1 + k, 1 + k) + 2. * matrix(0, 1 + k);
      for (unsigned int l = 0; l < sectors; ++l) {
        m_matrix[k][l] = matrix(1 + k, 1 + l);
      }
    }
  }

  double of(CyclicCode::Word word) const
  {
    double right = m_ringRight;
    double square = m_ring;
    std::array<unsigned int, mostSectors> black;
    std::size_t count = 0;
    for (unsigned int k = 0; k < m_sectors; ++k) {
      if (isSectorBlack(word, k, m_sectors)) {
        right += m_right[k];
        square += m_diagonal[k];
        for (std::size_t l = 0; l < count; ++l) {
          square += 2. * m_matrix[k][black[l]];
        }
        black[count++] = k;
      }
    }
    return right > 0. ? m_plain - right * right / square : m_plain;
  }

private:
  unsigned int m_sectors;
  double m_plain;
  double m_ring = 0.;
  double m_ringRight = 0.;
  std::array<double, mostSectors> m_right;
  std::array<double, mostSectors> m_diagonal;
  std::array<std::array<double, mostSectors>, mostSectors> m_matrix;
};
} // namespace

BestWords bestWords(const BlurredFit &fit, const CyclicCode &code, const Deadline &deadline)
{
  constexpr unsigned int wordsAtOnce = 1024; // some tenths of a millisecond
  const CodewordSquares squares(fit, code.getLength());
  BestWords words;
  unsigned int count = 0;
  bool isOver = false;
  code.forEachCodeword([&](CyclicCode::Word word) {
    isOver = isOver || (++count % wordsAtOnce == 0 && deadline.hasPassed());
    if (isOver) {
      return;
    }
    const double here = squares.of(word);
    if (here < words.squares) {
      words.next = words.squares;
      words.squares = here;
      words.best = word;
    }
    else {
      words.next = std::min(words.next, here);
    }
  });
  return words;
}
} // namespace circle_marker
END_VISP_NAMESPACE
