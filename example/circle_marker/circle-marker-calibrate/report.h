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
 * Results of a calibration: table, JSON, picture.
 */

#ifndef VP_CALIBRATE_REPORT_H
#define VP_CALIBRATE_REPORT_H

#include <optional>
#include <string>
#include <vector>

#include "solve.h"
#include "visp_peer.h"

namespace calibrate {
/*! All about one model. */
struct ModelReport
{
  LensModel model = LensModel::Plain;
  Calibration calibration;                //!< With the circles' true centres.
  std::optional<Calibration> byEllipses;  //!< With the ellipses' centres in their place; for circles.
  std::optional<VispCalibration> visp;    //!< ViSP's on the same points.
  std::optional<VispCalibration> vispOwn; //!< ViSP's on the points that its own example takes.
  std::vector<std::string> problems;      //!< Why it is not to be used.
  std::vector<std::string> remarks;
};

struct Report
{
  Target target;
  unsigned int width = 0;
  unsigned int height = 0;
  std::size_t pictures = 0;  //!< Those without the target as well.
  std::optional<Lens> truth; //!< If the camera was simulated.
  std::vector<ModelReport> models;
};

/*! What a person wants to know. */
std::string tableOf(const Report &report);

/*! All numbers. */
std::string jsonOf(const Report &report);

/*! Residuals as arrows where they are in the image, and in a diagram, for each model; SVG. */
std::string residualPicture(const Report &report);

/*!
  \return Errors of a lens against the true one, in standard deviations: each number, and in the end the root of the
  mean of the squares of all numbers with their correlations. Empty: the models differ.
*/
std::vector<double> errorsInSigmas(const Adjustment &adjustment, const Lens &truth);
} // namespace calibrate

#endif
