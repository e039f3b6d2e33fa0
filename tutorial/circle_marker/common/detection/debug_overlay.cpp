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
 * What the rooms of the detector saw, drawn over the image.
 */

#include "debug_overlay.h"

#include <algorithm>
#include <array>
#include <iomanip>
#include <map>
#include <sstream>

#include <visp3/core/vpImageConvert.h>

#include "../draw.h"
#include "marker_overlay.h"

namespace tutorial {
namespace {
using Reject = vpCircleMarkerReject;

// Light enough to be read on black.
const std::array<vpColor, 8> palette = {vpColor(255, 70, 70),   vpColor::green,        vpColor::cyan,
                                        vpColor::yellow,        vpColor(90, 150, 255), vpColor::orange,
                                        vpColor(210, 110, 255), vpColor(255, 150, 200)};

vpColor colorOf(Reject reason)
{
  return palette[static_cast<std::size_t>(reason) % palette.size()];
}

vpRGBa pixelOf(const vpColor &color)
{
  return vpRGBa(color.R, color.G, color.B);
}

/*! The image in weak grey, so that what is drawn stands out. */
vpImage<vpRGBa> ground(const vpImage<unsigned char> &I)
{
  vpImage<unsigned char> weak(I.getHeight(), I.getWidth());
  std::transform(I.bitmap, I.bitmap + I.getSize(), weak.bitmap,
                 [](unsigned char grey) { return static_cast<unsigned char>(40 + grey / 2); });
  vpImage<vpRGBa> picture;
  vpImageConvert::convert(weak, picture);
  return picture;
}

void paint(vpImage<vpRGBa> &picture, const vpImagePoint &place, const vpRGBa &color)
{
  const double u = place.get_u() + 0.5;
  const double v = place.get_v() + 0.5;
  if (u >= 0. && v >= 0. && u < picture.getWidth() && v < picture.getHeight()) {
    picture[static_cast<unsigned int>(v)][static_cast<unsigned int>(u)] = color;
  }
}

void paint(vpImage<vpRGBa> &picture, const std::vector<vpImagePoint> &places, const vpColor &color)
{
  for (const vpImagePoint &place : places) {
    paint(picture, place, pixelOf(color));
  }
}

void write(vpImage<vpRGBa> &picture, const std::string &text, const vpImagePoint &place, const vpColor &color)
{
  static const vpFont font(16, vpFont::GENERIC_MONOSPACE);
  const vpImagePoint extent = font.getMeasure(text);
  const double u = std::max(0., std::min(place.get_u(), picture.getWidth() - extent.get_u() - 1.));
  const double v = std::max(0., std::min(place.get_v(), picture.getHeight() - extent.get_v() - 1.));
  font.drawText(picture, text, vpImagePoint(v, u), color, vpColor::black);
}

/*! Lines of text from the picture's upper left corner down. */
class Legend
{
public:
  explicit Legend(vpImage<vpRGBa> &picture) : m_picture(picture) {}

  void add(const std::string &text, const vpColor &color)
  {
    write(m_picture, text, vpImagePoint(m_line, 4.), color);
    m_line += 18.;
  }

private:
  vpImage<vpRGBa> &m_picture;
  double m_line = 2.; // pixels
};

void drawEllipse(vpImage<vpRGBa> &picture, const vpImageEllipse &ellipse, const vpColor &color)
{
  constexpr int corners = 72;
  std::vector<vpImagePoint> outline;
  for (int i = 0; i < corners; ++i) {
    const double x = ellipse.a * std::cos(2. * M_PI * i / corners);
    const double y = ellipse.b * std::sin(2. * M_PI * i / corners);
    const double c = std::cos(ellipse.angle);
    const double s = std::sin(ellipse.angle);
    outline.push_back(ellipse.center + vpImagePoint(s * x + c * y, c * x - s * y));
  }
  drawPath(picture, outline, color, 1, true);
}

// Where a chain could start and where it could go on.
vpImage<vpRGBa> segmentPicture(const vpImage<unsigned char> &I, const vpCircleMarkerDebug &debug, double pixel)
{
  vpImage<vpRGBa> picture = ground(I);
  std::array<std::string, 3> thresholds;
  for (const vpCircleMarkerDebug::Scale &scale : debug.scales) {
    if (scale.pixel != pixel) {
      continue;
    }
    const auto greyLevels = [](double step) {
      std::ostringstream text;
      text << std::fixed << std::setprecision(1) << step << " grey levels";
      return text.str();
    };
    thresholds = {"noise " + greyLevels(scale.noise), "an edge starts at a step of " + greyLevels(scale.leastStart),
                  "and goes on at " + greyLevels(scale.leastStep)};
    const auto side = static_cast<unsigned int>(scale.pixel);
    for (unsigned int v = 0; v < scale.edges.getHeight() * side; ++v) {
      for (unsigned int u = 0; u < scale.edges.getWidth() * side; ++u) {
        const unsigned char kind = scale.edges[v / side][u / side];
        if (kind > 0) {
          paint(picture, scale.origin + vpImagePoint(v, u), pixelOf(kind > 1 ? palette[0] : vpColor::orange));
        }
      }
    }
  }
  Legend legend(picture);
  legend.add(thresholds[0], vpColor::white);
  legend.add(thresholds[1], palette[0]);
  legend.add(thresholds[2], vpColor::orange);
  return picture;
}

// The chains, each in a colour.
vpImage<vpRGBa> edgesPicture(const vpImage<unsigned char> &I, const vpCircleMarkerDebug &debug, double pixel)
{
  vpImage<vpRGBa> picture = ground(I);
  std::size_t chains = 0;
  for (const vpCircleMarkerDebug::Scale &scale : debug.scales) {
    if (scale.pixel == pixel) {
      for (const std::vector<vpImagePoint> &chain : scale.chains) {
        paint(picture, chain, palette[chains++ % palette.size()]);
      }
    }
  }
  Legend(picture).add(std::to_string(chains) + " chains of edge pixels", vpColor::yellow);
  return picture;
}

// What was refused, coloured by the reason, and the outlines that were made.
vpImage<vpRGBa> ellipsesPicture(const vpImage<unsigned char> &I, const vpCircleMarkerDebug &debug)
{
  vpImage<vpRGBa> picture = ground(I);
  std::map<Reject, unsigned int> counts;
  std::size_t outlines = 0;
  for (const vpCircleMarkerCandidate &candidate : debug.candidates) {
    if (!candidate.isOutline) {
      ++counts[candidate.reason];
      paint(picture, candidate.points, colorOf(candidate.reason));
    }
  }
  const vpImagePoint *last = nullptr;
  for (const vpCircleMarkerCandidate &candidate : debug.candidates) {
    if (candidate.isOutline) {
      // An outline is there once for each family that it was tried as.
      outlines += last == nullptr || vpImagePoint::distance(*last, candidate.ellipse.center) > 0. ? 1 : 0;
      last = &candidate.ellipse.center;
      drawEllipse(picture, candidate.ellipse, vpColor::white);
    }
  }
  Legend legend(picture);
  legend.add(std::to_string(outlines) + " outlines", vpColor::white);
  for (const auto &[reason, count] : counts) {
    legend.add(std::to_string(count) + " " + vpCircleMarkerRejectName(reason), colorOf(reason));
  }
  return picture;
}

// The outlines with the sectors that were read and what became of them.
vpImage<vpRGBa> decodePicture(const vpImage<unsigned char> &I, const vpCircleMarkerDebug &debug)
{
  vpImage<vpRGBa> picture = ground(I);
  std::vector<std::pair<vpImagePoint, const vpCircleMarkerCandidate *>> texts;
  double lineInPlace = 0.; // further families' reasons for the same outline go below
  for (const vpCircleMarkerCandidate &candidate : debug.candidates) {
    if (!candidate.isOutline) {
      continue;
    }
    const vpColor color = candidate.reason == Reject::NONE ? vpColor::green : colorOf(candidate.reason);
    drawEllipse(picture, candidate.ellipse, color);
    for (const vpCircleMarkerCandidate::Sector &sector : candidate.sectors) {
      const double grey = 127.5 * (1. - sector.black);
      const vpColor read(static_cast<unsigned char>(grey), static_cast<unsigned char>(grey),
                         static_cast<unsigned char>(grey));
      for (int v = -1; v <= 1; ++v) {
        for (int u = -1; u <= 1; ++u) {
          paint(picture, sector.center + vpImagePoint(v, u), u == 0 && v == 0 ? pixelOf(color) : pixelOf(read));
        }
      }
    }
    const vpImagePoint place =
        candidate.ellipse.center + vpImagePoint(0.5 * candidate.ellipse.b, candidate.ellipse.a + 3.);
    const bool isAgain = !texts.empty() && texts.back().second->ellipse.center == candidate.ellipse.center;
    lineInPlace = isAgain ? lineInPlace + 17. : 0.;
    texts.emplace_back(place + vpImagePoint(lineInPlace, 0.), &candidate);
  }
  // Above all that is drawn; pieces of markers are many, and their colour says it.
  for (const auto &[place, candidate] : texts) {
    if (candidate->reason != Reject::INSIDE_OF_A_MARKER) {
      write(picture, candidate->getText(), place,
            candidate->reason == Reject::NONE ? vpColor::green : colorOf(candidate->reason));
    }
  }
  Legend(picture).add("pieces of markers", colorOf(Reject::INSIDE_OF_A_MARKER));
  return picture;
}
} // namespace

std::vector<RoomPicture> roomPictures(const vpImage<unsigned char> &I, const vpDetectorCircleMarker &detector,
                                      const vpCameraParameters &cam)
{
  const vpCircleMarkerDebug &debug = detector.getDebug();
  OverlayDetails details;
  details.secondPose = true;
  details.uncertainty = true;
  return {{"1-segment", segmentPicture(I, debug, 1.)},
          {"1-segment-half", segmentPicture(I, debug, 2.)},
          {"1-segment-quarter", segmentPicture(I, debug, 4.)},
          {"2-edges", edgesPicture(I, debug, 1.)},
          {"2-edges-half", edgesPicture(I, debug, 2.)},
          {"2-edges-quarter", edgesPicture(I, debug, 4.)},
          {"3-ellipses", ellipsesPicture(I, debug)},
          {"4-decode", decodePicture(I, debug)},
          {"5-poses", markerOverlay(I, detector.getDetections(), cam, details)}};
}

std::string candidateTable(const vpCircleMarkerDebug &debug)
{
  std::ostringstream table;
  table << std::fixed << std::setprecision(2)
        << "reason,family,u,v,semi_axis_a,semi_axis_b,angle,points,id,hamming,margin\n";
  for (const vpCircleMarkerCandidate &candidate : debug.candidates) {
    const bool hasEllipse = candidate.ellipse.a > 0.;
    const vpImagePoint place = hasEllipse || candidate.points.empty() ? candidate.ellipse.center
                                                                      : candidate.points[candidate.points.size() / 2];
    table << vpCircleMarkerRejectName(candidate.reason) << ","
          << (candidate.isOutline ? candidate.family.getName() : "") << "," << place.get_u() << "," << place.get_v()
          << ",";
    if (hasEllipse) {
      table << candidate.ellipse.a << "," << candidate.ellipse.b << "," << candidate.ellipse.angle;
    }
    else {
      table << ",,";
    }
    table << "," << candidate.points.size() << ",";
    if (candidate.id >= 0) {
      table << candidate.id << "," << candidate.hamming << "," << candidate.margin;
    }
    else {
      table << ",,";
    }
    table << "\n";
  }
  return table.str();
}
} // namespace tutorial
