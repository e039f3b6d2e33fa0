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
 * Identity and spin of a marker from its code track.
 */

#include "decode/identify.h"

#include "decode/cyclic_code.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Black and white sectors differ by this share of the ring's contrast at least: a golay23 track of 20 pixels outer
// diameter at 45 degrees keeps about a fifth after the blur between sectors is undone.
constexpr double leastContrast = 0.2;
// A track that is not made of sectors leaves more than this share of its own contrast unexplained.
constexpr double mostResidual = 0.25;

// Each corrected sector asks for more agreement of the others: the whole capacity of the code used costs this much.
// (Of the readings of 1025 photographs without a marker, none of 25 phantoms with two corrections passes 0.75; markers
// of 20 pixels and more are read without correction at 0.77 and better.)
constexpr double marginOfCapacity = 0.3;

double agreement(const SectorReading &reading, CyclicCode::Word codeword)
{
  double sum = 0.;
  for (unsigned int k = 0; k < reading.sectors; ++k) {
    const bool black = (codeword >> (reading.sectors - 1 - k)) & 1U;
    sum += black ? reading.soft[k] : -reading.soft[k];
  }
  return sum / reading.sectors;
}
} // namespace

Judged<CodeReading> identify(const SectorReading &reading, const vpCircleMarkerFamily &family,
                             const DecodeSettings &settings)
{
  if (reading.contrast < leastContrast || reading.residual > mostResidual * reading.contrast) {
    return vpCircleMarkerReject::NO_SECTORS;
  }
  CyclicCode::Word word = 0;
  for (unsigned int k = 0; k < reading.sectors; ++k) {
    word = (word << 1) | (reading.soft[k] > 0. ? 1U : 0U);
  }
  const CyclicCode &code = codeOf(family);
  const auto codeword = code.correct(word, settings.maximumHamming);
  if (!codeword) {
    return vpCircleMarkerReject::NO_CODEWORD;
  }
  const auto identity = code.identify(*codeword);
  if (!identity) {
    return vpCircleMarkerReject::NO_CODEWORD;
  }
  CodeReading result;
  result.id = identity->id;
  result.hamming = hammingDistance(word, *codeword);
  result.margin = agreement(reading, *codeword);
  result.spin = reading.phase + 2. * M_PI * identity->rotation / reading.sectors;
  const double corrected = static_cast<double>(result.hamming) / code.getCapacity();
  if (result.margin < settings.minimumMargin + marginOfCapacity * corrected) {
    return {vpCircleMarkerReject::LOW_MARGIN, result};
  }
  return result;
}
} // namespace circle_marker
END_VISP_NAMESPACE
