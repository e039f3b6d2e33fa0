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
 * The tables of circle-marker-accuracy: for the standard output and for the page.
 */

#ifndef VP_ACCURACY_TABLES_H
#define VP_ACCURACY_TABLES_H

#include <string>
#include <vector>

#include "summary.h"

namespace accuracy {
/*! A table of text: each row has as many cells as there are titles. */
struct Table
{
  std::string caption;
  std::vector<std::string> titles;
  std::vector<std::vector<std::string>> rows;
};

/*! The tables of those parts of which there are records, in their order. */
std::vector<Table> tablesOf(const Records &records);

/*! One target of the project, and what was measured. */
struct Check
{
  std::string target; //!< What is asked for.
  std::string where;  //!< Group and range.
  double value;       //!< Measured.
  double least, most; //!< Where it should be.
  std::size_t frames; //!< Images it was measured on.
  double error;       //!< Standard error of the value: what the number of images leaves open.

  /*! Whether it is off by more than two standard errors. */
  bool isClear() const { return value + 2. * error < least || value - 2. * error > most; }
  bool isMet() const { return value >= least && value <= most; } // Not a number is not met.
};

/*! All targets that can be judged from the records. */
std::vector<Check> checksOf(const Records &records);

/*! The checks that are not met, as a table. */
Table missesOf(const std::vector<Check> &checks);

/*! A table in columns of spaces. */
std::string textOf(const Table &table);
} // namespace accuracy

#endif
