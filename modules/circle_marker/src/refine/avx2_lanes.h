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
 * Arithmetic on eight pixels at a time with AVX2 and FMA.
 */

/*!
  \file avx2_lanes.h
  \brief Eight numbers in one register, with the functions of Eigen::Array that the code on lanes uses.

  Included by lanes.h only, where the compiler may use these instructions.
*/

#ifndef VP_CIRCLE_MARKER_AVX2_LANES_H
#define VP_CIRCLE_MARKER_AVX2_LANES_H

#include <immintrin.h>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
inline namespace wide_lanes {
/*! Number of pixels that are treated together. */
constexpr int laneCount = 8;

class alignas(32) Lanes
{
public:
  Lanes() = default;
  Lanes(__m256 value) : m_value(value) {}

  static Lanes Constant(float x) { return _mm256_set1_ps(x); }
  static Lanes Zero() { return _mm256_setzero_ps(); }
  static Lanes Ones() { return Constant(1.f); }
  static Lanes LinSpaced(float first, float last)
  {
    const float step = (last - first) / 7.f;
    return _mm256_fmadd_ps(_mm256_setr_ps(0.f, 1.f, 2.f, 3.f, 4.f, 5.f, 6.f, 7.f), Constant(step).m_value,
                           Constant(first).m_value);
  }

  void setConstant(float x) { *this = Constant(x); }
  void setZero() { *this = Zero(); }
  void setOnes() { *this = Ones(); }

  // The register's type may alias any other.
  float &operator[](std::ptrdiff_t lane) { return reinterpret_cast<float *>(&m_value)[lane]; }
  float operator[](std::ptrdiff_t lane) const { return reinterpret_cast<const float *>(&m_value)[lane]; }

  Lanes operator-() const { return _mm256_xor_ps(m_value, _mm256_set1_ps(-0.f)); }
  Lanes &operator+=(const Lanes &b) { return *this = _mm256_add_ps(m_value, b.m_value); }
  Lanes &operator-=(const Lanes &b) { return *this = _mm256_sub_ps(m_value, b.m_value); }
  Lanes &operator*=(const Lanes &b) { return *this = _mm256_mul_ps(m_value, b.m_value); }

  Lanes floor() const { return _mm256_floor_ps(m_value); }
  Lanes abs() const { return _mm256_andnot_ps(_mm256_set1_ps(-0.f), m_value); }
  Lanes min(const Lanes &b) const { return _mm256_min_ps(m_value, b.m_value); }
  Lanes max(const Lanes &b) const { return _mm256_max_ps(m_value, b.m_value); }
  Lanes min(float b) const { return min(Constant(b)); }
  Lanes max(float b) const { return max(Constant(b)); }
  Lanes square() const { return _mm256_mul_ps(m_value, m_value); }
  Lanes cube() const { return _mm256_mul_ps(square().m_value, m_value); }
  Lanes sqrt() const { return _mm256_sqrt_ps(m_value); }
  Lanes inverse() const { return _mm256_div_ps(Ones().m_value, m_value); }
  Lanes rsqrt() const { return sqrt().inverse(); }
  __m256 value() const { return m_value; }

  Lanes exp() const;
  Lanes log() const;

  /*! The nearest whole numbers. */
  Lanes rounded() const { return _mm256_round_ps(m_value, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC); }

  /*! Times 2^n, n whole numbers from -126 to 127. */
  Lanes scaledBy(const Lanes &n) const
  {
    const __m256i exponent =
        _mm256_slli_epi32(_mm256_add_epi32(_mm256_cvtps_epi32(n.m_value), _mm256_set1_epi32(127)), 23);
    return _mm256_mul_ps(m_value, _mm256_castsi256_ps(exponent));
  }

  /*! As 2^n m, with m in [sqrt(1/2), sqrt(2)]; of positive numbers that are not denormal. */
  void split(Lanes &n, Lanes &m) const
  {
    const __m256i rootOfHalf = _mm256_set1_epi32(0x3f3504f3);
    const __m256i bits = _mm256_sub_epi32(_mm256_castps_si256(m_value), rootOfHalf);
    n = _mm256_cvtepi32_ps(_mm256_srai_epi32(bits, 23));
    const __m256i mantissa = _mm256_and_si256(bits, _mm256_set1_epi32(0x007fffff));
    m = _mm256_castsi256_ps(_mm256_add_epi32(mantissa, rootOfHalf));
  }

  float sum() const
  {
    return fold([](const __m128 &a, const __m128 &b) { return _mm_add_ps(a, b); });
  }
  float minCoeff() const
  {
    return fold([](const __m128 &a, const __m128 &b) { return _mm_min_ps(a, b); });
  }
  float maxCoeff() const
  {
    return fold([](const __m128 &a, const __m128 &b) { return _mm_max_ps(a, b); });
  }

private:
  // All lanes together by an operation that takes two registers of four.
  template <class Operation> float fold(const Operation &together) const
  {
    const __m128 four = together(_mm256_castps256_ps128(m_value), _mm256_extractf128_ps(m_value, 1));
    const __m128 two = together(four, _mm_movehl_ps(four, four));
    return _mm_cvtss_f32(together(two, _mm_shuffle_ps(two, two, 1)));
  }

  __m256 m_value;
};

inline Lanes operator+(const Lanes &a, const Lanes &b)
{
  return _mm256_add_ps(a.value(), b.value());
}
inline Lanes operator-(const Lanes &a, const Lanes &b)
{
  return _mm256_sub_ps(a.value(), b.value());
}
inline Lanes operator*(const Lanes &a, const Lanes &b)
{
  return _mm256_mul_ps(a.value(), b.value());
}
inline Lanes operator/(const Lanes &a, const Lanes &b)
{
  return _mm256_div_ps(a.value(), b.value());
}
/*! The numbers valueOf(0), valueOf(1) and so on: put together in registers, since a register that is loaded from where
    eight single numbers were just stored has to wait for all of them. */
template <class ValueOf> inline Lanes lanesOf(const ValueOf &valueOf)
{
  return _mm256_setr_ps(valueOf(0), valueOf(1), valueOf(2), valueOf(3), valueOf(4), valueOf(5), valueOf(6), valueOf(7));
}

/*! The sum of each of eight blocks of lanes. */
inline Lanes sumOfEach(const Lanes *blocks)
{
  // Neighbouring lanes are added until each half of a register has its part of four sums.
  const auto fourOf = [](const Lanes *four) -> Lanes {
    return _mm256_hadd_ps(_mm256_hadd_ps(four[0].value(), four[1].value()),
                          _mm256_hadd_ps(four[2].value(), four[3].value()));
  };
  const Lanes first = fourOf(blocks);
  const Lanes last = fourOf(blocks + 4);
  return _mm256_add_ps(_mm256_permute2f128_ps(first.value(), last.value(), 0x20),
                       _mm256_permute2f128_ps(first.value(), last.value(), 0x31));
}

/*! Adds lanes to as many numbers. */
inline void addEach(double *numbers, const Lanes &lanes)
{
  const auto add = [](double *four, const __m128 &half) {
    _mm256_storeu_pd(four, _mm256_add_pd(_mm256_loadu_pd(four), _mm256_cvtps_pd(half)));
  };
  add(numbers, _mm256_castps256_ps128(lanes.value()));
  add(numbers + 4, _mm256_extractf128_ps(lanes.value(), 1));
}
} // namespace wide_lanes
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
