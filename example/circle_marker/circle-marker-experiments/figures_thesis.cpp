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
 * Figures that the thesis has of both of its simulated experiments.
 */

#include "curves.h"
#include "figures_thesis.h"

namespace experiments {
Figure cloudFigure(const std::string &file, unsigned int columns, const Experiment &experiment, const RunData &data)
{
  Figure figure = {file, "True and estimated centres, seen from above", columns, {}};
  for (std::size_t i = 0; i < experiment.series.size(); ++i) {
    const std::vector<Sample> rings = samplesOf(data[i], Method::Ring);
    const std::vector<Sample> circles = samplesOf(data[i], Method::Circle);
    figure.panels.push_back(
        {experiment.series[i].title,
         "x [m]",
         "z [m]",
         "set xrange [*<-1:1<*]\n", // A single line has no width of its own.
         {trueCentres(circles), estimatedCentres(rings, ringBoth), estimatedCentres(circles, circle)}});
  }
  return figure;
}

Figure depthFigure(const DepthPlot &plot, unsigned int columns, const Experiment &experiment, const RunData &data)
{
  const auto depth = [](const Sample &sample) { return sample.z; };
  Figure figure = {plot.file, plot.title, columns, {}};
  for (std::size_t i = 0; i < experiment.series.size(); ++i) {
    figure.panels.push_back({experiment.series[i].title,
                             "Cz [m]",
                             plot.yLabel,
                             plot.setup,
                             {estimates(samplesOf(data[i], Method::Ring), ringBoth, depth, plot.y),
                              estimates(samplesOf(data[i], Method::Circle), circle, depth, plot.y)}});
  }
  if (plot.setup == logarithmicY) {
    shareDecades(figure);
  }
  return figure;
}

DepthPlot estimatedDepth(const std::string &file)
{
  constexpr double metres = 1e-3; // In a millimetre.
  return {file, "Estimated depth against true depth", "eCz [m]", "",
          [](const Sample &sample, const Deviation &deviation) { return sample.z + metres * deviation.dz; }};
}
} // namespace experiments
