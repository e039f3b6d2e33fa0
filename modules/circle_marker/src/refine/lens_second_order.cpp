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
 * What a lens does to the image of a marker besides a linear map.
 */

#include "refine/lens_second_order.h"

#include <array>
#include <cstdint>
#include <cstring>

#include <Eigen/LU>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
bool isUniform(const std::vector<FitPixel> &pixels)
{
  // All are looked at, without a condition: it is mostly so. By their bits, because each comparison of numbers would
  // wait for the one before.
  std::array<std::uint64_t, 2> first;
  std::array<std::uint64_t, 2> changed = {};
  static_assert(sizeof(first) == sizeof(FitPixel::meterPerPixel), "four numbers in single precision");
  std::memcpy(first.data(), pixels.front().meterPerPixel.data(), sizeof(first));
  for (const FitPixel &pixel : pixels) {
    std::array<std::uint64_t, 2> bits;
    std::memcpy(bits.data(), pixel.meterPerPixel.data(), sizeof(bits));
    changed[0] |= bits[0] ^ first[0];
    changed[1] |= bits[1] ^ first[1];
  }
  return (changed[0] | changed[1]) == 0;
}

Eigen::Matrix<double, 2, 3> secondOrderOfLens(const std::vector<FitPixel> &pixels)
{
  Eigen::Matrix<double, 2, 3> lens = Eigen::Matrix<double, 2, 3>::Zero();
  if (isUniform(pixels)) {
    return lens;
  }
  constexpr std::size_t enough = 256;
  const std::size_t stride = pixels.size() / enough + 1;
  double count = 0.;
  Eigen::Vector2d meter = Eigen::Vector2d::Zero();
  Eigen::Vector4d derivative = Eigen::Vector4d::Zero();
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
  Eigen::Matrix<double, 4, 2> products = Eigen::Matrix<double, 4, 2>::Zero();
  for (std::size_t i = 0; i < pixels.size(); i += stride) {
    const ModelPixel pixel = pixels[i].model();
    const Eigen::Vector2d place = pixel.meter - pixels.front().meter.cast<double>();
    const Eigen::Map<const Eigen::Vector4d> entries(pixel.meterPerPixel.data());
    count += 1.;
    meter += place;
    derivative += entries;
    squares += place * place.transpose();
    products += entries * place.transpose();
  }
  squares -= meter * meter.transpose() / count;
  products -= derivative * meter.transpose() / count;
  derivative /= count;
  const Eigen::Map<const Eigen::Matrix2d> pixel(derivative.data());
  const Eigen::Matrix<double, 4, 2> byPixel = products * squares.inverse() * pixel;
  const Eigen::Map<const Eigen::Matrix2d> byU(byPixel.col(0).data());
  const Eigen::Map<const Eigen::Matrix2d> byV(byPixel.col(1).data());
  const Eigen::Matrix2d inverse = pixel.inverse();
  const Eigen::Matrix2d alongU = inverse * byU;
  const Eigen::Matrix2d alongV = inverse * byV;
  lens << alongU.col(0), 0.5 * (alongU.col(1) + alongV.col(0)), alongV.col(1);
  if (!lens.allFinite()) {
    lens.setZero();
  }
  return lens;
}
} // namespace circle_marker
END_VISP_NAMESPACE
