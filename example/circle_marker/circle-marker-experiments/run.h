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
 * Runs an experiment: makes the frames that are missing, and keeps them.
 */

#ifndef VP_EXPERIMENTS_RUN_H
#define VP_EXPERIMENTS_RUN_H

#include "common/parallel.h"
#include "run_data.h"

namespace experiments {
/*! Called now and then with all that is done so far, by one thread at a time. */
using Keep = std::function<void(const RunData &data)>;

/*!
  Makes the frames that are missing in the data. Which thread makes a frame changes nothing but its CPU time.

  \e keep: Called at intervals that grow with the time it takes, so that it costs no more than a few per cent.
  \exception DataError : If frames that are there cannot be made again: another version made them.
*/
void completeRun(const Experiment &experiment, const Settings &settings, const Progress &progress, const Keep &keep,
                 RunData &data);
} // namespace experiments

#endif
