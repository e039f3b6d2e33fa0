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
 * The ratios to other detectors, how many markers are found, and how many are found that are not there.
 */

#ifndef VP_BENCH_TABLES_H
#define VP_BENCH_TABLES_H

#include <cstdint>
#include <ostream>
#include <string>

#include "hardships.h"

namespace bench {
/*!
  CPU time of the whole detection on frames of 1280 x 960 pixels, beside that of the others, all in turn on the same
  frames; the table gives the medians and the median of the ratios.
  \param out : Where the table goes, Markdown.
  \param rounds : How often each looks at each frame.
*/
void tellRatios(std::ostream &out, unsigned int rounds);

/*!
  Share of the markers that are found and rightly read, by the minor axis of the ring's image; 20 markers of 17 to 60
  pixels a frame, tilts to 75 degrees, noise of 2 grey levels, half of the frames cluttered.
  \param out : Where the table goes, Markdown.
  \param family : Name of the markers' family.
  \param frames : How many.
  \param seed : Of the frames.
  \param overlays : Folder for the frames with a wrong id or a marker where none is, or empty.
*/
void tellReach(std::ostream &out, const std::string &family, unsigned int frames, std::uint64_t seed,
               const std::string &overlays);

/*! What is asked of tellHardships(). */
struct HardshipOptions
{
  std::string family;                       //!< Name of the markers' family.
  unsigned int frames = 1;                  //!< How many of each hardship.
  std::uint64_t seed = 1;                   //!< Of the frames.
  HardMarkers markers = HardMarkers::USUAL; //!< How large they are, in which light.
  bool refine = true;                       //!< Whether poses are refined.
  std::string only;                         //!< Name of the hardship to be looked at; empty for all.
  //! Folder to write the frames to whose marker was not found or wrongly read, these as *-other.png; empty for none.
  std::string pictures;
};

/*!
  Share of the markers that are found and rightly read where something covers a part of them or the picture is bad, how
  the errors of their poses compare with the covariances (squared Mahalanobis distance by degrees of freedom), and how
  often the visible share of the outline is told wrong by more than 0.1. One marker a frame, tilts to 60 degrees, on
  clutter.
  \param out : Where the table goes, Markdown.
  \param options : What is asked.
  \exception std::invalid_argument If no hardship has the name that is asked for.
*/
void tellHardships(std::ostream &out, const HardshipOptions &options);

/*!
  How long after its timeout the detector comes back, on the hard images at 1280 x 960: the greatest wall time, and CPU
  time, beyond the timeout of all calls with timeouts from 1 to 220 ms.
  \param out : Where the table goes, Markdown.
  \param rounds : How often each image is looked at with each timeout.
*/
void tellTimeouts(std::ostream &out, unsigned int rounds);

/*!
  Markers found in images that have none: clutter with noise, other systems' signs, and the hard images; each coded
  marker, and a table. The upper bound of the rate at 95 % is that of Clopper and Pearson (1934).
  \param out : Where the table goes, Markdown.
  \param images : How many.
  \param seed : Of the images.
  \param only : Part of the names of the kinds to be looked at; empty for all.
  \param overlays : Folder for pictures of the coded markers found, or empty.
*/
void tellPhantoms(std::ostream &out, unsigned int images, std::uint64_t seed, const std::string &only,
                  const std::string &overlays);

/*!
  Markers of one family of codes that are found where another's are sought: frames of 20 of 30 to 160 pixels, tilts to
  60 degrees, half of them in any light. Each that is found, and a table with the upper bound of the rate at 95 %.
  \param out : Where they go, Markdown.
  \param frames : How many of each two families.
  \param seed : Of the frames.
*/
void tellOtherFamilies(std::ostream &out, unsigned int frames, std::uint64_t seed);

/*!
  Markers found in the pictures of a folder and the folders in it, which are taken to have none: each, and a table.
  \param out : Where they go.
  \param folder : Such as that of ViSP's data set.
  \param overlays : Folder for pictures of the rings found, or empty.
*/
void tellPhotographs(std::ostream &out, const std::string &folder, const std::string &overlays);
} // namespace bench

#endif
