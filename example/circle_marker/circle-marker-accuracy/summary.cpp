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
 * Statistics over records: errors against the bound and against what was reported.
 */

#include <algorithm>
#include <cmath>

#include "common/statistics.h"
#include "summary.h"

namespace accuracy {
namespace {
// 95 % quantiles of the chi-squared distribution with 5 and 6 degrees of freedom.
constexpr double chiSquared5 = 11.0705;
constexpr double chiSquared6 = 12.5916;

struct QuantityOf
{
  double Record::*error;
  double Record::*signedError;
  double Record::*bound;
  double Record::*reported;
};

constexpr QuantityOf quantities[] = {
    {&Record::x, &Record::x, &Record::boundX, &Record::reportedX},
    {&Record::y, &Record::y, &Record::boundY, &Record::reportedY},
    {&Record::z, &Record::z, &Record::boundZ, &Record::reportedZ},
    {&Record::normal, &Record::lean, &Record::boundNormal, &Record::reportedNormal},
};

common::Statistics over(const Records &records, const std::function<double(const Record &)> &value)
{
  std::vector<double> values;
  for (const Record &record : records) {
    values.push_back(value(record));
  }
  return common::statisticsOf(values);
}

double probability(const Record &record)
{
  return 1. / (1. + std::exp(-record.logOdds));
}

// Mean length of a vector by its root mean square: that of one whose parts but one are nothing, and the least. What is
// expected at the bound is a mean over poses; of so many images another may come by chance, and of few that are
// expected to be mirrored a very different one.
const double meanOfRms = std::sqrt(2. / M_PI);

double positionAtBound(const Record &record)
{
  return meanOfRms *
         std::sqrt(record.boundX * record.boundX + record.boundY * record.boundY + record.boundZ * record.boundZ);
}

double normalAtBound(const Record &record)
{
  return (1. - record.predicted) * std::min(meanOfRms * record.boundNormal, record.tilt) +
         record.predicted * 2. * record.tilt;
}

void addErrors(const Records &right, Summary &summary)
{
  for (int q = 0; q < QUANTITIES; ++q) {
    const QuantityOf &quantity = quantities[q];
    const auto relative = over(right, [&](const Record &r) { return r.*quantity.error / r.*quantity.bound; });
    summary.rms[q] = over(right, [&](const Record &r) { return r.*quantity.error; }).rms;
    summary.ratio[q] = relative.rms;
    summary.worst[q] = std::max(std::fabs(relative.least), std::fabs(relative.most));
    summary.bias[q] = over(right, [&](const Record &r) { return r.*quantity.signedError / r.*quantity.bound; }).mean;
    summary.optimism[q] = over(right, [&](const Record &r) { return r.*quantity.error / r.*quantity.reported; }).rms;
  }
  constexpr double millimetres = 1000.;
  constexpr double perCent = 100.;
  const auto depth = over(right, [](const Record &r) { return perCent * r.z / (millimetres * r.distance); });
  summary.depthBias = depth.mean;
  summary.depthSpread = depth.sigma;
  summary.mahalanobis = over(right, [](const Record &r) { return r.mahalanobis / r.dof; }).mean;
  summary.mahalanobis95 =
      over(right, [](const Record &r) { return r.mahalanobis / (r.dof == 5. ? chiSquared5 : chiSquared6); }).p95;
  summary.rotation = over(right, [](const Record &r) { return r.rotation; }).rms;
}
} // namespace

Records chosen(const Records &records, const Filter &filter)
{
  Records result;
  std::copy_if(records.begin(), records.end(), std::back_inserter(result), filter);
  return result;
}

double Summary::ratioError() const
{
  return right > 0 ? 1. / std::sqrt(2. * static_cast<double>(right)) : none;
}

Summary summaryOf(const Records &records)
{
  const Records found = chosen(records, [](const Record &r) { return r.isFound(); });
  const Records right = chosen(found, [](const Record &r) { return !r.isWrong(); });
  Summary summary;
  summary.frames = records.size();
  summary.found = found.size();
  summary.right = right.size();
  summary.wrong = found.size() - right.size();
  for (const Record &record : found) {
    summary.predicted += record.predicted;
  }
  addErrors(right, summary);
  const auto position = over(found, [](const Record &r) { return std::sqrt(r.x * r.x + r.y * r.y + r.z * r.z); });
  const auto normal = over(found, [](const Record &r) { return r.normal; });
  summary.position = position.mean;
  summary.positionMedian = position.median;
  summary.normal = normal.mean;
  summary.normalMedian = normal.median;
  summary.positionBound = over(found, positionAtBound).mean;
  summary.normalBound = over(found, normalAtBound).mean;
  summary.positionSpread = position.sigma;
  summary.normalSpread = normal.sigma;
  summary.milliseconds = over(records, [](const Record &r) { return r.milliseconds; }).median;
  return summary;
}

std::vector<Calibration> calibrationOf(const Records &records)
{
  std::vector<Calibration> bins = {{0.5, 0.8}, {0.8, 0.95}, {0.95, 0.99}, {0.99, 1.}};
  for (Calibration &bin : bins) {
    const Records inside = chosen(records, [&bin](const Record &r) {
      return r.isFound() && !std::isnan(r.predicted) && probability(r) >= bin.from &&
             (probability(r) < bin.to || bin.to == 1.);
    });
    bin.frames = inside.size();
    bin.right = chosen(inside, [](const Record &r) { return !r.isWrong(); }).size();
    bin.reported = over(inside, probability).mean;
  }
  return bins;
}
} // namespace accuracy
