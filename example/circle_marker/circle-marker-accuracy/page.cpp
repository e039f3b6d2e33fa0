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
 * The report page: what is measured, how, the plots, the tables.
 */

#include <filesystem>

#include "common/document.h"
#include "common/files.h"
#include "plots.h"
#include "report.h"

namespace accuracy {
namespace {
using common::Document;

std::string joined(const std::vector<std::string> &lines)
{
  std::string text;
  for (const std::string &line : lines) {
    text += (text.empty() ? "" : "; ") + line;
  }
  return text;
}

void addIntroduction(const std::vector<std::string> &comments, Document &document)
{
  document.addParagraph(
      "How near the poses of vpDetectorCircleMarker are to what the noise of an image allows. Every figure is made by "
      "circle-marker-accuracy on the simulated camera, which shares no code with the detector; every error is divided "
      "by the Cramer-Rao bound of its own pose (vpMarkerPoseBound): 1 is the limit of all unbiased methods that know "
      "nothing of what lies beyond the quiet zone.");
  document.addListing("build/bin/circle-marker-accuracy --output results --frames N --page doc/accuracy\n"
                      "build/bin/circle-marker-accuracy --from results --page doc/accuracy   # the page alone, anew");
  document.addParagraph("These results: " + joined(comments) + ".");
  document.addParagraph(
      "Poses: a marker of 180 mm anywhere in an image of 1280 x 960 pixels (f = 1600), seen in a window of 640 x 480 "
      "that "
      "holds it; image diameter 17 to 400 pixels (even in its logarithm), tilt 8 to 75 degrees, noise 1 to 5 grey "
      "levels, blur 0.5 to 1.2 pixels, contrast 60 to 190, on a sheet with a quiet zone of R/6 before an even ground "
      "of "
      "any grey. The bound's unknowns are the pose, both levels and the blur; what lies beyond the quiet zone is "
      "unknown to it unless stated otherwise, and the rounding to 8 bits counts as noise. The plain ring has the ratio "
      "0.7, which the detector is told.");
  document.addParagraph(
      "Two sources of error are kept apart. Images in which the mirrored pose comes first are counted (wrong) beside "
      "the number that the bound predicts, the sum of Phi(-separation / 2), and left out of all errors against the "
      "bound. Bias is the mean of error over bound; its own standard error is 1 / sqrt(images), that of a ratio 1 / "
      "sqrt(2 images). Maha²: squared Mahalanobis distance of the error by the covariance that the detector reports; "
      "95 %: its quantile over that of the chi-squared distribution. Under the targets, a figure is beyond chance "
      "where "
      "it misses by more than two of its standard errors.");
}
} // namespace

void writePage(const std::string &folder, const std::vector<std::string> &comments, const Records &records,
               const std::vector<Table> &tables)
{
  const std::vector<common::Figure> figures = figuresOf(records);
  Document document("Accuracy");
  addIntroduction(comments, document);
  document.addHeading("Against the bound");
  for (const common::Figure &figure : figures) {
    document.addFigure(figure.file, figure.title);
  }
  document.addHeading("Tables");
  for (const Table &table : tables) {
    document.addTable(table.caption, table.titles, table.rows);
  }
  common::writeWhole(folder, "README.md", document.markdown());
  const std::string script = "plots.gp";
  common::writeWhole(folder, script, common::figureScript(figures));
  common::drawPlots(folder, script, common::filesOf(figures));
  std::filesystem::remove(std::filesystem::path(folder) / script); // It is the plots over again.
}
} // namespace accuracy
