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
 * The samples of an experiment, as far as it has come, and the file that keeps them.
 */

#ifndef VP_EXPERIMENTS_RUN_DATA_H
#define VP_EXPERIMENTS_RUN_DATA_H

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "experiment.h"
#include "sample.h"

namespace experiments {
/*! Samples by series and frame; a frame that is not done yet is empty. */
using RunData = std::vector<std::vector<std::optional<FrameSamples>>>;

/*! Data that cannot be used: which, why, and what to do. */
class DataError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/*! Name of an experiment's file of data. */
std::string dataFileOf(const Experiment &experiment);

/*! Nothing done, room for all frames. */
RunData emptyData(const Experiment &experiment);

/*! Frames done. */
std::size_t framesDone(const RunData &data);

/*!
  The data as a table (CSV), after lines that begin with # and tell seed, version, settings and columns. A row for each
  frame and method, by series and frame; the last column is time.
*/
std::string csvOf(const Experiment &experiment, const Settings &settings, const RunData &data);

/*!
  Reads such a table. It may hold fewer or more frames than the experiment asks for: all are kept.
  \exception DataError : If it is of other settings or another version, or not such a table.
*/
RunData dataFrom(const std::string &csv, const std::string &file, const Experiment &experiment,
                 const Settings &settings);

/*!
  The settings that made a table: seed, size, noise, blur and ranges; all else is taken from \e given.
  \exception DataError : If it is not such a table.
*/
Settings settingsFrom(const std::string &csv, const std::string &file, const Settings &given);
} // namespace experiments

#endif
