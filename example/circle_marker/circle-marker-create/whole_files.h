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
 * Files that appear whole or not at all.
 */

#ifndef VP_CREATE_WHOLE_FILES_H
#define VP_CREATE_WHOLE_FILES_H

#include <string>
#include <utility>
#include <vector>

namespace create {
/*!
  Writes a set of files beside their final names and gives them these names only when all are written. If anything
  fails before, the destructor removes what was written.
*/
class WholeFiles
{
public:
  WholeFiles() = default;
  WholeFiles(const WholeFiles &) = delete;
  WholeFiles &operator=(const WholeFiles &) = delete;
  ~WholeFiles();

  /*!
    Writes a file under a temporary name in the folder of its final name.
    \exception std::runtime_error : If it cannot be written: what failed and why.
  */
  void add(const std::string &path, const std::string &content);

  /*!
    Gives all files their final names, replacing older ones.
    \exception std::runtime_error : If a file cannot be renamed.
  */
  void commit();

private:
  std::vector<std::pair<std::string, std::string>> m_files; //!< Temporary and final names of those not renamed yet.
};
} // namespace create

#endif
