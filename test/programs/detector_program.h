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
 * Running tutorial-circle-marker-detector on the pictures of the data folder.
 */

#ifndef VP_TEST_DETECTOR_PROGRAM_H
#define VP_TEST_DETECTOR_PROGRAM_H

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "json_lines.h"
#include "run_program.h"

namespace detector_program_test {
using Json = nlohmann::json;
using test::linesOf;

inline const std::string data = CIRCLE_MARKER_DATA_DIR;
inline const std::string referencePicture = data + "/pictures/golay23-id5.png";
inline const std::string widePicture = data + "/pictures/wide-families.png";

/*! Arguments for pictures of the reference camera. */
inline std::vector<std::string> reference(const std::string &input, const std::vector<std::string> &more = {})
{
  std::vector<std::string> arguments = {"--input", input,    "--intrinsic", data + "/camera.xml", "--camera-name",
                                        "Camera",  "--size", "0.18",        "--display-off"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

/*! Arguments for pictures of the camera with distortion. */
inline std::vector<std::string> wide(const std::string &input, const std::vector<std::string> &more = {})
{
  std::vector<std::string> arguments = {"--input",       input,  "--intrinsic", data + "/pictures/camera-wide.xml",
                                        "--camera-name", "Wide", "--size",      "0.18",
                                        "--display-off"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}
} // namespace detector_program_test

#endif
