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
 * The experiments by their names.
 */

#include <algorithm>
#include <stdexcept>

#include "experiment.h"

namespace experiments {
namespace {
struct Entry
{
  std::string name;
  Experiment (*make)(const Settings &);
};

const std::vector<Entry> &entries()
{
  static const std::vector<Entry> list = {{"2", experimentOfLines},
                                          {"3", experimentOfCells},
                                          {"resilience", experimentOfResilience},
                                          {"requirements", experimentOfRequirements},
                                          {"design", experimentOfDesign}};
  return list;
}
} // namespace

std::vector<Method> methodsOf(const Series &series, std::size_t frame)
{
  constexpr std::size_t boundStep = 5;
  std::vector<Method> methods = series.methods;
  if (frame / series.kinds % boundStep != 0) {
    methods.erase(std::remove_if(methods.begin(), methods.end(),
                                 [](Method method) { return method == Method::Bound || method == Method::Limit; }),
                  methods.end());
  }
  return methods;
}

const std::vector<std::string> &experimentNames()
{
  static const std::vector<std::string> names = []() {
    std::vector<std::string> result;
    for (const Entry &entry : entries()) {
      result.push_back(entry.name);
    }
    return result;
  }();
  return names;
}

Experiment experimentNamed(const std::string &name, const Settings &settings)
{
  for (const Entry &entry : entries()) {
    if (entry.name == name) {
      return entry.make(settings);
    }
  }
  throw std::invalid_argument("there is no experiment \"" + name + "\"");
}

vpScenePhotometry photometryOf(const Settings &settings)
{
  vpScenePhotometry photometry;
  photometry.noiseSigma = settings.noise;
  photometry.blurSigma = settings.blur;
  return photometry;
}
} // namespace experiments
