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
 * Sixteen pixels in a register of AVX-512.
 */

/*!
  \file avx512_lanes.h
  \brief Sixteen numbers in one register, with the functions of Eigen::Array that the code on lanes uses.

  Included by lanes.h only, where the compiler may use these instructions.
*/

#ifndef VP_CIRCLE_MARKER_AVX512_LANES_H
#define VP_CIRCLE_MARKER_AVX512_LANES_H

#include <immintrin.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace widest_lanes {
/*! Number of pixels that are treated together. */
constexpr int laneCount = 16;

/*! Sixteen numbers in a register. */
class alignas(64) Lanes
{
public:
  Lanes() = default;
  Lanes(__m512 value) : m_value(value) {}

  static Lanes Constant(float x) { return _mm512_set1_ps(x); }
  static Lanes Zero() { return _mm512_setzero_ps(); }
  static Lanes Ones() { return Constant(1.f); }

  void setConstant(float x) { *this = Constant(x); }
  void setZero() { *this = Zero(); }
  void setOnes() { *this = Ones(); }

  // The register's type may alias any other.
  float &operator[](std::ptrdiff_t lane) { return reinterpret_cast<float *>(&m_value)[lane]; }
  float operator[](std::ptrdiff_t lane) const { return reinterpret_cast<const float *>(&m_value)[lane]; }

  Lanes operator-() const { return _mm512_xor_ps(m_value, _mm512_set1_ps(-0.f)); }
  Lanes &operator+=(const Lanes &b) { return *this = _mm512_add_ps(m_value, b.m_value); }
  Lanes &operator-=(const Lanes &b) { return *this = _mm512_sub_ps(m_value, b.m_value); }
  Lanes &operator*=(const Lanes &b) { return *this = _mm512_mul_ps(m_value, b.m_value); }

  Lanes floor() const { return _mm512_roundscale_ps(m_value, _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC); }
  Lanes abs() const { return _mm512_abs_ps(m_value); }
  Lanes min(const Lanes &b) const { return _mm512_min_ps(m_value, b.m_value); }
  Lanes max(const Lanes &b) const { return _mm512_max_ps(m_value, b.m_value); }
  Lanes min(float b) const { return min(Constant(b)); }
  Lanes max(float b) const { return max(Constant(b)); }
  Lanes square() const { return _mm512_mul_ps(m_value, m_value); }
  Lanes cube() const { return _mm512_mul_ps(square().m_value, m_value); }
  Lanes sqrt() const { return _mm512_sqrt_ps(m_value); }
  Lanes inverse() const { return _mm512_div_ps(Ones().m_value, m_value); }
  Lanes rsqrt() const { return sqrt().inverse(); }
  __m512 value() const { return m_value; }

  Lanes exp() const;
  Lanes log() const;

  /*! The nearest whole numbers. */
  Lanes rounded() const { return _mm512_roundscale_ps(m_value, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC); }

  /*! Times 2^n, n whole numbers. */
  Lanes scaledBy(const Lanes &n) const { return _mm512_scalef_ps(m_value, n.m_value); }

  /*! As 2^n m, with m in [sqrt(1/2), sqrt(2)]; of positive numbers that are not denormal. */
  void split(Lanes &n, Lanes &m) const
  {
    const __m512i rootOfHalf = _mm512_set1_epi32(0x3f3504f3);
    const __m512i bits = _mm512_sub_epi32(_mm512_castps_si512(m_value), rootOfHalf);
    n = _mm512_cvtepi32_ps(_mm512_srai_epi32(bits, 23));
    const __m512i mantissa = _mm512_and_si512(bits, _mm512_set1_epi32(0x007fffff));
    m = _mm512_castsi512_ps(_mm512_add_epi32(mantissa, rootOfHalf));
  }

  float sum() const { return _mm512_reduce_add_ps(m_value); }
  float minCoeff() const { return _mm512_reduce_min_ps(m_value); }
  float maxCoeff() const { return _mm512_reduce_max_ps(m_value); }

private:
  __m512 m_value;
};

inline Lanes operator+(const Lanes &a, const Lanes &b)
{
  return _mm512_add_ps(a.value(), b.value());
}
inline Lanes operator-(const Lanes &a, const Lanes &b)
{
  return _mm512_sub_ps(a.value(), b.value());
}
inline Lanes operator*(const Lanes &a, const Lanes &b)
{
  return _mm512_mul_ps(a.value(), b.value());
}
inline Lanes operator/(const Lanes &a, const Lanes &b)
{
  return _mm512_div_ps(a.value(), b.value());
}

/*! The numbers valueOf(0), valueOf(1) and so on, put together in registers as with AVX2. */
template <class ValueOf> inline Lanes lanesOf(const ValueOf &valueOf)
{
  return _mm512_setr_ps(valueOf(0), valueOf(1), valueOf(2), valueOf(3), valueOf(4), valueOf(5), valueOf(6), valueOf(7),
                        valueOf(8), valueOf(9), valueOf(10), valueOf(11), valueOf(12), valueOf(13), valueOf(14),
                        valueOf(15));
}

/*! The sum of both halves. */
inline __m256 halvesOf(const Lanes &lanes)
{
  return _mm256_add_ps(_mm512_castps512_ps256(lanes.value()), _mm512_extractf32x8_ps(lanes.value(), 1));
}

/*! The sum of each of eight blocks of lanes: neighbouring lanes are added until each half of a register has its part of
    four sums. */
inline __m256 sumOfEachOfEight(const Lanes *blocks)
{
  const __m256 first = _mm256_hadd_ps(_mm256_hadd_ps(halvesOf(blocks[0]), halvesOf(blocks[1])),
                                      _mm256_hadd_ps(halvesOf(blocks[2]), halvesOf(blocks[3])));
  const __m256 last = _mm256_hadd_ps(_mm256_hadd_ps(halvesOf(blocks[4]), halvesOf(blocks[5])),
                                     _mm256_hadd_ps(halvesOf(blocks[6]), halvesOf(blocks[7])));
  return _mm256_add_ps(_mm256_permute2f128_ps(first, last, 0x20), _mm256_permute2f128_ps(first, last, 0x31));
}

/*! The sum of each of sixteen blocks of lanes. */
inline Lanes sumOfEach(const Lanes *blocks)
{
  return _mm512_insertf32x8(_mm512_castps256_ps512(sumOfEachOfEight(blocks)), sumOfEachOfEight(blocks + 8), 1);
}

/*! Adds lanes to as many numbers. */
inline void addEach(double *numbers, const Lanes &lanes)
{
  const __m512d low = _mm512_cvtps_pd(_mm512_castps512_ps256(lanes.value()));
  const __m512d high = _mm512_cvtps_pd(_mm512_extractf32x8_ps(lanes.value(), 1));
  _mm512_storeu_pd(numbers, _mm512_add_pd(_mm512_loadu_pd(numbers), low));
  _mm512_storeu_pd(numbers + 8, _mm512_add_pd(_mm512_loadu_pd(numbers + 8), high));
}
} // namespace widest_lanes
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
