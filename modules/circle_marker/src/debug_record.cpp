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
 * Notes what the rooms of the detector see, to be looked at.
 */

#include "debug_record.h"

#include <algorithm>
#include <tuple>
#include <cmath>

BEGIN_VISP_NAMESPACE
namespace circle_marker {
namespace {
/*! From pixels of a scale to those of the image. */
struct ToImage
{
  vpImagePoint origin;
  double pixel;

  vpImagePoint operator()(const Eigen::Vector2d &p) const
  {
    // A pixel of the half covers two, and its centre lies between theirs; one of the quarter four.
    const double shift = 0.5 * (pixel - 1.);
    return origin + vpImagePoint(pixel * p.y() + shift, pixel * p.x() + shift);
  }

  vpImageEllipse operator()(const EllipseParameters &ellipse) const
  {
    vpImageEllipse result;
    result.center = (*this)(ellipse.center);
    result.a = pixel * ellipse.a;
    result.b = pixel * ellipse.b;
    result.angle = ellipse.angle;
    return result;
  }

  std::vector<vpImagePoint> operator()(const std::vector<EdgePoint> &points) const
  {
    std::vector<vpImagePoint> result;
    for (const EdgePoint &point : points) {
      result.push_back((*this)(point.position));
    }
    return result;
  }
};

void recordEdges(const Gradient &gradient, vpImage<unsigned char> &edges)
{
  const int start = gradient.startAt * gradient.startAt;
  const int least = gradient.continueAbove * gradient.continueAbove;
  edges.resize(static_cast<unsigned int>(gradient.height), static_cast<unsigned int>(gradient.width));
  std::transform(gradient.vectors.begin(), gradient.vectors.end(), edges.bitmap, [=](const GradientVector &vector) {
    const int squared = vector.squared();
    return static_cast<unsigned char>(squared >= start ? 2 : squared >= least ? 1 : 0);
  });
}

void recordScale(const OutlineMemory::Scale &memory, const ToImage &toImage, vpCircleMarkerDebug &debug)
{
  vpCircleMarkerDebug::Scale scale;
  scale.origin = toImage.origin;
  scale.pixel = toImage.pixel;
  scale.noise = memory.gradient.noise.sigma;
  scale.leastStart = memory.gradient.startAt / sobelStepGain;
  scale.leastStep = memory.gradient.continueAbove / sobelStepGain;
  recordEdges(memory.gradient, scale.edges);
  for (const EdgeChain &chain : memory.chains.chains) {
    scale.chains.emplace_back();
    for (std::size_t i = chain.begin; i < chain.end; ++i) {
      const EdgePixel pixel = memory.chains.pixels[i];
      scale.chains.back().push_back(toImage(Eigen::Vector2d(pixel.x, pixel.y)));
    }
  }
  debug.scales.push_back(std::move(scale));
  // In an order that does not depend on the threads, two of which may have had the same chain, as a whole and in
  // pieces.
  std::vector<const EllipseMemory::Refusal *> refusals;
  for (const EllipseMemory::Workspace &workspace : memory.ellipses.workspaces) {
    for (const EllipseMemory::Refusal &refusal : workspace.refusals) {
      refusals.push_back(&refusal);
    }
  }
  std::stable_sort(refusals.begin(), refusals.end(),
                   [](const EllipseMemory::Refusal *p, const EllipseMemory::Refusal *q) {
                     return std::make_tuple(p->chain, p->reason, p->points.size(), p->ellipse.a) <
                            std::make_tuple(q->chain, q->reason, q->points.size(), q->ellipse.a);
                   });
  for (const EllipseMemory::Refusal *refusal : refusals) {
    vpCircleMarkerCandidate candidate;
    candidate.reason = refusal->reason;
    candidate.ellipse = toImage(refusal->ellipse);
    candidate.points = toImage(refusal->points);
    debug.candidates.push_back(std::move(candidate));
  }
}
} // namespace

void recordOutlines(const OutlineMemory &memory, const vpImagePoint &origin, vpCircleMarkerDebug &debug)
{
  recordScale(memory.full, {origin, 1.}, debug);
  double pixel = 1.;
  for (const OutlineMemory::ReducedScale &scale : memory.reduced) {
    pixel *= 2.;
    if (scale.isUsed) {
      recordScale(scale, {origin, pixel}, debug);
    }
  }
}

vpCircleMarkerCandidate candidateOf(const EllipseCandidate &outline, const vpCircleMarkerFamily &family,
                                    vpCircleMarkerReject reason)
{
  const ToImage toImage = {vpImagePoint(0., 0.), 1.};
  vpCircleMarkerCandidate candidate;
  candidate.reason = reason;
  candidate.points = toImage(outline.points);
  candidate.ellipse = toImage(outline.ellipse);
  candidate.isOutline = true;
  candidate.family = family;
  return candidate;
}

void addReading(const ReadingTrace &trace, const vpCircleMarkerFamily &family, const CameraModel &camera,
                vpCircleMarkerCandidate &candidate)
{
  if (trace.sectors) {
    const vpCircleMarkerLayout &layout = family.getLayout();
    const double radius = 0.5 * (layout.codeInner + layout.codeOuter);
    for (unsigned int k = 0; k < trace.sectors->sectors; ++k) {
      const double angle = trace.sectors->phase + 2. * M_PI * (k + 0.5) / trace.sectors->sectors;
      const Eigen::Vector2d pixel =
          camera.toPixel(trace.plane.project(radius * Eigen::Vector2d(std::cos(angle), std::sin(angle))));
      candidate.sectors.push_back({vpImagePoint(pixel.y(), pixel.x()), trace.sectors->soft[k]});
    }
  }
  if (trace.code) {
    candidate.id = trace.code->id;
    candidate.hamming = trace.code->hamming;
    candidate.margin = trace.code->margin;
  }
}
} // namespace circle_marker
END_VISP_NAMESPACE
