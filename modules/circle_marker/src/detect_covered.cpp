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
 * A marker of an outline, whole or with something in front of a part of it.
 */

#include "detect_covered.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "decode/covered_reading.h"
#include "decode/word_evidence.h"
#include "outer_edge.h"
#include "refine/fit_starts.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Odds, ln, by which the ring alone tells its pose from the twin: at a twin what covers the code and the code itself
// change places.
constexpr double hopelessOdds = 10.;

// Share of the pixels that show one sector alone that are what a codeword with corrections makes them, at least: where
// nothing covers the marker all are, where a sector is dirty or covered nine tenths.
constexpr double leastExplained = 0.6;
// And of a codeword without corrections, in whatever light: half of a marker may lie in a shadow.
constexpr double leastExplainedInAnyLight = 0.3;

// Share from which nothing covers it: three corrected sectors of 23 leave that.
constexpr double wholeExplained = 0.87;

// A fit to a whole marker leaves this much of the image's noise and of the contrast at most, standard deviation, or
// something else is in it.
constexpr double mostNoiseOfWhole = 1.5;
constexpr double mostLackingOfWhole = 0.03;
// A fit that correlates with the image by less than this has most of its residuals from noise, which is known to some
// hundredths: what it leaves is then no more than this factor above the image's.
constexpr double correlationOfPrint = 0.95;
constexpr double mostNoiseAlone = 1.2;

// And this share of its pixels are what the model makes them. Where fewer are, the others may be the code: of a golay23
// that was read as another at its mirrored pose 0.7 were, and the ring's fit was perfect. Of right ones it is mostly
// 0.85 and more, but in drawings without noise, where those left out are off by little, it may be less: so it is no
// verdict, and another reading is asked.
constexpr double leastInliersOfWhole = 0.8;

// A shadow that leaves more of the light than this is none: that of a fit that wanted none has ended so.
constexpr double mostOfShadow = 0.95;

// Another code shows: of a whole marker this share of the track's pixels is ink or paper in plain sight where its own
// has the other, besides a sector for each that was corrected. (Of 260 right ones without a correction that were asked
// the most was 0.026, by private counts.)
constexpr double leastOtherOfWhole = 0.03;
// Of a covered one, this share is ink, or this of either. A cover like paper looks like white sectors, one like ink
// hides gap and centre as well, and few are like both. (Of 2115 right ones the most was 0.032 and 0.003.)
constexpr double leastInkOfCovered = 0.035;
constexpr double leastEitherOfCovered = 0.004;
// A whole marker of which more pixels than this share are explained is not asked unless a sector was corrected.
constexpr double inliersOfCertain = 0.88;

// What covers the track where nearly all of this share of the ring is seen lies in one piece or two. A print with other
// sectors has it in so many and more, and of the pixels that show one sector alone less than this share is explained.
// (By private counts: of 24 golay23, bch31 and bch31r that were read as covered ones of another family the most was
// 0.763; of 11 right ones, of 785 that were covered, ten had 0.79 and more.)
constexpr double nearlyWholeRing = 0.94;
constexpr unsigned int scatteredPieces = 3;
constexpr double leastExplainedOfScattered = 0.78;

// Capacity, sectors, of the codes by which that was told, golay23 and bch31: of all words of 23 sectors 13.5 % lie
// within two of a codeword. Of the 31 of bch31r, whose capacity is five, 3.5 % lie within four; so more may be like
// paper.
constexpr unsigned int usualCapacity = 3;

// Of a ring that nothing covers this share is seen: here and there noise hides a direction.
constexpr double wholeRing = 0.97;

// Where the blur leaves no pixel that shows one sector alone, the fit has to tell, and leaves no more than this share
// of the contrast besides noise; of a ring with teeth, which are no code, it left 0.12.
constexpr double mostLackingOfBlurred = 0.08;

// Most that the model may leave of a marker with corrected sectors, standard deviation, share of the contrast: noise of
// 20 grey levels on a contrast of 170. A codeword that was read at a wrong pose leaves more.
constexpr double mostNoiseOfCorrected = 0.12;

// Of words that are farther than the code can correct most are near to some codeword.
unsigned int mostCorrected(const vpCircleMarkerFamily &family, unsigned int maximumHamming)
{
  return std::min(maximumHamming, codeOf(family).getCapacity());
}

// What the track of a measured marker shows that its codeword has not.
OtherColours otherColoursOf(const vpImage<unsigned char> &I, const CameraModel &camera, const Recognition &marker,
                            const Measurement &measurement, MeasureMemory &memory)
{
  const TrackPixels pixels(I, camera, ringOf(measurement, marker.poses[0], camera), marker.family, memory.track);
  WordEvidence evidence(pixels);
  evidence.turnTo(0.);
  return evidence.otherColours(marker.family.getCodeword(marker.code.id));
}

// Whether a code corrects so many sectors that it tells by itself: of 1958 golay23 one was read as bch31r (private),
// and of 60 bch31r behind a blob over half of the disc one more was lost to what tells the others.
bool isStrong(const vpCircleMarkerFamily &family)
{
  return codeOf(family).getCapacity() > usualCapacity;
}

// Whether what is taken for covered is sectors of another print.
bool isOtherPrint(const vpImage<unsigned char> &I, const CameraModel &camera, const Recognition &marker,
                  const Measurement &measurement, MeasureMemory &memory)
{
  if (isStrong(marker.family) || !marker.seen || marker.seen->shareOfRing() < nearlyWholeRing ||
      marker.seen->piecesNotSeen() < scatteredPieces) {
    return false;
  }
  TrackPixels pixels(I, camera, ringOf(measurement, marker.poses[0], camera), marker.family, memory.track);
  pixels.turnTo(0.);
  const CodewordVerdict verdict = pixels.judge(marker.family.getCodeword(marker.code.id));
  return verdict.explained < leastExplainedOfScattered * verdict.all;
}

// What makes a whole marker's reading or fit doubtful.
struct Doubts
{
  bool isCorrected = false;   // sectors were: they show something else than the codeword
  bool isNoisy = false;       // the fit leaves far more than noise
  bool isFaint = false;       // it correlates by less than a print does but for noise
  bool isPartMissing = false; // of the outline
  bool isPartLeftOut = false; // of the pixels, which are not what the model makes them
  bool isShaded = false;      // the edge of a shadow is on it: the track's pixels there say less
  double contrast = 0.;       // grey levels

  bool isPartLeftOutOnly() const { return isPartLeftOut && !isCorrected && !isNoisy && !isPartMissing; }
};

Doubts doubtsOf(double noise, double support, const Recognition &marker, const FittedPose &fit)
{
  Doubts doubts;
  doubts.contrast = fit.photometry.tellableContrast();
  doubts.isCorrected = marker.code.hamming > 0;
  doubts.isNoisy = fit.noise > mostNoiseOfWhole * noise + mostLackingOfWhole * doubts.contrast;
  doubts.isFaint = fit.correlation < correlationOfPrint;
  doubts.isPartMissing = isPartMissing(support);
  doubts.isPartLeftOut = fit.inliers < leastInliersOfWhole;
  doubts.isShaded = fit.photometry.shadow && fit.photometry.shadow->factor < mostOfShadow;
  return doubts;
}

// What the fit alone says; nothing if the pixels have to be asked.
std::optional<WholeVerdict> verdictByFit(const Doubts &doubts, double noise, const FittedPose &fit)
{
  // What shadows leave of the code is not asked if the fit explains it.
  if (doubts.isShaded && !doubts.isCorrected && !doubts.isNoisy && !doubts.isPartLeftOut) {
    return WholeVerdict::RIGHT;
  }
  // A faint print leaves noise alone. One that leaves far more may be covered, which its pixels tell.
  if (!doubts.isNoisy && doubts.isFaint && fit.noise > mostNoiseAlone * noise) {
    return WholeVerdict::WRONG;
  }
  if (!doubts.isCorrected && !doubts.isNoisy && !doubts.isPartMissing && !doubts.isPartLeftOut) {
    return WholeVerdict::RIGHT;
  }
  return std::nullopt;
}

// What the pixels of the track, at the measured pose, say of the codeword.
WholeVerdict verdictByPixels(const Doubts &doubts, double noise, const FittedPose &fit, const TrackPixels &pixels,
                             CyclicCode::Word word)
{
  const CodewordVerdict verdict = pixels.judge(word);
  const bool noneShowsOne = verdict.all <= 0.; // sector alone
  const bool isTooNoisy = doubts.isCorrected && !doubts.isShaded && fit.noise > mostNoiseOfCorrected * doubts.contrast;
  const bool isBlurred = noneShowsOne && fit.noise > std::hypot(noise, mostLackingOfBlurred * doubts.contrast);
  const double least = doubts.isCorrected ? leastExplained : leastExplainedInAnyLight;
  if (isTooNoisy || isBlurred || verdict.explained < least * verdict.all) {
    return WholeVerdict::WRONG;
  }
  // Pixels that may be off by as much as such a fit leaves say little against it; and none that shows one sector alone,
  // nothing against one that was corrected.
  const bool isBlind =
      (doubts.isNoisy && (doubts.isFaint || doubts.isPartMissing)) || (doubts.isCorrected && noneShowsOne);
  const bool isWhole = !isBlind && verdict.explained >= wholeExplained * verdict.all &&
                       (!doubts.isCorrected || !pixels.hasCoverLikePrint());
  return isWhole ? WholeVerdict::RIGHT : WholeVerdict::COVERED;
}
} // namespace

std::optional<Recognition> recogniseByMeasuredRing(const vpImage<unsigned char> &I, const CameraModel &camera,
                                                   const Recognition &ring, const vpCircleMarkerFamily &family,
                                                   const DecodeSettings &settings, MeasureMemory &memory,
                                                   const Deadline &deadline, const ImageNoise &noise)
{
  const auto measurement = measure(I, camera, ring, true, memory, deadline, noise);
  if (!measurement) {
    return std::nullopt;
  }
  const MeasuredRing first = ringOf(*measurement, ring.poses[0], camera);
  const bool hasTwin = measurement->second && measurement->cost2 - measurement->cost < hopelessOdds;
  const auto twin = hasTwin ? std::make_optional(ringOf(*measurement, ring.poses[0], camera, false)) : std::nullopt;
  Judged<Recognition> marker = recogniseCovered(I, camera, first, twin, family, settings, memory.track, deadline);
  if (!marker) {
    return std::nullopt;
  }
  if (!twin) { // with the code it may be the right one after all
    marker->poses[1] = mirrored(marker->poses[0]);
  }
  return std::move(*marker);
}

WholeVerdict judgeWhole(const vpImage<unsigned char> &I, const CameraModel &camera, double noise, double support,
                        const Recognition &marker, const Measurement &measurement, MeasureMemory &memory)
{
  if (!marker.family.isCoded() || marker.seen || marker.blurred) {
    return WholeVerdict::RIGHT;
  }
  const Doubts doubts = doubtsOf(noise, support, marker, measurement.first);
  if (const auto verdict = verdictByFit(doubts, noise, measurement.first)) {
    return *verdict;
  }
  const MeasuredRing ring = ringOf(measurement, marker.poses[0], camera);
  TrackPixels pixels(I, camera, ring, marker.family, memory.track);
  pixels.turnTo(0.);
  const CyclicCode::Word word = marker.family.getCodeword(marker.code.id);
  WholeVerdict verdict = verdictByPixels(doubts, noise, measurement.first, pixels, word);
  // Where outline and pixels are missing, what covers a part of the code may be like paper: it has to be the likeliest.
  const bool isHalfSeen = doubts.isPartMissing && doubts.isPartLeftOut;
  if (verdict == WholeVerdict::RIGHT && isHalfSeen && !isLikeliest(pixels, word, marker.family)) {
    verdict = WholeVerdict::COVERED;
  }
  return verdict == WholeVerdict::COVERED && doubts.isPartLeftOutOnly() ? WholeVerdict::DOUBTFUL : verdict;
}

bool isRightThoughCovered(const vpImage<unsigned char> &I, const CameraModel &camera, const Recognition &marker,
                          const Measurement &measurement, WholeVerdict verdict, MeasureMemory &memory)
{
  // One with corrected sectors whose other pixels are not explained, which cannot be read as a covered one and of which
  // nothing covers a part, is another print: so were markers of another family.
  if (marker.code.hamming > 0 && !isStrong(marker.family) &&
      !withoutWhatCovers(I, camera, marker, measurement, memory)) {
    return false;
  }
  // That no sector had to be corrected proves nothing of a covered one: a bar like paper over black sectors may leave
  // another codeword, and an image that is like it but for the bar.
  const bool isLikeIt = measurement.first.correlation >= correlationOfPrint && !measurement.first.photometry.shadow;
  if (verdict == WholeVerdict::DOUBTFUL && isLikeIt) {
    return true;
  }
  const TrackPixels pixels(I, camera, ringOf(measurement, marker.poses[0], camera), marker.family, memory.track);
  return isLikeliest(pixels, marker.family.getCodeword(marker.code.id), marker.family);
}

bool showsOtherCode(const vpImage<unsigned char> &I, const CameraModel &camera, Recognition &marker,
                    const Measurement &measurement, unsigned int maximumHamming, MeasureMemory &memory)
{
  const bool isAsked = marker.seen || marker.code.hamming > 0 || measurement.first.inliers < inliersOfCertain;
  if (!marker.family.isCoded() || marker.blurred || !isAsked) {
    return false;
  }
  if (isOtherPrint(I, camera, marker, measurement, memory)) {
    return true;
  }
  const OtherColours other = otherColoursOf(I, camera, marker, measurement, memory);
  // Sectors that were corrected are another one in plain sight; of either colour half of them at most.
  const double sectors = marker.family.getNbSectors();
  const double corrected = marker.code.hamming / sectors;
  const double correctedOfEither = (marker.code.hamming / 2) / sectors;
  const unsigned int most = mostCorrected(marker.family, maximumHamming);
  if (!marker.seen) {
    return other.sectors > most || other.ink + other.paper > leastOtherOfWhole + corrected;
  }
  marker.code.hamming = std::max(marker.code.hamming, other.sectors);
  const unsigned int capacity = codeOf(marker.family).getCapacity();
  const unsigned int inProportion = (most * capacity + usualCapacity - 1) / usualCapacity;
  return marker.code.hamming > std::min(inProportion, capacity) || other.ink > leastInkOfCovered + corrected ||
         std::min(other.ink, other.paper) > leastEitherOfCovered + correctedOfEither;
}

std::optional<Recognition> withoutWhatCovers(const vpImage<unsigned char> &I, const CameraModel &camera,
                                             const Recognition &marker, const Measurement &measurement,
                                             MeasureMemory &memory)
{
  if (!marker.family.isCoded() || marker.seen || marker.blurred) {
    return std::nullopt;
  }
  const MarkerPlane &plane = measurement.first.plane;
  auto reading = readCoveredSectors(I, camera, plane, marker.family);
  if (!reading) {
    return std::nullopt;
  }
  Recognition covered = marker;
  covered.measuredRing = ringOf(measurement, marker.poses[0], camera);
  // A start: what is measured next begins with a flat sheet.
  covered.poses = {plane.flattened(), mirrored(plane.flattened())};
  TrackPixels pixels(I, camera, *covered.measuredRing, marker.family, memory.track);
  WordEvidence evidence(pixels);
  evidence.turnTo(0.);
  evidence.leaveOutUnexplained(marker.family.getCodeword(marker.code.id), reading->seen);
  covered.seen = reading->seen;
  return reading->seen.shareOfRing() < wholeRing ? std::make_optional(std::move(covered)) : std::nullopt;
}

void listAttempts(const std::vector<vpCircleMarkerFamily> &families, std::vector<Attempt> &attempts)
{
  attempts.clear();
  std::size_t k = 0;
  while (k < families.size()) {
    const std::size_t first = k;
    do {
      attempts.push_back({k++, ReadingKind::WHOLE});
    } while (k < families.size() && families[first].isCoded() && families[k].isCoded());
    for (const ReadingKind kind : {ReadingKind::UNCERTAIN, ReadingKind::COVERED}) {
      for (std::size_t coded = first; coded < k && families[coded].isCoded(); ++coded) {
        attempts.push_back({coded, kind});
      }
    }
  }
  for (k = 0; k < families.size(); ++k) {
    if (families[k].getType() == vpCircleMarkerFamily::RING) {
      attempts.push_back({k, ReadingKind::COVERED});
    }
  }
}
} // namespace circle_marker
END_VISP_NAMESPACE
