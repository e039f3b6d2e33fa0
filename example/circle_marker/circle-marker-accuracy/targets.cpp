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
 * The targets of the project, judged on the records.
 */

#include <cmath>
#include <iterator>
#include <limits>

#include "parts.h"
#include "ranges.h"
#include "tables.h"

namespace accuracy {
namespace {
constexpr double infinity = std::numeric_limits<double>::infinity();
// A figure over fewer images says nothing. Where more were made, and fewer found, its target is missed: what is not
// found is not measured.
constexpr std::size_t leastImages = 5;

// Degrees of freedom, for the standard error of a mean of chi-squared over them: 5 or 6.
constexpr double leastDof = 5.;
// Standard error of the 95 % quantile of chi-squared (5 degrees of freedom) over that quantile, of one image:
// sqrt(0.05 * 0.95) / (density there, 0.0193) / 11.07.
constexpr double quantileError = 1.02;

double root(std::size_t count)
{
  return std::sqrt(static_cast<double>(count));
}

/*! Standard error of a share of so many; of none or all, that of one. */
double shareError(std::size_t part, std::size_t whole)
{
  const double count = static_cast<double>(whole);
  const double p = std::fmin(std::fmax(static_cast<double>(part), 1.), std::fmax(count - 1., 1.)) / count;
  return std::sqrt(p * (1. - p) / count);
}

double share(std::size_t part, std::size_t whole)
{
  return static_cast<double>(part) / static_cast<double>(whole);
}

/*! A figure; none over too few images. */
double figureOf(double value, std::size_t images)
{
  return images < leastImages ? std::numeric_limits<double>::quiet_NaN() : value;
}

void addRatios(const Summary &s, const std::string &where, double most, std::vector<Check> &checks)
{
  for (int q = 0; q < QUANTITIES; ++q) {
    checks.push_back({std::string("RMS / bound, ") + quantityNames[q], where, figureOf(s.ratio[q], s.right), -infinity,
                      most, s.right, s.ratio[q] * s.ratioError()});
  }
}

void addBiases(const Summary &s, const std::string &where, std::vector<Check> &checks)
{
  for (int q = 0; q < QUANTITIES; ++q) {
    checks.push_back({std::string("|bias| / sigma, ") + quantityNames[q], where,
                      figureOf(std::fabs(s.bias[q]), s.right), -infinity, 0.2, s.right, s.ratio[q] / root(s.right)});
  }
}

void addHonesty(const Summary &s, const std::string &where, std::vector<Check> &checks)
{
  checks.push_back({"mean of Mahalanobis^2 / dof", where, figureOf(s.mahalanobis, s.right), 0.9, 1.15, s.right,
                    std::sqrt(2. / leastDof) / root(s.right)});
  checks.push_back({"95 % of Mahalanobis^2 / chi^2's", where, figureOf(s.mahalanobis95, s.right), 0.85, 1.15, s.right,
                    quantileError / root(s.right)});
}

void addLimits(const Records &limits, std::vector<Check> &checks)
{
  for (const char *family : families) {
    const Records all = chosen(limits, inGroup(family));
    for (const Range &octave : octaveRanges()) {
      const Records here = chosen(all, octave.filter);
      const double mostRatios[] = {1.15, 1.5};
      for (std::size_t i = 0; i < 2; ++i) {
        const Range minor = minorRanges()[i];
        const Summary s = summaryOf(chosen(here, minor.filter));
        if (s.frames >= leastImages) {
          addRatios(s, std::string(family) + ", " + octave.name + ", " + minor.name, mostRatios[i], checks);
        }
      }
      const Summary s = summaryOf(chosen(here, minorRanges()[0].filter));
      if (s.frames >= leastImages) {
        addBiases(s, std::string(family) + ", " + octave.name + ", " + minorRanges()[0].name, checks);
        addHonesty(s, std::string(family) + ", " + octave.name + ", " + minorRanges()[0].name, checks);
      }
    }
    const Summary s = summaryOf(all);
    if (s.found >= leastImages) {
      checks.push_back({"wrong solutions / predicted", family, static_cast<double>(s.wrong) / s.predicted, -infinity,
                        1.3, s.found, root(s.wrong) / s.predicted});
      const Summary apart = summaryOf(chosen(all, [](const Record &r) { return !(r.separation < 7.); }));
      checks.push_back({"wrong solutions beyond 7 sigma", family, share(apart.wrong, apart.found), -infinity, 0.001,
                        apart.found, shareError(apart.wrong, apart.found)});
    }
  }
}

void addDistances(const Records &limits, std::vector<Check> &checks)
{
  const double mostWrong[] = {1., 0.001, 0.01, 0.05};
  for (std::size_t i = 0; i < std::size(distanceCells); ++i) {
    const Records here = chosen(limits, inGroup(distanceCells[i].name));
    const Summary s = summaryOf(here);
    if (s.found < leastImages) {
      continue;
    }
    if (distanceCells[i].mostTilt == 0.) {
      const Summary all = summaryOf(withoutMirror(here));
      checks.push_back({"normal RMS, degrees", distanceCells[i].name, all.rms[NORMAL], -infinity, 1.9, all.right,
                        all.rms[NORMAL] * all.ratioError()});
    }
    else {
      checks.push_back({"wrong solutions", distanceCells[i].name, share(s.wrong, s.found), -infinity, mostWrong[i],
                        s.found, shareError(s.wrong, s.found)});
    }
  }
  for (const Calibration &bin : calibrationOf(limits)) {
    if (bin.from == 0.95 && bin.frames >= leastImages) {
      checks.push_back({"right of those reported at 95-99 %", "limits", share(bin.right, bin.frames), 0.93, 0.995,
                        bin.frames, shareError(bin.right, bin.frames)});
    }
  }
}

void addModel(const Records &model, std::vector<Check> &checks)
{
  for (const Factor &factor : factors()) {
    const Summary s = summaryOf(chosen(model, inGroup(factor.name)));
    const std::string name = factor.name;
    if (s.frames < leastImages) {
      continue;
    }
    if (name.rfind("gamma", 0) == 0 || name.rfind("ink", 0) == 0) {
      checks.push_back({"|bias of z|, per cent", name, figureOf(std::fabs(s.depthBias), s.right), -infinity, 0.1,
                        s.right, s.depthSpread / root(s.right)});
    }
    if (name.find(" off") != std::string::npos) {
      continue; // What a wrong calibration does to a pose no image tells: the detector has to be told.
    }
    for (int q = 0; q < QUANTITIES; ++q) {
      checks.push_back({std::string("RMS / reported sigma, ") + quantityNames[q], name,
                        figureOf(s.optimism[q], s.right), -infinity, 2., s.right, s.optimism[q] * s.ratioError()});
    }
  }
}

void addCells(const Records &cells, std::vector<Check> &checks)
{
  for (const char *family : thesisFamilies) {
    for (const ThesisCell &cell : thesisCells) {
      const std::string name = std::string(family) + " " + nameOf(cell);
      const Summary s = summaryOf(chosen(cells, inGroup(name)));
      if (s.frames >= leastImages && familyOf(family).isCoded()) {
        checks.push_back({"found", name, share(s.found, s.frames), cell.leastFound, infinity, s.frames,
                          shareError(s.found, s.frames)});
      }
      if (s.found >= leastImages) {
        checks.push_back({"mean |C-eC|, mm", name, s.position, -infinity, cell.meanError, s.found,
                          s.positionSpread / root(s.found)});
        checks.push_back({"mean normal, degrees", name, s.normal, -infinity, cell.meanNormal, s.found,
                          s.normalSpread / root(s.found)});
      }
    }
  }
}

void addTags(const Records &tags, std::vector<Check> &checks)
{
  for (std::size_t octave = 1; octave < octaves.size(); ++octave) {
    const Records here = commonImages(chosen(tags, inGroup("octave " + std::to_string(octave))));
    const Summary circle = summaryOf(chosen(here, byMethod("circle")));
    if (circle.frames < leastImages) {
      continue;
    }
    const Summary tag[] = {summaryOf(chosen(here, byMethod("apriltag-1"))),
                           summaryOf(chosen(here, byMethod("apriltag-2")))};
    const auto add = [&](const std::string &name, double ours, double first, double second) {
      checks.push_back({"RMS of circle / AprilTag, " + name, octaveRanges()[octave - 1].name,
                        figureOf(ours / std::fmin(first, second), circle.right), -infinity, 0.2, circle.right,
                        ours / std::fmin(first, second) / root(circle.right)});
    };
    for (int q = X; q <= Z; ++q) {
      add(quantityNames[q], circle.rms[q], tag[0].rms[q], tag[1].rms[q]);
    }
    add("rotation", circle.rotation, tag[0].rotation, tag[1].rotation);
  }
}
} // namespace

std::vector<Check> checksOf(const Records &records)
{
  std::vector<Check> checks;
  const Records limits = chosen(records, inPart("limits"));
  addLimits(limits, checks);
  addDistances(limits, checks);
  addModel(chosen(records, inPart("model")), checks);
  addCells(chosen(records, inPart("cells")), checks);
  addTags(chosen(records, inPart("apriltag")), checks);
  return checks;
}
} // namespace accuracy
