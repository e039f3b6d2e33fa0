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
 * The sections of the report on experiments 2 and 3 and on the resilience.
 */

#include <cmath>
#include <sstream>

#include "common/numbers.h"
#include "common/reference_camera.h"
#include "cover.h"
#include "curves.h"
#include "report.h"
#include "report_tables.h"

namespace experiments {
namespace {
/*! How much of the outline goes with a share of the disc: more than the share itself. */
std::string outlineShares()
{
  std::string text;
  for (const double share : {0.05, 0.1, 0.2}) {
    text += (text.empty() ? "" : ", ") + digits(100. * share) + " % of the disc are " +
            digits(100. * std::acos(chordDistance(share)) / M_PI) + " % of its outline";
  }
  return text + ".";
}

const std::vector<View> thesisViews = {ringBoth, ringFirst, circle, bound};

/*! A table for each series: the thesis's figures beside those of its marker, of ours, and of the bound. */
void addComparisons(const Experiment &experiment, const RunData &data, Document &document)
{
  const std::vector<View> views = viewsIn(data, thesisViews);
  for (std::size_t i = 0; i < experiment.series.size(); ++i) {
    addComparison(experiment.series[i], data[i], views, document);
  }
}
} // namespace

void addConditions(const Settings &settings, Document &document)
{
  std::ostringstream text;
  text << "The thesis: J. Stork, Camera pose estimation with circular markers, University of Amsterdam, 2012. "
       << "Simulated camera of " << imageWidth << " x " << imageHeight << " pixels with a focal length of "
       << focalLength << " pixels (6 mm lens, pixels of 3.75 µm), noise " << settings.noise << " grey levels, blur "
       << settings.blur << " px (standard deviations), paper 220, ink 30, ground 110. "
       << "One marker of " << 1000. * settings.size << " mm outer diameter on a sheet of "
       << 1000. * settings.sheetSide() << " mm. Seed " << settings.seed << ". CPU times are of one thread.";
  document.addHeading("The simulated camera");
  document.addParagraph(text.str());
}

void addFigures(const std::vector<CaptionedFigure> &figures, Document &document)
{
  for (const CaptionedFigure &figure : figures) {
    document.addFigure(figure.figure.file, figure.caption);
  }
}

void addLines(const Experiment &experiment, const RunData &data, Document &document)
{
  document.addHeading(experiment.title);
  document.addParagraph(
      "Depth from 0.36 m in even steps along the optical axis and along four lines from its near end toward the "
      "image's corners; the normal is parallel to the optical axis, the spin about it random. The thesis's marker is "
      "the plain ring; of both its solutions, which an ideal estimator cannot tell apart for one circle, every one "
      "counts as in the thesis, then the likelier one alone. The marker of this project gives one pose.");
  addComparisons(experiment, data, document);
  addFigures(figuresOfLines(experiment, data), document);
}

void addCells(const Experiment &experiment, const RunData &data, Document &document)
{
  document.addHeading(experiment.title);
  document.addParagraph(
      "Depth even from 0.36 m, angle between normal and line of sight even from 0, image position, direction of the "
      "tilt and spin random; the whole sheet is in the image. The thesis counts every estimate, two of each ellipse: "
      "so does the first column of the plain ring; the others count one pose for each marker found. Errors are over "
      "the frames in which the method found its marker.");
  addOverview("All cells", experiment, data, viewsIn(data, thesisViews), document);
  addComparisons(experiment, data, document);
  addFigures(figuresOfCells(experiment, data), document);
}

void addResilience(const Experiment &experiment, const RunData &data, Document &document)
{
  document.addHeading(experiment.title);
  document.addParagraph(
      "The thesis left this open (6.2.3). The same poses, 1 m to 8 m and up to 60°, at every level of every "
      "disturbance (other places in the image for distorted cameras). AprilTag 36h11 by ViSP's detector at decimation "
      "1 with its "
      "half pixel corrected, on a sheet of the same size. Occlusion: all beyond a line across the ring's disc is "
      "covered, in a random direction and grey level; " +
      outlineShares() + " Light: a gradient in a random direction. Distortion: the detector knows the camera.");
  const std::vector<View> views = viewsIn(data, {ringFirst, circle, aprilTag});
  std::vector<std::string> titles = {"", "frames"};
  for (const View &view : views) {
    titles.push_back(std::string(view.title) + ": found % / median |C - eC| mm / median angle ° / misleading %");
  }
  std::vector<std::vector<std::string>> table;
  for (std::size_t i = 0; i < experiment.series.size(); ++i) {
    std::vector<std::string> row = {experiment.series[i].title,
                                    std::to_string(samplesOf(data[i], Method::Circle).size())};
    for (const View &view : views) {
      const Summary s = summaryOf(samplesOf(data[i], view.method), view.solutions);
      row.push_back(percent(s.found, s.frames) + " / " + digits(s.position.median) + " / " + digits(s.angle.median) +
                    " / " + percent(s.wrong, s.frames));
    }
    table.push_back(row);
  }
  addFigures(figuresOfResilience(experiment, data), document);
  document.addTable("All levels", titles, table);
}
} // namespace experiments
