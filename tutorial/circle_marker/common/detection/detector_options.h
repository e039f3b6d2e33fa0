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
 * Options of the detector that several programs take.
 */

#ifndef VP_TUTORIAL_DETECTOR_OPTIONS_H
#define VP_TUTORIAL_DETECTOR_OPTIONS_H

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <visp3/circle_marker/vpCircleMarkerFamily.h>
#include <visp3/circle_marker/vpDetectorCircleMarker.h>

#include "../visp_names.h"

namespace CLI {
class App;
} // namespace CLI

namespace tutorial {
/*! What to look for, and how. */
struct DetectorSettings
{
  double size = 0.;                           //!< Outer diameter of the ring, metres.
  std::map<int, double> sizes;                //!< Diameters of single markers, metres, by id.
  std::string databaseFile;                   //!< What is known of the markers; empty: nothing.
  std::string configFile;                     //!< Settings of the detector; empty: none.
  std::vector<vpCircleMarkerFamily> families; //!< Families to look for; empty: those of the settings.
  std::optional<unsigned int> hamming;        //!< Most sectors to be corrected.
  std::optional<unsigned int> threads;        //!< Number of threads.
  std::optional<unsigned int> tracking;       //!< Every so many images the whole one is searched.
  int timeout = 0;                            //!< Longest search of an image, milliseconds; 0: for ever.
};

/*! The options as they were written; lives as long as the CLI::App that fills it. */
struct DetectorOptions
{
  double size = 0.;
  std::string sizes;
  std::optional<std::string> families;
  std::optional<double> ratio;
  std::string configFile;
  std::string databaseFile;
  std::optional<unsigned int> hamming;
  std::optional<unsigned int> threads;
  std::optional<unsigned int> tracking;

  /*! Adds --size, --sizes, --family, --ratio, --hamming, --config, --database, --nthreads and --tracking to a program.
   */
  void addTo(CLI::App &app);

  /*!
    \return What the options mean; to be called after they were read.
    \exception UsageError : If they cannot be used.
  */
  DetectorSettings settings() const;
};

/*!
  \return A detector for these settings, z into the markers.
  \exception vpException : If the file of settings cannot be used.
  \exception UsageError : If a marker has a size that no family has.
*/
vpDetectorCircleMarker makeDetector(const DetectorSettings &settings);

/*! \return The parts of a list with commas. */
std::vector<std::string> splitAtCommas(const std::string &text);
} // namespace tutorial

#endif
