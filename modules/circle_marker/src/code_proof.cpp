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
 * Whether the likeliest code of a measured marker is beyond doubt.
 */

#include "code_proof.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "decode/cyclic_code.h"
#include "support/sensor_range.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
// Least odds against the next codeword, ln: one in 10^8 is wrong, if the pose is right. Right ones that were read for
// certain have e^29 and more. The pose need not be right where the code was not read for certain: codes are compared at
// the pose that the likeliest has made of the image.
constexpr double leastOdds = 20.;
constexpr double leastOddsIfUncertain = 25.;
// And where the noise is more than this share of the contrast: there a wrong pose, too, leaves no more than the noise,
// and the odds are all that speaks for a code. That is so of codes with fewer check bits than this: of all words one in
// 2^11 is of golay23, but one in 2^15 of bch31. Of 78000 golay23 of 8 to 22 pixels that were found in any light four
// were read as others with odds of e^26 to e^32, of 40000 bch31 none. Some are left: of 78000 other golay23 that were
// found with these limits four, with odds of e^42 to e^64.
constexpr double leastOddsInNoise = 33.;
constexpr double muchNoise = 0.015;
// And up to these odds, ln, no more is left of them than chance allows (mostDeviations).
constexpr double clearOddsInNoise = 100.;
constexpr unsigned int fewChecks = 14;
// Residuals of the best codeword, in units of what noise and model leave. Beyond the other odds, ln, they may be more:
// of a track that is less than a pixel wide the model misses some hundredths of its contrast. And if the same code was
// read sector by sector, more again: the phases that are tried are then the coarsest of what is seen. (Of 1157 right
// ones that were not read for certain, 10 to 40 pixels in any light, two left more than 1.2 and one more than 1.3.
// Codes with a dark blob on them that were read as others left 1.25 to 1.6; one of a ring found by its dark line 2.9.)
constexpr double mostUnexplained = 1.2;
constexpr double mostUnexplainedIfClear = 1.3;
constexpr double mostUnexplainedIfRead = 2.;
// Where the whole measurement leaves no more than this factor of the noise, it is the comparison that is coarse: a code
// of 19 x 6 pixels left 1.46 of its track, but 0.95 times the noise; those with a blob on them 1.4 times and more.
constexpr double mostUnexplainedOfNoise = 1.6;
constexpr double noiseOnly = 1.1;
// What leaves more than this is not measured again: of 170 that were measured with another code first, none left more
// than 1.2 then.
constexpr double mostUnexplainedAtFirst = 1.6;
// Beyond these odds, ln, where the whole measurement leaves no more than this factor of the noise and this share of the
// contrast, what the best codeword leaves is the coarseness of the comparison: of markers of 200 to 400 pixels that are
// 8 to 14 wide, with odds of 2500 and more, it is 1.7 to 3.9. What is no marker had 34 at most in 40 frames of clutter.
// So much is left of nearly all pixels: noise is told from most of them, and a cover over a third of a code, which
// makes it look like another one, is none of these. (Such a one had 0.72 of the pixels, of right codes of few
// pixels 99 in 100 0.87 and more.)
constexpr double overwhelmingOdds = 1000.;
constexpr double noiseAlone = 1.2;
constexpr double lackingAlone = 0.005;
constexpr double leastInliersAlone = 0.85;
// ... and where sectors are shorter than this along the image's shorter axis, pixels, so that the comparison is as
// coarse: those of 8 to 14 pixels width are of 1.0 at most. Of longer ones it is sectors that contradict: rings with 3
// to 5 sectors of 31 or 23 of another colour than any codeword's, 20 to 34 pixels wide, were read as codes with odds of
// e^1160 to e^2060, and left 2.8 to 4.8 (private counts).
constexpr double mostSectorAlone = 1.1;
// At a wrong pose, too, one codeword is the best, by up to e^64; but it does not leave the image's noise alone. Of a
// right one no more is left than this factor, and this share of the contrast for what the model lacks: the higher its
// odds, ln, the more. (A golay23 of 9 pixels in a blur of 1.2 was read as another, with odds of e^35, where 1.4 times
// the noise was left.)
struct MostLeft
{
  double odds;    // up to these
  double noise;   // factor
  double lacking; // share of the contrast
};
constexpr std::array<MostLeft, 3> mostLeftByOdds = {{{25., 1.1, 0.003}, {60., 1.2, 0.003}, {150., 1.5, 0.005}}};
// A code that was not read for certain may have any odds where something covers a part of it: of it no more is left
// than this. All of the 1157 right ones left less; codes with a blob on them that were read as others, with odds of
// e^71 to e^375, mostly more.
constexpr MostLeft mostLeftIfUncertain = {HUGE_VAL, 1.2, 0.005};
// A code that was not read for certain and whose odds are not clear must not leave more than so many standard
// deviations of what noise leaves: of n pixels its root mean square is known to 1 / sqrt(2 n). In 18000 markers of 8 to
// 24 pixels two that were read as others had odds of e^27 and e^32 and left 4.4 more; of the right ones with such odds
// one in a hundred leaves 3.5 more. What the model lacks adds to that as noise does, by squares: simply added it
// allowed a golay23 of 14.6 pixels, read as another with odds of e^34.6, 6 standard deviations more.
constexpr double mostDeviations = 3.5;
// What is no marker, letters, rings of dots, a castle's window, may be near a codeword, but it is not what is printed:
// it leaves 4 % of its contrast and more besides noise, and correlates by less than 0.98. True markers do by that in
// noise of a twelfth of the contrast; then no more than the noise is left, to this factor, and the odds are clear.
constexpr double mostUnlike = 0.03;
constexpr double mostNoise = 1.3;
constexpr double mostNoiseIfFaint = 1.1;
// Where the sectors were read one by one without doubt, it may be more, in pictures that were compressed or moved;
// lettering that was read as a code left twice this share of its contrast.
constexpr double mostUnlikeIfCertain = 0.1;
constexpr double leastCorrelation = 0.97;

// Whether the likeliest code stands alone, and the whole measurement with it leaves noise alone.
bool isOverwhelming(const LikelyCode &code, const CodeToProve &what)
{
  const double most =
      noiseAlone * std::max(what.noise, quantisation) + lackingAlone * what.fit.photometry.tellableContrast();
  return code.odds > overwhelmingOdds && what.sector < mostSectorAlone && what.fit.noise < most &&
         what.fit.inliers > leastInliersAlone;
}

// Whether a fit leaves no more of the image than one of a print does: noise, and a share of the contrast.
bool leavesLittle(const FittedPose &fit, double noise, double share)
{
  return fit.photometry.contrast() < 1. + share &&
         fit.noise < mostNoise * std::max(noise, quantisation) + share * fit.photometry.tellableContrast();
}

// Whether odds are all that speaks for a code: it is one of many among all words, and the image is noisy.
bool isDenseInNoise(const CodeToProve &what)
{
  const CyclicCode &code = codeOf(what.family);
  return code.getLength() - code.getDimension() < fewChecks &&
         what.noise > muchNoise * what.fit.photometry.tellableContrast();
}

// Whether a fit on so many pixels leaves no more than one at the right pose, where a code has such odds.
bool isAtRightPose(const CodeToProve &what, double odds)
{
  const FittedPose &fit = what.fit;
  const double noise = std::max(what.noise, quantisation);
  const auto leavesUpTo = [&](const MostLeft &most) {
    const bool isDoubted = !what.isCertain && odds < (isDenseInNoise(what) ? clearOddsInNoise : clearOdds);
    const double byChance = 1. + mostDeviations / std::sqrt(2. * static_cast<double>(what.pixels) / fit.sharing);
    const double lacking = most.lacking * fit.photometry.tellableContrast();
    return isDoubted ? fit.noise < std::hypot(std::min(most.noise, byChance) * noise, lacking)
                     : fit.noise < most.noise * noise + lacking;
  };
  const auto most = std::find_if(mostLeftByOdds.begin(), mostLeftByOdds.end(),
                                 [odds](const MostLeft &some) { return odds < some.odds; });
  return (most == mostLeftByOdds.end() || leavesUpTo(*most)) && (what.isCertain || leavesUpTo(mostLeftIfUncertain));
}

// Odds that a code needs against the next one, ln.
double leastOddsOf(const CodeToProve &what)
{
  return what.isCertain ? leastOdds : isDenseInNoise(what) ? leastOddsInNoise : leastOddsIfUncertain;
}
} // namespace

bool leavesWhatPrintsLeave(const FittedPose &fit, double noise)
{
  return leavesLittle(fit, noise, mostUnlike);
}

bool isWorthMeasuring(const LikelyCode &code)
{
  return code.unexplained < mostUnexplainedAtFirst;
}

bool isProven(const LikelyCode &code, const CodeToProve &what)
{
  const bool isNoise = what.fit.noise < noiseOnly * std::max(what.noise, quantisation);
  const double mostLeft = code.odds < clearOdds ? mostUnexplained
                          : what.isCertain      ? mostUnexplainedIfRead
                          : isNoise             ? mostUnexplainedOfNoise
                                                : mostUnexplainedIfClear;
  const bool isExplained = code.unexplained < mostLeft || isOverwhelming(code, what);
  const bool isLikely = code.odds > leastOddsOf(what) && isExplained;
  const bool isFaint = code.odds > clearOdds && what.fit.noise < mostNoiseIfFaint * what.noise;
  const bool isAlike = what.fit.correlation > leastCorrelation || isFaint;
  const bool isPrint = what.isCertain ? leavesLittle(what.fit, what.noise, mostUnlikeIfCertain)
                                      : leavesLittle(what.fit, what.noise, mostUnlike) && isAlike;
  return isLikely && isAtRightPose(what, code.odds) && isPrint;
}
} // namespace circle_marker
END_VISP_NAMESPACE
