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
 * The part of the report that is of a recording: the thesis's experiment 1.
 */

#ifndef VP_EXPERIMENTS_REPORT_RECORDING_H
#define VP_EXPERIMENTS_REPORT_RECORDING_H

#include "common/document.h"
#include "figures.h"
#include "recording.h"

namespace experiments {
/*! The tables of the thesis's section 5.3, with spread and consistency besides. */
void addRecording(const Recording &recording, Document &document);

/*! Figures 5.2 and 5.3: the estimates at each station, with the ellipses of two standard deviations. */
std::vector<CaptionedFigure> figuresOfRecording(const Recording &recording);

/*! The estimates as a table (CSV), a row for each image. */
std::string csvOf(const Recording &recording);
} // namespace experiments

#endif
