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
 * Residuals of a calibration as a picture.
 */

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

#include "common/numbers.h"
#include "report.h"

namespace calibrate {
namespace {
constexpr double panelWidth = 640.; // Of the image's panel, units of the SVG.
constexpr double scatter = 300.;    // Side of the diagram's panel.
constexpr double margin = 40.;

std::string text(double x, double y, const std::string &words, const std::string &anchor = "start")
{
  std::ostringstream out;
  out << "<text x=\"" << x << "\" y=\"" << y << "\" text-anchor=\"" << anchor << "\">" << words << "</text>\n";
  return out.str();
}

/*! 1, 2 or 5 times a power of ten, not below a length. */
double roundLength(double length)
{
  const double power = std::pow(10., std::floor(std::log10(length)));
  for (const double factor : {1., 2., 5.}) {
    if (factor * power >= length) {
      return factor * power;
    }
  }
  return 10. * power;
}

/*! A hue for each view, far from those of its neighbours. */
std::string colorOf(std::size_t view)
{
  return "hsl(" + std::to_string((view * 137) % 360) + ",70%,40%)";
}

void addArrows(std::ostream &out, const Report &report, const ModelReport &model,
               const std::vector<std::vector<Eigen::Vector2d>> &residuals, double magnification)
{
  const double scale = panelWidth / report.width;
  for (std::size_t v = 0; v < residuals.size(); ++v) {
    out << "<g stroke=\"" << colorOf(v) << "\" fill=\"" << colorOf(v) << "\">\n";
    for (std::size_t i = 0; i < residuals[v].size(); ++i) {
      const Eigen::Vector2d from = scale * model.calibration.views[v].observations[i].pixel;
      const Eigen::Vector2d to = from + scale * magnification * residuals[v][i];
      out << "<circle cx=\"" << from.x() << "\" cy=\"" << from.y() << "\" r=\"1.3\" stroke=\"none\"/>"
          << "<line x1=\"" << from.x() << "\" y1=\"" << from.y() << "\" x2=\"" << to.x() << "\" y2=\"" << to.y()
          << "\"/>\n";
    }
    out << "</g>\n";
  }
}

void addScatter(std::ostream &out, const std::vector<std::vector<Eigen::Vector2d>> &residuals, double range)
{
  const double scale = 0.5 * scatter / range;
  out << "<rect width=\"" << scatter << "\" height=\"" << scatter << "\" class=\"frame\"/>\n"
      << "<path d=\"M 0 " << scatter / 2 << " H " << scatter << " M " << scatter / 2 << " 0 V " << scatter
      << "\" stroke=\"#bbb\"/>\n";
  for (std::size_t v = 0; v < residuals.size(); ++v) {
    for (const Eigen::Vector2d &r : residuals[v]) {
      out << "<circle cx=\"" << scatter / 2 + scale * r.x() << "\" cy=\"" << scatter / 2 + scale * r.y()
          << "\" r=\"1.6\" fill=\"" << colorOf(v) << "\"/>\n";
    }
  }
  out << text(0, scatter + 18, "-" + common::digits(range))
      << text(scatter, scatter + 18, common::digits(range) + " pixels", "end")
      << text(scatter / 2, scatter + 36, "seen minus computed, u to the right, v down", "middle");
}
} // namespace

std::string residualPicture(const Report &report)
{
  const double height = panelWidth * report.height / report.width;
  const double rowHeight = std::max(height, scatter) + 100.;
  const double width = panelWidth + scatter + 3. * margin;
  std::ostringstream out;
  out << std::setprecision(6);
  const double total = rowHeight * static_cast<double>(report.models.size()) + margin;
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width << "\" height=\"" << total << "\" viewBox=\"0 0 "
      << width << " " << total
      << "\">\n<style>text{font:14px sans-serif;fill:#222} .frame{fill:none;stroke:#444}</style>\n"
      << "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
  double top = margin;
  for (const ModelReport &model : report.models) {
    const auto residuals = residualsOf(report.target, model.calibration.views, model.calibration.adjustment);
    double greatest = 1e-6;
    for (const auto &view : residuals) {
      for (const Eigen::Vector2d &r : view) {
        greatest = std::max(greatest, r.cwiseAbs().maxCoeff());
      }
    }
    const double range = roundLength(greatest);
    // The greatest residual is then an arrow of a twentieth of the image's width at most.
    const double magnification = 0.05 * report.width / range;
    out << "<g transform=\"translate(" << margin << " " << top << ")\">\n"
        << text(0, 0,
                "model " + nameOf(model.model) + ", reprojection rms " +
                    common::digits(model.calibration.adjustment.rms()) + " pixels; arrows " +
                    common::digits(magnification) + " times enlarged, a colour for each view")
        << "<g transform=\"translate(0 20)\">\n<rect width=\"" << panelWidth << "\" height=\"" << height
        << "\" class=\"frame\"/>\n";
    addArrows(out, report, model, residuals, magnification);
    out << "</g>\n<g transform=\"translate(" << panelWidth + margin << " 20)\">\n";
    addScatter(out, residuals, range);
    out << "</g>\n</g>\n";
    top += rowHeight;
  }
  out << "</svg>\n";
  return out.str();
}
} // namespace calibrate
