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
 * A marker of an outline, whole or with something in front of a part of it.
 */

#ifndef VP_CIRCLE_MARKER_DETECT_COVERED_H
#define VP_CIRCLE_MARKER_DETECT_COVERED_H

#include <cstddef>
#include <optional>
#include <vector>

#include "decode/recognise.h"
#include "refine/measure.h"

BEGIN_VISP_NAMESPACE
namespace circle_marker {
/*!
  Recognises a marker that something covers in part: with a part of its outline missing the poses are not good enough
  for its code, so its ring is measured before.
  \param I : The image.
  \param camera : Its camera.
  \param ring : Its ring, by recogniseCoveredRing().
  \param family : What to recognise it as.
  \param settings : How strictly a code is read.
  \param memory : Working memory of the measurement.
  \param deadline : When to stop: it is none then.
  \param noise : Noise of the image; by default pixels share none.
  \return The marker; nothing if it is none.
*/
std::optional<Recognition> recogniseByMeasuredRing(const vpImage<unsigned char> &I, const CameraModel &camera,
                                                   const Recognition &ring, const vpCircleMarkerFamily &family,
                                                   const DecodeSettings &settings, MeasureMemory &memory,
                                                   const Deadline &deadline = Deadline(),
                                                   const ImageNoise &noise = ImageNoise());

/*! How an outline is read. */
enum class ReadingKind
{
  WHOLE,     //!< As a marker of which nothing is covered, sector by sector.
  UNCERTAIN, //!< With sectors so small that the code is proven when the marker is measured.
  COVERED    //!< With something in front of a part of it.
};

/*! What the image says of a marker that was read as a whole one, at its measured pose. */
enum class WholeVerdict
{
  RIGHT,    //!< It shows what the codeword says.
  COVERED,  //!< Something covers a part of it, which is in the fit: it should be left out.
  DOUBTFUL, //!< The fit left out so many pixels that they may show something else: another reading has to agree.
  WRONG     //!< It shows something else.
};

/*!
  Whether the image shows what a codeword says that was read with corrections, or a part of whose outline is missing,
  or of which the fit leaves more than noise or leaves out too many pixels (without corrections this is not asked
  under a shadow that the fit explains): at the measured pose, most pixels of the code track have the grey level that
  it gives them. What each of them may be off grows with their noise, up to where they tell nothing; of markers too
  small for a pixel to show one sector alone no more is asked.
  \param I : The image.
  \param camera : Its camera.
  \param noise : Standard deviation of the image's noise, grey levels.
  \param support : Share of the outline that is found.
  \param marker : The marker, as it was read.
  \param measurement : Its measured pose.
  \param memory : Working memory.
*/
WholeVerdict judgeWhole(const vpImage<unsigned char> &I, const CameraModel &camera, double noise, double support,
                        const Recognition &marker, const Measurement &measurement, MeasureMemory &memory);

/*!
  Whether a marker that cannot be read as a covered one is what it was read as, though something seems to cover it: its
  codeword is the likeliest by far for what is seen; or it is only doubtful, and the image is like it.
  \param I, camera : Image and camera.
  \param marker, measurement : The marker, as it was read, and its measured pose.
  \param verdict : That of judgeWhole().
  \param memory : Working memory.
*/
bool isRightThoughCovered(const vpImage<unsigned char> &I, const CameraModel &camera, const Recognition &marker,
                          const Measurement &measurement, WholeVerdict verdict, MeasureMemory &memory);

/*!
  Whether the code track shows another code in plain sight, though by what the fit left out it was taken for this one
  with something in front: at the measured pose its pixels are ink where the codeword has white and paper where it has
  black, between ring and centre as they should be. Asked of covered markers, and of others if pixels were left out or
  sectors corrected.
  \param I, camera : Image and camera.
  \param marker : The marker. Of a covered one the sectors in plain sight that are mostly of the other colour count as
  corrected from then on: hardly anything that covers a track ends at the borders of its sectors.
  \param measurement : Of the marker.
  \param maximumHamming : Most sectors that may be corrected; of a covered marker in proportion to its code's capacity.
  \param memory : Working memory.
*/
bool showsOtherCode(const vpImage<unsigned char> &I, const CameraModel &camera, Recognition &marker,
                    const Measurement &measurement, unsigned int maximumHamming, MeasureMemory &memory);

/*!
  A marker that was read as a whole one although something covers a part of it, to be measured again without that: its
  parts that are not seen are those that the measured ring and its codeword do not explain.
  \param I : The image.
  \param camera : Its camera.
  \param marker : The marker, as it was read.
  \param measurement : Its measured pose.
  \param memory : Working memory.
  \return Nothing if all of it is seen, as far as can be told.
*/
std::optional<Recognition> withoutWhatCovers(const vpImage<unsigned char> &I, const CameraModel &camera,
                                             const Recognition &marker, const Measurement &measurement,
                                             MeasureMemory &memory);

/*! One of the ways to read an outline. */
struct Attempt
{
  std::size_t family; //!< Index of the family.
  ReadingKind kind;   //!< How to read it.
};

/*!
  The ways to read an outline, in the order in which they are tried: family by family; where several with a code follow
  each other, as whole markers of all of them, for certain and then not, before as covered ones. What is seen of a
  covered marker is little enough to be taken for that of another family.
  \param families : The families that are sought.
  \param attempts : The result; its memory is used again.
*/
void listAttempts(const std::vector<vpCircleMarkerFamily> &families, std::vector<Attempt> &attempts);
} // namespace circle_marker
END_VISP_NAMESPACE

#endif
