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
 * The ways from an image to a pose that the experiments compare.
 */

#ifndef VP_EXPERIMENTS_METHOD_H
#define VP_EXPERIMENTS_METHOD_H

#include <array>
#include <cstddef>
#include <optional>
#include <string>

namespace experiments {
enum class Method
{
  Ring,     //!< A plain ring without a code: both solutions.
  Circle,   //!< The marker of this project: one pose.
  AprilTag, //!< ViSP's detector at decimation 1, corrected by half a pixel.
  Bound,    //!< No detector: errors drawn from the Cramer-Rao bound of the marker of this project.
  Limit     //!< No detector: the bound's standard deviations, and as log-odds the mean ones between the two poses.
};

constexpr std::size_t methodCount = 5;

/*! Names in files. */
constexpr std::array<const char *, methodCount> methodNames = {"ring", "golay23", "apriltag", "bound", "limit"};
/*! Names for people. */
constexpr std::array<const char *, methodCount> methodTitles = {"plain ring", "circular marker", "AprilTag", "bound",
                                                                "limit"};

inline std::string nameOf(Method method)
{
  return methodNames[static_cast<std::size_t>(method)];
}

inline std::string titleOf(Method method)
{
  return methodTitles[static_cast<std::size_t>(method)];
}

/*! The method of a name in a file, if there is one. */
inline std::optional<Method> methodNamed(const std::string &name)
{
  for (std::size_t i = 0; i < methodCount; ++i) {
    if (name == methodNames[i]) {
      return static_cast<Method>(i);
    }
  }
  return std::nullopt;
}

constexpr const char *codedFamily = "golay23"; //!< The marker of this project.
constexpr int codedIds = 178;                  //!< Markers of that family.
constexpr double thesisRingRatio = 0.7;        //!< Inner over outer diameter of the thesis's marker (figure 4.1).
} // namespace experiments

#endif
